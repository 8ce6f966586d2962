#include "render/replace_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <system_error>

#include "spectral/support/error.h"

namespace karat {
namespace {

namespace fs = std::filesystem;

fs::path temporary_beside(const fs::path& target) {
  return target.parent_path() / fmt::format(".{}.{}.tmp", target.filename().string(), ::getpid());
}

void require_replaceable(const std::string& path, const fs::path& target) {
  std::error_code error;
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (target.filename().empty()) throw RuntimeError("cannot write \"" + path + "\": no file name");
  if (!fs::exists(folder, error)) {
    throw RuntimeError("cannot write \"" + path + "\": there is no folder " + folder.string());
  }
  if (!fs::is_directory(folder, error)) {
    throw RuntimeError("cannot write \"" + path + "\": " + folder.string() + " is not a folder");
  }
  const auto status = fs::status(target, error);
  if (fs::is_directory(status)) throw RuntimeError("cannot write \"" + path + "\": it is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    throw RuntimeError("cannot write \"" + path + "\": it is a device or pipe, not a file");
  }
}

}  // namespace

fs::path file_behind(const std::string& path) {
  constexpr int kMostLinks = 40;
  std::error_code ignored;  // what is not there is no link
  fs::path target = fs::absolute(path, ignored);
  for (int i = 0; i < kMostLinks && fs::is_symlink(target, ignored); ++i) {
    target = target.parent_path() / fs::read_symlink(target, ignored);
  }
  return target.empty() ? fs::path(path) : target;
}

bool same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  const fs::path first = fs::weakly_canonical(file_behind(a), error);
  return !error && first == fs::weakly_canonical(file_behind(b), error) && !error;
}

void check_writable(const std::string& path) {
  const fs::path target = file_behind(path);
  require_replaceable(path, target);
  // Permissions alone do not tell (read-only file systems, the superuser): try.
  const fs::path temporary = temporary_beside(target);
  const bool created = std::ofstream(temporary, std::ios::binary).is_open();
  std::error_code ignored;
  fs::remove(temporary, ignored);
  if (!created) {
    throw RuntimeError("cannot write \"" + path + "\": no permission to create files in " +
                       target.parent_path().string());
  }
}

void replace_file(const std::string& path, const std::function<void(const std::string&)>& write) {
  const fs::path target = file_behind(path);
  require_replaceable(path, target);
  const fs::path temporary = temporary_beside(target);
  std::error_code error;
  try {
    write(temporary.string());
    fs::rename(temporary, target, error);
    if (error) throw RuntimeError(error.message());
  } catch (const std::exception& failure) {
    fs::remove(temporary, error);
    throw RuntimeError("cannot write \"" + path + "\": " + failure.what());
  }
}

}  // namespace karat
