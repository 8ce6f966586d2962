// The database's own YAML: nothing to convert, materials/index/index_table_file.h reads it.
#include "materials/index/import/format.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

bool ends_in_yaml(const std::string& file) {
  return file.ends_with(".yml") || file.ends_with(".yaml");
}

// A line that begins with a key of the format.
bool has_key(std::string_view text, std::string_view key) {
  for (std::size_t at = text.find(key); at != std::string_view::npos; at = text.find(key, at + 1)) {
    if (at == 0 || text[at - 1] == '\n') return true;
  }
  return false;
}

class Database final : public IndexFormat {
 public:
  int likeness(const IndexSource& source) const override {
    const bool keys = has_key(source.text, "DATA:") || has_key(source.text, "REFERENCES:");
    return ends_in_yaml(source.file) || keys ? 4 : 0;
  }
  std::string title() const override { return "YAML of refractiveindex.info"; }
  bool is_database() const override { return true; }
  RawTable read(const IndexSource& source, const ColumnNames&) const override {
    throw InputError(source.file, "", "YAML has no columns to read");
  }
};

KARAT_REGISTER(IndexFormat, "yaml", Database);

}  // namespace
}  // namespace karat
