#include "render/version.h"

#include <OpenColorIO/OpenColorABI.h>
#include <OpenEXR/OpenEXRConfig.h>
#include <OpenImageIO/oiioversion.h>
#include <fmt/format.h>
#include <tbb/version.h>

#include <nlohmann/json.hpp>

#if __has_include(<embree4/rtcore_config.h>)
#include <embree4/rtcore_config.h>
#else
#include <embree3/rtcore_config.h>
#endif

#ifndef KARAT_COMMIT
#define KARAT_COMMIT ""
#endif

namespace karat {

std::string version() { return KARAT_VERSION; }

std::string commit() { return KARAT_COMMIT; }

std::string compiler() {
#if defined(__clang__)
  return "Clang " __clang_version__;
#elif defined(__GNUC__)
  return "GCC " __VERSION__;
#else
  return "unknown compiler";
#endif
}

std::string libraries() {
  return fmt::format(
      "Embree {}, oneTBB {}.{}, OpenColorIO {}, OpenImageIO {}.{}.{}, OpenEXR {}, nlohmann-json "
      "{}.{}.{}",
      RTC_VERSION_STRING, TBB_VERSION_MAJOR, TBB_VERSION_MINOR, OCIO_VERSION, OIIO_VERSION_MAJOR,
      OIIO_VERSION_MINOR, OIIO_VERSION_PATCH, OPENEXR_VERSION_STRING, NLOHMANN_JSON_VERSION_MAJOR,
      NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH);
}

}  // namespace karat
