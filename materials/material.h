// What a surface is made of: loaded once per scene, asked for a Bsdf at every vertex.
#pragma once

#include <cstddef>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "materials/bsdf.h"
#include "materials/index/index_table.h"
#include "materials/parameters.h"
#include "spectral/support/registry.h"

namespace karat {

// The point for which a Bsdf is prepared.
struct ShadingPoint {
  Vec3 position;
  Vec2 uv;
};

// Room for one Bsdf: no heap in the loop. A Bsdf is trivially destructible in effect: its
// destructor is never run, so it holds pointers and values only.
class BsdfStorage {
 public:
  template <typename B, typename... Args>
  const Bsdf* make(Args&&... args) {
    static_assert(sizeof(B) <= kSize && alignof(B) <= 64);
    return new (bytes_) B(std::forward<Args>(args)...);
  }

 private:
  static constexpr std::size_t kSize = 512;
  alignas(64) std::byte bytes_[kSize];
};

class Material {
 public:
  virtual ~Material() = default;

  // The returned Bsdf lives in `storage`.
  virtual const Bsdf* prepare(const ShadingPoint& point, SampledWavelengths wavelengths,
                              Transport transport, BsdfStorage& storage) const = 0;

  // True where every lobe is a delta (smooth mirror, smooth glass): light sampling is useless
  // there.
  virtual bool only_delta() const { return false; }

  // True where a Bsdf depends on uv or on the direction of the tangent; else neither is computed.
  virtual bool uses_uv() const { return false; }

  // True where light passes through: such a surface is seen from both sides.
  virtual bool transmits() const { return false; }
};

// What every material is built with beside its own parameters.
struct MaterialContext {
  WavelengthLattice lattice;
  std::string fresnel_override;        // from `karat render --fresnel`; empty: what the scene says
  std::vector<std::string>* warnings;  // never null; shown and written into the image
};

// One source file per reflection model, ending in
//   KARAT_REGISTER(MaterialType, "conductor", ConductorType);
class MaterialType {
 public:
  virtual ~MaterialType() = default;
  virtual std::string description() const = 0;
  virtual std::vector<ParameterInfo> parameters() const = 0;
  // Throws InputError (without file and place: the loader adds them) where values do not fit
  // together.
  virtual std::unique_ptr<const Material> create(const Parameters& parameters,
                                                 const MaterialContext& context) const = 0;
};

}  // namespace karat
