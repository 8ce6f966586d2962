// Fresnel models that watch another one at work.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "materials/fresnel.h"

namespace karat {

// While it lives, the Registry<FresnelModel> has a further model under a name that no other has: it
// returns what "exact" returns after evaluating that several times, and counts its calls where
// asked to. Whatever uses the model must be gone before the probe is.
class FresnelProbe {
 public:
  FresnelProbe(int evaluations, bool counts);
  ~FresnelProbe();
  FresnelProbe(const FresnelProbe&) = delete;
  FresnelProbe& operator=(const FresnelProbe&) = delete;

  const std::string& name() const { return name_; }
  std::uint64_t calls() const { return calls_; }

 private:
  std::string name_;
  std::atomic<std::uint64_t> calls_{0};
};

}  // namespace karat
