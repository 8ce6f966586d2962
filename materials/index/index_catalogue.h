// Index tables by name: where they are looked for, and what there is.
#pragma once

#include <string>
#include <vector>

#include "materials/index/index_table.h"

namespace karat {

// The table of a name:
//   main/Au/Johnson          the id (shelf/book/page) in refractiveindex.info's catalogue
//   main/Au/nk/Johnson.yml   the path below a folder of tables
//   my/metal.yml             any other file, relative to the working folder or absolute
// Folders, in this order: Karat's own data/nk, $XDG_DATA_HOME/karat/nk (or
// ~/.local/share/karat/nk), then those in KARAT_NK_PATH, separated by colons; the first that knows
// the name gives the table. A checkout of the whole database is such a folder. Nothing but the
// table asked for is read, except a folder's catalog-nk.yml where the id does not tell the path.
// Throws InputError: unknown name (with the nearest), an id that stands for two files, a bad file.
// Tables are loaded once per process; safe to call from several threads.
IndexTablePtr find_index_table(const std::string& name);

// A table that can be had by name.
struct IndexTableEntry {
  std::string name;  // the id where there is one, otherwise the path below the folder
  std::string file;
};

// The tables of Karat's own and the user's folder; with `everywhere` those in KARAT_NK_PATH too. In
// alphabetical order of name; a name that a later folder repeats is left out.
std::vector<IndexTableEntry> list_index_tables(bool everywhere = false);

// --- Names as people type them. Scenes take full names alone, so that a table that is added later
// never changes what a scene means; the command line is more generous.

// The full name for `typed`: `typed` itself where find_index_table knows it; otherwise the one
// table of which it gives whole parts: "Au/Johnson", "Olmon-ev", "au/johnson". Throws InputError
// that lists the tables when several match ("Au", "Johnson", "gold").
std::string full_index_name(const std::string& typed);

// All tables that `typed` means: whole parts of their names ("Au", "main/Au", "Johnson"), words of
// their book's title ("gold"), or the start of a part ("Au/Olmon"). In alphabetical order. Throws
// InputError when there is none.
std::vector<std::string> matching_index_names(const std::string& typed);

}  // namespace karat
