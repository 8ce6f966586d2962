// The spectral axis of a measured table, and its conversion to the micrometres of the database.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace karat {

enum class AxisUnit { kNm, kUm, kAngstrom, kEv, kPerCm };

inline constexpr std::array kAxisUnits{AxisUnit::kNm, AxisUnit::kUm, AxisUnit::kAngstrom,
                                       AxisUnit::kEv, AxisUnit::kPerCm};

// h c / e in eV um, exact by the SI's definitions of 2019 (CODATA 2018: 1.239841984...).
inline constexpr double kEvMicrometres = 6.62607015e-34 * 299792458.0 / 1.602176634e-19 * 1e6;

// A finite number as a file wrote it: the digits are kept where no formula changes the value.
struct WrittenNumber {
  double value = 0.0;
  std::string text;  // with a decimal point, readable by index_number
};

// The shortest text that reads back as `value`.
WrittenNumber written(double value);

// "nm", "um", "angstrom", "eV", "cm-1": what --unit takes.
std::string axis_unit_name(AxisUnit unit);

// A unit as people write it: "nm", "µm", "microns", "Å", "1/cm", "cm^-1", in any case; nothing
// where the text is none.
std::optional<AxisUnit> axis_unit(std::string_view text);

// Wavelength in micrometres of a positive number in `unit`. Units of length shift the decimal point
// of the text, so that no digit changes; energies and wavenumbers are computed in double.
WrittenNumber micrometres(const WrittenNumber& number, AxisUnit unit);
double micrometres(double number, AxisUnit unit);

// `text` times ten to the power of `places`, digit by digit: ("400.5", -3) is "0.4005".
std::string shifted_decimal(std::string_view text, int places);

}  // namespace karat
