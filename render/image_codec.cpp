#include "render/image_codec.h"

#include <dlfcn.h>
#include <link.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "spectral/support/error.h"

namespace karat {
namespace {

namespace fs = std::filesystem;

// The folder of the program or shared library that holds this code.
fs::path own_folder() {
  Dl_info info{};
  void* extra = nullptr;
  std::error_code ignored;
  const bool found =
      ::dladdr1(reinterpret_cast<const void*>(&image_codec), &info, &extra, RTLD_DL_LINKMAP) != 0;
  const auto* loaded = static_cast<const link_map*>(extra);
  // The program itself has no name there, and argv[0] need not be a path.
  const bool library = found && loaded && loaded->l_name && *loaded->l_name;
  const fs::path file = library ? fs::path(loaded->l_name) : fs::path("/proc/self/exe");
  return fs::canonical(file, ignored).parent_path();
}

// Beside the program of a build; where `cmake --install` puts it, seen from the program and from
// the library; where it was built, for programs that lie elsewhere in the build folder.
std::vector<fs::path> candidates() {
  const fs::path own = own_folder();
  std::vector<fs::path> places;
  for (const char* folder : {".", KARAT_MODULE_FROM_PROGRAM, "karat", KARAT_MODULE_BUILD_DIR}) {
    const fs::path place = (own / folder / "karat_images.so").lexically_normal();
    if (std::find(places.begin(), places.end(), place) == places.end()) places.push_back(place);
  }
  return places;
}

[[noreturn]] void fail(const std::string& tried) {
  throw RuntimeError(
      "cannot load karat_images.so, which reads and writes images through OpenImageIO; tried" +
      tried);
}

// The module stays loaded until the program ends.
const ImageCodec& load() {
  std::string tried;
  for (const fs::path& place : candidates()) {
    std::error_code ignored;
    if (!fs::exists(place, ignored)) {
      tried += "\n  " + place.string() + ": no such file";
      continue;
    }
    void* module = ::dlopen(place.c_str(), RTLD_LAZY | RTLD_LOCAL);
    void* entry = module ? ::dlsym(module, "karat_image_codec") : nullptr;
    if (!entry) {
      const char* message = ::dlerror();
      tried += "\n  " + (message ? std::string(message) : place.string() + ": not a module");
      continue;
    }
    const ImageCodec& codec = *static_cast<const ImageCodec*>(entry);
    if (std::string(codec.version) == KARAT_VERSION) return codec;
    tried += "\n  " + place.string() + ": is of Karat " + codec.version +
             ", the program of " KARAT_VERSION;
  }
  fail(tried);
}

}  // namespace

const ImageCodec& image_codec() {
  static const ImageCodec& codec = load();
  return codec;
}

void require_image_codec() {
  std::string tried;
  for (const fs::path& place : candidates()) {
    std::error_code ignored;
    if (fs::exists(place, ignored)) return;
    tried += "\n  " + place.string() + ": no such file";
  }
  fail(tried);
}

}  // namespace karat
