// SQLite behind two classes: errors are exceptions, handles close themselves.
#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

namespace karat {

// What SQLite said, with its code: SQLITE_CORRUPT, SQLITE_NOTADB, ...
class SqliteError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// One prepared statement. Parameters are ?1, ?2, ...; columns count from 0, as SQLite has them.
class SqliteStatement {
 public:
  SqliteStatement(sqlite3* database, const std::string& sql);

  SqliteStatement& bind(int parameter, const std::string& value);
  SqliteStatement& bind(int parameter, double value);
  SqliteStatement& bind(int parameter, std::int64_t value);

  // True while there is another row.
  bool step();
  // Steps through to the end, then makes the statement ready for other parameters.
  void run();
  void reset() { sqlite3_reset(statement_.get()); }

  std::string text(int column) const;
  double real(int column) const { return sqlite3_column_double(statement_.get(), column); }
  std::int64_t integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }

 private:
  void check(int code) const;
  struct Finalize {
    void operator()(sqlite3_stmt* s) const { sqlite3_finalize(s); }
  };
  sqlite3* database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

class SqliteDatabase {
 public:
  // In memory.
  SqliteDatabase();
  // An existing file that nobody changes any more: read without locks.
  static SqliteDatabase open_immutable(const std::string& file);

  void execute(const std::string& sql);
  SqliteStatement prepare(const std::string& sql) const { return {database_.get(), sql}; }

 private:
  SqliteDatabase(const std::string& uri, int flags);
  struct Close {
    void operator()(sqlite3* d) const { sqlite3_close(d); }
  };
  std::unique_ptr<sqlite3, Close> database_;
};

}  // namespace karat
