#include "materials/index/index_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "spectral/support/error.h"

namespace karat {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCatalogue = "catalog-nk.yml";

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

// SHELF/BOOK/PAGE -> SHELF/BOOK/nk/PAGE.yml, where a third of the database's tables lie; "" for a
// name that is not an id.
std::string usual_path(const std::string& id) {
  if (std::count(id.begin(), id.end(), '/') != 2) return "";
  const std::size_t last = id.rfind('/');
  return id.substr(0, last) + "/nk" + id.substr(last) + ".yml";
}

// The inverse: the id of a path that is laid out as usual_path says, otherwise the path.
std::string name_of(const std::string& path) {
  const std::size_t nk = path.find("/nk/");
  if (nk == std::string::npos || !path.ends_with(".yml")) return path;
  const std::string id = path.substr(0, nk) + path.substr(nk + 3, path.size() - nk - 7);
  return usual_path(id) == path ? id : path;
}

// A name may not lead out of its folder.
bool stays_inside(const fs::path& relative) {
  return !relative.empty() && relative.is_relative() &&
         std::find(relative.begin(), relative.end(), "..") == relative.end();
}

}  // namespace

IndexFolder::IndexFolder(fs::path folder) : folder_(std::move(folder)), root_(folder_) {
  std::error_code ignored;
  if (fs::is_directory(folder_ / "data", ignored)) root_ = folder_ / "data";
}

std::optional<std::string> IndexFolder::existing(const std::string& relative) const {
  if (!stays_inside(relative) || !is_file(root_ / relative)) return std::nullopt;
  return (root_ / relative).string();
}

std::optional<std::string> IndexFolder::find(const std::string& name) const {
  if (name.ends_with(".yml")) return existing(name);
  if (auto file = existing(usual_path(name))) return file;
  const auto& paths = catalogue().paths;
  const auto found = paths.find(name);
  if (found == paths.end()) return std::nullopt;
  if (found->second.size() > 1) {
    std::string list;
    for (const std::string& path : found->second)
      list += (list.empty() ? "\"" : ", \"") + path + "\"";
    throw InputError((folder_ / kCatalogue).string(), "",
                     fmt::format("\"{}\" stands for {} tables; name one by its path: {}", name,
                                 found->second.size(), list));
  }
  return existing(found->second.front());
}

std::map<std::string, std::string> IndexFolder::list() const {
  std::map<std::string, std::string> id_of_path;
  for (const std::string& id : catalogue().ids) {
    const auto& paths = catalogue().paths.at(id);
    const bool own_shelf = paths.front().starts_with(id.substr(0, id.find('/') + 1));
    // find() takes the usual path of an id first: the catalogue gives some ids another table's
    // file.
    const std::string usual = usual_path(id);
    const bool taken = usual != paths.front() && existing(usual).has_value();
    if (paths.size() == 1 && own_shelf && !taken) id_of_path.emplace(paths.front(), id);
  }
  std::map<std::string, std::string> tables;
  std::error_code error;
  for (fs::recursive_directory_iterator it(root_, error), end; !error && it != end;
       it.increment(error)) {
    const fs::path& file = it->path();
    const std::string folder = file.parent_path().filename().string();
    if (file.extension() != ".yml" || !it->is_regular_file(error)) continue;
    if (file.filename() == kCatalogue || file.filename() == "about.yml" || folder == "n2") continue;
    const std::string relative = file.lexically_relative(root_).generic_string();
    const auto id = id_of_path.find(relative);
    tables.emplace(id != id_of_path.end() ? id->second : name_of(relative), file.string());
  }
  return tables;
}

const IndexFolder::Catalogue& IndexFolder::catalogue() const {
  std::call_once(once_, [this] { catalogue_ = read_catalogue(); });
  return catalogue_;
}

IndexFolder::Catalogue IndexFolder::read_catalogue() const {
  Catalogue result;
  result.file = read_index_catalogue((folder_ / kCatalogue).string());
  for (const CataloguePage& page : result.file.pages) {
    auto& paths = result.paths[page.id];
    if (paths.empty()) result.ids.push_back(page.id);
    if (std::find(paths.begin(), paths.end(), page.path) == paths.end()) paths.push_back(page.path);
  }
  return result;
}

}  // namespace karat
