#include "render/named_index.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "materials/index/index_catalogue.h"
#include "materials/index/index_path.h"
#include "render/alloy_presets.h"
#include "render/scene_path.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

// How files of tables, and of what becomes one, end; pages of names hold points too ("Film-1.5nm").
bool ends_like(const std::string& text, std::initializer_list<const char*> endings) {
  return std::any_of(endings.begin(), endings.end(),
                     [&](const char* ending) { return text.ends_with(ending); });
}
bool ends_like_columns(const std::string& text) {
  return ends_like(text, {".csv", ".tsv", ".txt", ".nk", ".dat", ".spd"});
}
bool ends_like_a_file(const std::string& text) {
  return ends_like_columns(text) || ends_like(text, {".yml", ".yaml", ".json"});
}

std::string missing_table_file(const std::string& path, const ReadContext& context) {
  std::string folders;
  for (const IndexPathEntry& entry : index_path()) {
    if (entry.exists()) folders += (folders.empty() ? "" : ", ") + entry.folder.string();
  }
  return missing_file_message(path, context, ", and below " + folders);
}

// Why `text` names no table: `failure` says so of names; files and alloys are told apart.
std::string explained(const std::string& text, const std::string& failure,
                      const ReadContext& context) {
  const auto file = find_scene_file(text, context);
  if (file && ends_like_columns(text)) {
    return fmt::format(
        "\"{}\" holds columns and is no index table yet: \"karat nk add {} --name my/BOOK/PAGE\" "
        "makes one of it, for \"nk\": \"my/BOOK/PAGE\"",
        text, *file);
  }
  if (!file && ends_like_a_file(text)) return missing_table_file(text, context);
  const auto alloys = alloy_names();
  if (std::find(alloys.begin(), alloys.end(), text) == alloys.end()) return failure;
  return fmt::format("\"{}\" is an alloy, no table: write {{\"alloy\": \"{}\"}}", text, text);
}

}  // namespace

IndexTablePtr named_index(const JsonValue& value, const ReadContext& context) {
  const std::string& text = value.string();
  const std::filesystem::path beside = std::filesystem::path(context.directory) / text;
  std::error_code error;
  const bool is_file = std::filesystem::is_regular_file(beside, error);
  std::string failure;
  try {
    // Else the folders of tables, then the working folder.
    IndexTablePtr table = find_index_table(is_file ? beside.string() : text);
    remember_file(table->provenance().file, context);
    return table;
  } catch (const InputError& unknown) {
    failure = unknown.what();
  }
  value.fail(explained(text, failure, context));
}

}  // namespace karat
