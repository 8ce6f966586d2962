#include "materials/index/index_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <sstream>

#include "materials/index/index_folder.h"
#include "spectral/support/data_path.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

namespace fs = std::filesystem;

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

[[noreturn]] void bad_name(const std::string& name, const std::string& why) {
  throw InputError(fmt::format(
      "a table cannot be called \"{}\": {}; a name is SHELF/BOOK/PAGE, such as my/gold/film, of "
      "letters, digits and . _ - + = ( ) %",
      name, why));
}

bool allowed(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return std::isalnum(byte) || byte >= 0x80 || std::string("._-+=()%").find(c) != std::string::npos;
}

void check_part(const std::string& name, const std::string& part) {
  constexpr std::size_t kLongest = 100;
  if (part.empty()) bad_name(name, "a part is empty");
  if (part.size() > kLongest) bad_name(name, "a part has more than 100 bytes");
  if (part.front() == '.' || part.front() == '-') {
    bad_name(name, fmt::format("\"{}\" begins with \"{}\"", part, part.front()));
  }
  const auto wrong = std::find_if_not(part.begin(), part.end(), allowed);
  if (wrong != part.end()) {
    const bool shown = std::isprint(static_cast<unsigned char>(*wrong)) != 0;
    bad_name(name, shown ? fmt::format("\"{}\" is not allowed", *wrong)
                         : "a control character is not allowed");
  }
}

}  // namespace

bool IndexPathEntry::exists() const {
  std::error_code ignored;
  return fs::is_directory(folder, ignored);
}

fs::path user_index_folder() {
  const std::string data = variable("XDG_DATA_HOME");
  if (!data.empty()) return fs::path(data) / "karat/nk";
  const std::string home = variable("HOME");
  return home.empty() ? fs::path() : fs::path(home) / ".local/share/karat/nk";
}

std::vector<IndexPathEntry> index_path() {
  using Kind = IndexPathEntry::Kind;
  std::vector<IndexPathEntry> entries{{data_path("nk"), Kind::kProject}};
  const fs::path user = user_index_folder();
  if (!user.empty()) entries.push_back({user, Kind::kUser});
  std::istringstream path(variable("KARAT_NK_PATH"));
  for (std::string folder; std::getline(path, folder, ':');) {
    if (!folder.empty()) entries.push_back({folder, Kind::kVariable});
  }
  return entries;
}

fs::path user_index_file(const std::string& name) {
  std::vector<std::string> parts{""};
  for (const char c : name) {
    if (c == '/') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  if (parts.size() != 3) bad_name(name, "it has not three parts");
  for (const std::string& part : parts) check_part(name, part);
  if (parts[0] == "data") bad_name(name, "the shelf \"data\" is where a database keeps all others");
  if (parts[2].ends_with(".yml")) bad_name(name, "\".yml\" is added by itself");
  const fs::path folder = user_index_folder();
  if (folder.empty()) {
    throw RuntimeError("no folder for your tables: neither XDG_DATA_HOME nor HOME is set");
  }
  return IndexFolder(folder).root() / parts[0] / parts[1] / "nk" / (parts[2] + ".yml");
}

std::optional<std::string> find_index_file(const std::string& name, IndexPathEntry::Kind kind) {
  for (const IndexPathEntry& entry : index_path()) {
    if (entry.kind != kind || !entry.exists()) continue;
    if (auto file = IndexFolder(entry.folder).find(name)) return file;
  }
  return std::nullopt;
}

}  // namespace karat
