// RGB workflows: what renderers without spectra do, as Fresnel models. A material is reduced to
// three channels of linear sRGB; each channel reflects by itself; the three results become a
// spectrum again with the primaries of materials/rgb_channels.h. Its colour under D65 is exactly
// what such a renderer shows under a white light, so that a colour difference to the exact model
// under D65 is the error of the workflow. (Under other illuminants and between several reflections
// such a renderer multiplies RGB triples, which no spectrum can imitate.)
#pragma once

#include "materials/fresnel_exact.h"
#include "materials/rgb_channels.h"

namespace karat {

// Three numbers in the first lanes of a plane's first phase.
inline LatticeSpectrum channel_plane(const Rgb& rgb) {
  LatticeSpectrum plane(static_cast<float>(rgb[2]));
  plane[0][0] = static_cast<float>(rgb[0]);
  plane[0][1] = static_cast<float>(rgb[1]);
  return plane;
}

// A model's own planes come first, the primaries last.
class RgbFresnel : public FresnelModel {
 public:
  bool per_wavelength() const final { return false; }

  FresnelTables prepare(const LatticeIndex& index) const final {
    const auto channels = RgbChannels::of(index.lattice);
    FresnelTables tables = prepare_channels(index, *channels);
    for (const LatticeSpectrum& primary : channels->primaries()) tables.planes.push_back(primary);
    return tables;
  }

 protected:
  virtual FresnelTables prepare_channels(const LatticeIndex& index,
                                         const RgbChannels& channels) const = 0;

  // `channels` holds three reflectances in its first lanes, `first` is the first primary's plane.
  static SampledSpectrum mixed(const SampledSpectrum& channels, const FresnelTables& tables,
                               std::size_t first, int phase) {
    const SampledSpectrum& red = tables.planes[first][phase];
    const SampledSpectrum& green = tables.planes[first + 1][phase];
    const SampledSpectrum& blue = tables.planes[first + 2][phase];
    const float r = channels[0], g = channels[1], b = channels[2];
    SampledSpectrum result;
    for (int i = 0; i < kLanes; ++i) {
      result[i] = std::min(r * red[i] + g * green[i] + b * blue[i], 1.0f);
    }
    return result;
  }
};

// An n and k per channel, then the exact equations three times.
class RgbExactFresnel : public RgbFresnel {
 public:
  SampledSpectrum reflectance(const FresnelTables& tables, int phase, float cos_theta) const final {
    return mixed(exact_reflectance(tables, 0, cos_theta), tables, kExactPlanes, phase);
  }
  std::optional<PolarisedReflectance> polarised(const FresnelTables& tables, int phase,
                                                float cos_theta) const final {
    const PolarisedReflectance channels = exact_polarised(tables, 0, cos_theta);
    return PolarisedReflectance{mixed(channels.s, tables, kExactPlanes, phase),
                                mixed(channels.p, tables, kExactPlanes, phase)};
  }
  // A material without colour is the same in every channel.
  Scalar evaluate(ComplexIndex index, double cos_theta) const final {
    return exact_scalar(index, cos_theta);
  }

 protected:
  struct ChannelIndex {
    Rgb n, k;
  };
  virtual ChannelIndex channel_index(const LatticeIndex& index,
                                     const RgbChannels& channels) const = 0;

  FresnelTables prepare_channels(const LatticeIndex& index,
                                 const RgbChannels& channels) const final {
    const ChannelIndex m = channel_index(index, channels);
    return exact_tables({channel_plane(m.n), channel_plane(m.k), index.lattice},
                        [](double n, double k) {
                          return ComplexIndex{n, k};
                        });
  }

  // The index at one wavelength per channel, linear between those of the lattice.
  static ChannelIndex index_at(const LatticeIndex& index, const Rgb& wavelengths_nm);
};

}  // namespace karat
