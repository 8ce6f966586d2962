// catalog-nk.yml: what refractiveindex.info's database calls the tables of a folder.
#pragma once

#include <string>
#include <vector>

namespace karat {

// One page of a catalogue. Titles are plain text, empty where the catalogue has none.
struct CataloguePage {
  std::string id;          // "main/Au/Johnson"
  std::string path;        // "main/Au/nk/Johnson.yml", below the folder's data
  std::string book_title;  // "Au (Gold)"
  std::string section;     // the divider above it: "Experimental data: bulk, thick film"
  std::string page_title;  // "Johnson and Christy 1972: n,k 0.188-1.937 um"
};

// What a catalogue lists, in its order.
struct IndexCatalogueFile {
  std::vector<CataloguePage> pages;
  // Titles of the books "main/Au", also of those that list no page.
  std::vector<std::pair<std::string, std::string>> books;
};

// Empty when there is no such file. Throws InputError with the line of what is not a catalogue.
IndexCatalogueFile read_index_catalogue(const std::string& file);

}  // namespace karat
