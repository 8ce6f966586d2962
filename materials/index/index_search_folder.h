// The searchable form of one folder of index tables.
#pragma once

#include <string>
#include <vector>

#include "materials/index/index_search.h"
#include "materials/index/sqlite_database.h"

namespace karat {

// What a folder holds, as far as it can be told without opening a file: another value when a table
// or catalogue appeared, vanished, or has another size or time.
std::string folder_fingerprint(const std::string& folder);

// Opens the stored index of a folder. Throws SqliteError where `file` is none, is damaged, or does
// not belong to this folder with this fingerprint.
SqliteDatabase open_search_database(const std::string& file, const std::string& folder,
                                    const std::string& fingerprint);

// Reads every table of the folder, on all processors, into an index in memory.
SqliteDatabase build_search_database(const std::string& folder, const std::string& fingerprint);

// Writes it to a file of its own and renames that to `file`. Throws SqliteError or
// std::filesystem::filesystem_error.
void store_search_database(SqliteDatabase& database, const std::string& file);

// The hits in one folder, unordered but for the catalogue's order; the query's filters are heeded.
std::vector<IndexSearchHit> search_database(const SqliteDatabase& database,
                                            const IndexSearchQuery& query);

// Whether any table has the word or a word that starts with it, and all words that there are.
bool has_word(const SqliteDatabase& database, const std::string& word);
std::vector<std::string> all_words(const SqliteDatabase& database);

}  // namespace karat
