#include "materials/index/index_catalogue_file.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>

#include "materials/index/index_markup.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestCatalogue = std::uintmax_t{16} << 20;

std::string title_of(const YAML::Node& node) {
  const YAML::Node name = node["name"];
  return name && name.IsScalar() ? plain_text(name.Scalar()) : "";
}

void read_book(const YAML::Node& book, const std::string& shelf, IndexCatalogueFile& result) {
  const std::string name = shelf + "/" + book["BOOK"].Scalar(), title = title_of(book);
  if (!title.empty()) result.books.emplace_back(name, title);
  std::string section;
  for (const YAML::Node& page : book["content"]) {
    if (page["DIVIDER"]) section = plain_text(page["DIVIDER"].Scalar());
    if (!page["PAGE"] || !page["data"]) continue;
    result.pages.push_back({name + "/" + page["PAGE"].Scalar(), page["data"].Scalar(), title,
                            section, title_of(page)});
  }
}

}  // namespace

IndexCatalogueFile read_index_catalogue(const std::string& file) {
  IndexCatalogueFile result;
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return result;
  if (fs::file_size(file, error) > kLargestCatalogue)
    throw InputError(file, "", "too large for a catalogue");
  try {
    for (const YAML::Node& shelf : YAML::LoadFile(file)) {
      if (!shelf["SHELF"]) continue;
      for (const YAML::Node& book : shelf["content"]) {
        if (book["BOOK"]) read_book(book, shelf["SHELF"].Scalar(), result);
      }
    }
  } catch (const YAML::Exception& exception) {
    throw InputError(file, fmt::format("line {}", exception.mark.line + 1),
                     "not a catalogue: " + exception.msg);
  }
  return result;
}

}  // namespace karat
