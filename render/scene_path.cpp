#include "render/scene_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "spectral/support/error.h"

namespace karat {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> places_of(const std::string& path, const ReadContext& context) {
  std::vector<fs::path> places;
  for (const fs::path& candidate : {fs::path(context.directory) / path, fs::path(path)}) {
    std::error_code error;
    const fs::path place = fs::absolute(candidate, error).lexically_normal();
    if (error || std::find(places.begin(), places.end(), place) != places.end()) continue;
    places.push_back(place);
  }
  return places;
}

// The file of the same folder whose name is nearest, as the scene would have to write it.
std::string nearest_file(const fs::path& wanted, const std::string& path) {
  constexpr std::size_t kMostSeen = 10'000;
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator it(wanted.parent_path(), error), end; !error && it != end;
       it.increment(error)) {
    if (names.size() == kMostSeen) break;
    names.push_back(it->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  const std::string near = nearest_name(wanted.filename().string(), names);
  return near.empty() ? "" : (fs::path(path).parent_path() / near).string();
}

}  // namespace

std::optional<std::string> find_scene_file(const std::string& path, const ReadContext& context) {
  for (const fs::path& place : places_of(path, context)) {
    std::error_code error;
    if (!path.empty() && fs::exists(place, error) && !fs::is_directory(place, error)) {
      return place.string();
    }
  }
  return std::nullopt;
}

std::string missing_file_message(const std::string& path, const ReadContext& context,
                                 const std::string& further) {
  std::string tried, near;
  for (const fs::path& place : places_of(path, context)) {
    std::error_code error;
    if (fs::is_directory(place, error)) return "is a folder, not a file: " + place.string();
    tried += (tried.empty() ? "" : " and ") + place.string();
    if (near.empty()) near = nearest_file(place, path);
  }
  return "no such file: looked for " + tried + further +
         (near.empty() ? "" : fmt::format("; did you mean \"{}\"?", near));
}

}  // namespace karat
