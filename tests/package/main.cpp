// Evaluates a spectrum through the installed library, and writes and reads an image, for which the
// library loads its module: exit code 0 when the value is Planck's and the image comes back.
#include <cmath>
#include <cstdio>

#include "render/image_file.h"
#include "spectral/spectrum.h"

int main() {
  // Wien's displacement law: a blackbody of 5000 K is brightest at 2897771.955 nm K / 5000 K.
  const karat::SpectrumPtr spectrum = karat::blackbody_spectrum(5000.0);
  const double peak_nm = 2897771.955 / 5000.0;
  const double peak = (*spectrum)(peak_nm);
  const bool is_maximum = peak > (*spectrum)(peak_nm - 1.0) && peak > (*spectrum)(peak_nm + 1.0);

  const karat::WavelengthLattice lattice;
  const karat::LatticeSpectrum sampled = karat::point_samples(*spectrum, lattice);
  const double expected = (*spectrum)(lattice.wavelength_nm(3, 1));
  const bool lanes_agree = std::abs(sampled[1][3] - expected) < 1e-6 * expected;

  std::printf("%s: %.6g W m^-2 sr^-1 nm^-1 at %.2f nm\n", spectrum->description().c_str(), peak,
              peak_nm);

  karat::Image image;
  image.width = 2, image.height = 1;
  image.channels = {"R", "G", "B"};
  image.values = {0.0f, 1.0f, 0.0f, 1.0f, 0.0f, 1.0f};
  karat::write_png("consumer.png", image);
  const bool image_returns = karat::read_image("consumer.png").values == image.values;
  return is_maximum && lanes_agree && image_returns ? 0 : 1;
}
