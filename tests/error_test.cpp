#include "spectral/support/error.h"

#include <catch2/catch.hpp>

namespace karat {
namespace {

TEST_CASE("the nearest name: words and beginnings, then spelling, and nothing unrelated",
          "[error]") {
  const std::vector<std::string> known{"position",  "look_at",      "up",          "fov_deg",
                                       "angle_deg", "inner_radius", "reflectance", "file",
                                       "height",    "D65"};
  const std::vector<std::pair<std::string, std::string>> rows{{"fov", "fov_deg"},
                                                              {"angle", "angle_deg"},
                                                              {"radius", "inner_radius"},
                                                              {"Reflect", "reflectance"},
                                                              {"heigth", "height"},
                                                              {"posiiton", "position"},
                                                              {"reflectence", "reflectance"},
                                                              {"d65", "D65"},
                                                              {"D66", "D65"},
                                                              {"fiel", "file"},
                                                              {"rotation", ""},
                                                              {"size", ""},
                                                              {"scale", ""},
                                                              {"at", ""}};
  for (const auto& [name, expected] : rows) {
    INFO(name);
    CHECK(nearest_name(name, known) == expected);
  }
  CHECK(nearest_name("srgb", {"Raw", "sRGB"}) == "sRGB");
}

TEST_CASE("a word of several names: all are suggested", "[error]") {
  CHECK(unknown_name_message("key", "radius", {"edge_radius", "inner_radius", "type"}) ==
        "unknown key \"radius\"; did you mean \"edge_radius\" or \"inner_radius\"? "
        "Known: edge_radius, inner_radius, type.");
}

}  // namespace
}  // namespace karat
