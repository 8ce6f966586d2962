// One folder of index tables, laid out like refractiveindex.info's database.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "materials/index/index_catalogue_file.h"

namespace karat {

// FOLDER holds SHELF/BOOK/nk/PAGE.yml, directly or below FOLDER/data, and may hold catalog-nk.yml.
class IndexFolder {
 public:
  explicit IndexFolder(std::filesystem::path folder);

  // The file of an id or of a path below the folder; nothing when the folder does not know it.
  // Throws InputError where the catalogue gives two files for the id.
  std::optional<std::string> find(const std::string& name) const;

  // Every table file with its name: the catalogue's id of the path's own shelf where there is one.
  std::map<std::string, std::string> list() const;

  // The ids that the catalogue lists: further names of the same tables.
  const std::vector<std::string>& catalogue_ids() const { return catalogue().ids; }

  // What the catalogue says, with its titles.
  const IndexCatalogueFile& catalogue_file() const { return catalogue().file; }

  const std::filesystem::path& path() const { return folder_; }
  // Below which the shelves lie: FOLDER/data where there is one, otherwise FOLDER.
  const std::filesystem::path& root() const { return root_; }

 private:
  // The catalogue's paths below root_ per id, in the catalogue's order; read when first needed.
  struct Catalogue {
    IndexCatalogueFile file;
    std::vector<std::string> ids;
    std::map<std::string, std::vector<std::string>> paths;
  };
  const Catalogue& catalogue() const;
  Catalogue read_catalogue() const;
  std::optional<std::string> existing(const std::string& relative) const;

  std::filesystem::path folder_;
  std::filesystem::path root_;
  mutable std::once_flag once_;
  mutable Catalogue catalogue_;
};

}  // namespace karat
