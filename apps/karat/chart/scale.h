// Values to pixels, and the round values that an axis names.
#pragma once

#include <string>
#include <vector>

namespace karat {

// An interval of values, mapped to an interval of pixels; on a logarithmic scale 0 < min < max.
struct Scale {
  double min = 0.0, max = 1.0;
  bool log = false;
  double from_pixel = 0.0, to_pixel = 1.0;

  // Where a value lies; not a number where it has no place (not finite, or log of what is <= 0).
  double pixel(double value) const;
};

struct Tick {
  double value = 0.0;
  std::string text;  // "" for a minor tick
};

// Ticks at 1, 2, 2.5 or 5 times a power of ten, or at powers of ten and their multiples, such that
// labels are about `spacing` pixels apart or more.
std::vector<Tick> axis_ticks(const Scale& scale, double spacing);

// A value with the digits that a step asks for, with a true minus sign.
std::string tick_text(double value, double step);

}  // namespace karat
