// Optical constants of IMD (D. L. Windt), which luxpop.com lists too: columns of wavelength in
// angstroms, n and k, below comments that begin with a semicolon (IMD manual, appendix A.1,
// rxollc.com/idl).
#include "materials/index/import/columns.h"

namespace karat {
namespace {

bool ends_in_nk(const std::string& file) {
  return file.ends_with(".nk") || file.ends_with(".NK") || file.ends_with(".Nk");
}

class Imd final : public IndexFormat {
 public:
  int likeness(const IndexSource& source) const override { return ends_in_nk(source.file) ? 2 : 0; }
  std::string title() const override { return "IMD .nk"; }
  RawTable read(const IndexSource& source, const ColumnNames& columns) const override {
    RawTable table = read_columns(source, columns);
    if (!table.unit) {
      table.unit = AxisUnit::kAngstrom;
      table.unit_source = "IMD's .nk files have angstroms";
    }
    return table;
  }
};

KARAT_REGISTER(IndexFormat, "imd", Imd);

}  // namespace
}  // namespace karat
