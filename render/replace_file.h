// Files that are either whole or not there: written beside their place, then renamed.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace karat {

// Throws RuntimeError, saying why, when a file could not be written at `path`: the folder is
// missing or not writable, or `path` is itself a folder or a device. Creates nothing that stays.
void check_writable(const std::string& path);

// The absolute path that a name leads to: symbolic links are followed, also to what is not there
// yet. replace_file() replaces or creates that file and keeps the links.
std::filesystem::path file_behind(const std::string& path);

// Whether two names mean one file, also through links, and of files that are not there yet.
bool same_file(const std::string& a, const std::string& b);

// Calls `write` with a temporary name beside `path`, then renames to `path`. When anything throws,
// the temporary file is removed and what stood at `path` is untouched. Throws RuntimeError.
void replace_file(const std::string& path, const std::function<void(const std::string&)>& write);

}  // namespace karat
