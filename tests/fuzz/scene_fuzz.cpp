// Any bytes as a scene: it loads, or an InputError says why not. Anything else is a finding.
#include <cstdint>
#include <string>

#include "render/scene_loader.h"
#include "spectral/support/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  // Valid scenes of huge meshes only cost time and memory: no "segments" above three digits.
  for (std::size_t at = 0; (at = text.find("segments", at)) != std::string::npos; ++at) {
    const std::size_t digit = text.find_first_of("123456789", at);
    if (digit != std::string::npos && text.find_first_not_of("0123456789", digit) - digit > 3) {
      return -1;
    }
  }
  try {
    karat::load_scene_text(text, "fuzz.json", "/nonexistent");
  } catch (const karat::InputError&) {
  }
  return 0;
}
