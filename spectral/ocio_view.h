// The way from scene-linear colour to a display, through any OpenColorIO configuration.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "spectral/colour.h"

namespace karat {

// One view of one display. Colours are handed over in ACES2065-1 through the configuration's role
// `aces_interchange`, so its own space names do not matter. Immutable; apply() is safe from any
// number of threads at once.
class OcioView {
 public:
  // `config_path`: a configuration's file; "" takes $OCIO when that is set, else
  // data/ocio/config.ocio. `display`, `view`: "" takes the configuration's default.
  // `exposure_stops`: the colour is multiplied by 2^stops before the view. Throws InputError for a
  // configuration that cannot be read or lacks the role, for an unknown display or view (listing
  // the known ones) and for an exposure outside
  // [-100, 100].
  explicit OcioView(const std::string& config_path = "", const std::string& display = "",
                    const std::string& view = "", double exposure_stops = 0.0);
  ~OcioView();
  OcioView(OcioView&&) noexcept;
  OcioView& operator=(OcioView&&) noexcept;

  // Replaces `pixels` interleaved RGB triples, linear Rec.709 with white D65, by display code
  // values. [0, 1] is what the display can show; the colorimetric view leaves values outside
  // unclamped.
  void apply(float* rgb, std::size_t pixels) const;

  // "config PATH, display "sRGB", view "Colorimetric"" (and the exposure where it is not 0).
  std::string description() const;
  const std::string& config_path() const;
  const std::string& display() const;
  const std::string& view() const;

  std::vector<std::string> displays() const;
  std::vector<std::string> views(const std::string& display) const;  // InputError when unknown

 private:
  struct Implementation;
  std::unique_ptr<const Implementation> implementation_;
};

// Linear Rec.709 (white .3127 .3290) to ACES2065-1 (AP0, SMPTE ST 2065-1; white .32168 .33767),
// adapted by Bradford.
const Matrix3& aces2065_1_of_linear_srgb_matrix();

}  // namespace karat
