#include "spectral/illuminant.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "spectral/colour.h"
#include "spectral/support/error.h"

using namespace karat;

namespace {

struct White {
  const char* name;
  double x, y;
};

// Published chromaticities, CIE 1931: CIE 015:2018, tables 5, 9.1, 10 to 12 (and ACES TB-2018-001
// for D60), rounded to four decimals there.
constexpr White kPublished[] = {
    {"A", .4476, .4074},       {"B", .3484, .3516},        {"C", .3101, .3162},
    {"D50", .3457, .3585},     {"D55", .3324, .3474},      {"D60", .3216, .3377},
    {"D65", .3127, .3290},     {"D75", .2990, .3149},      {"E", .3333, .3333},
    {"FL1", .3131, .3371},     {"FL2", .3721, .3751},      {"FL3", .4091, .3941},
    {"FL4", .4402, .4031},     {"FL5", .3138, .3452},      {"FL6", .3779, .3882},
    {"FL7", .3129, .3292},     {"FL8", .3458, .3586},      {"FL9", .3741, .3727},
    {"FL10", .3458, .3588},    {"FL11", .3805, .3769},     {"FL12", .4370, .4042},
    {"FL3.1", .4407, .4033},   {"FL3.2", .3808, .3734},    {"FL3.3", .3153, .3439},
    {"FL3.4", .4429, .4043},   {"FL3.5", .3749, .3672},    {"FL3.6", .3488, .3600},
    {"FL3.7", .4384, .4045},   {"FL3.8", .3820, .3832},    {"FL3.9", .3499, .3591},
    {"FL3.10", .3455, .3560},  {"FL3.11", .3245, .3434},   {"FL3.12", .4377, .4037},
    {"FL3.13", .3830, .3724},  {"FL3.14", .3447, .3609},   {"FL3.15", .3127, .3288},
    {"HP1", .5330, .4150},     {"HP2", .4778, .4158},      {"HP3", .4302, .4075},
    {"HP4", .3812, .3797},     {"HP5", .3776, .3713},      {"ID50", .3433, .3602},
    {"ID65", .3107, .3307},    {"LED-B1", .4560, .4078},   {"LED-B2", .4357, .4012},
    {"LED-B3", .3756, .3723},  {"LED-B4", .3422, .3502},   {"LED-B5", .3118, .3236},
    {"LED-BH1", .4474, .4066}, {"LED-RGB1", .4557, .4211}, {"LED-V1", .4548, .4044},
    {"LED-V2", .3781, .3775}};

// The samples of every table sit at multiples of 5 nm; the published figures are sums over them.
std::array<double, 2> chromaticity_at_5_nm(const std::string& name) {
  const SpectrumPtr s = illuminant(name);
  const Observer& o = observer("cie1931");
  Xyz xyz{};
  for (double nm = 380.0; nm <= 780.0; nm += 5.0) {
    for (int i = 0; i < 3; ++i) xyz[static_cast<std::size_t>(i)] += (*s)(nm)*o[i](nm);
  }
  const auto xyy = xyy_of_xyz(xyz);
  return {xyy[0], xyy[1]};
}

bool is_table(const std::string& name) { return name != "A" && name != "E"; }

}  // namespace

TEST_CASE("Whites by 1 nm sums", "[illuminant]") {
  for (const White& w : {White{"D65", .312727, .329023}, White{"D50", .345684, .358504},
                         White{"E", .333314, .333288}}) {
    const auto xyy = xyy_of_xyz(white_xyz(w.name));
    INFO(w.name);
    CHECK(xyy[0] == Approx(w.x).epsilon(0).margin(6e-7));
    CHECK(xyy[1] == Approx(w.y).epsilon(0).margin(6e-7));
  }
  // A: ISO/CIE 11664-2 gives .44758 .40745 for its formula over the whole observer. Lines between
  // 5 nm samples that end at 780 nm, as in older tables, give .447559 .407432.
  const auto whole = xyy_of_xyz(white_xyz("A"));
  CHECK(whole[0] == Approx(.44758).epsilon(0).margin(1.5e-5));
  CHECK(whole[1] == Approx(.40745).epsilon(0).margin(1.5e-5));
  std::vector<double> nm, values;
  for (double l = 300.0; l <= 780.0; l += 5.0) {
    nm.push_back(l), values.push_back((*illuminant("A"))(l));
  }
  const auto coarse = xyy_of_xyz(xyz_of_reflectance(*constant_spectrum(1.0),
                                                    *table_spectrum(nm, values, "A at 5 nm"),
                                                    observer("cie1931"), {360.0, 780.0}));
  CHECK(coarse[0] == Approx(.447559).epsilon(0).margin(6e-7));
  CHECK(coarse[1] == Approx(.407432).epsilon(0).margin(6e-7));
}

TEST_CASE("Whites agree with the published chromaticities", "[illuminant]") {
  CHECK(illuminant_names().size() == std::size(kPublished));
  for (const White& w : kPublished) {
    INFO(w.name);
    const auto [x5, y5] = chromaticity_at_5_nm(w.name);
    CHECK(x5 == Approx(w.x).epsilon(0).margin(1e-4));
    CHECK(y5 == Approx(w.y).epsilon(0).margin(1e-4));
    // Lines drawn linearly between 5 nm samples weigh the observer a little differently.
    const auto xyy = xyy_of_xyz(white_xyz(w.name));
    CHECK(xyy[0] == Approx(w.x).epsilon(0).margin(4e-4));
    CHECK(xyy[1] == Approx(w.y).epsilon(0).margin(4e-4));
  }
}

TEST_CASE("Illuminant A is its closed form", "[illuminant]") {
  const SpectrumPtr a = illuminant("A");
  CHECK((*a)(560.0) == Approx(100.0).epsilon(1e-12));
  // ISO/CIE 11664-2, table 1.
  CHECK((*a)(300.0) == Approx(0.930483).epsilon(1e-6));
  CHECK((*a)(380.0) == Approx(9.79510).epsilon(1e-5));
  CHECK((*a)(780.0) == Approx(241.675).epsilon(1e-5));
  // The same curve by today's constants is the blackbody at 2848 K times the ratio of the c2.
  const SpectrumPtr planck = blackbody_spectrum(2848.0 * 1.438776877e7 / 1.435e7);
  for (const double nm : {380.0, 555.0, 780.0, 1500.0}) {
    CHECK((*a)(nm) / (*planck)(nm) == Approx(100.0 / (*planck)(560.0)).epsilon(1e-8));
  }
}

TEST_CASE("Illuminant tables are linear between their samples and zero outside", "[illuminant]") {
  const SpectrumPtr d65 = illuminant("D65");
  // The 1 nm table that CIE prescribes is this interpolation of the 5 nm table.
  CHECK((*d65)(301.0) == Approx(0.36014).epsilon(1e-9));
  CHECK((*d65)(314.0) == Approx(10.07106).epsilon(1e-9));
  CHECK((*d65)(560.0) == 100.0);
  for (const std::string& name : illuminant_names()) {
    if (!is_table(name)) continue;
    const SpectrumPtr s = illuminant(name);
    const WavelengthRange range = s->range();
    INFO(name);
    CHECK((*s)(range.min_nm - 1e-6) == 0.0);
    CHECK((*s)(range.max_nm + 1e-6) == 0.0);
    CHECK(s->range().covers(kVisible));
    for (double nm = range.min_nm; nm <= range.max_nm; nm += 1.0) {
      if (!((*s)(nm) >= 0.0)) FAIL_CHECK(nm);
    }
  }
}

// Daylight is the sum of three components tabulated apart: a second source for every D table.
TEST_CASE("Daylight tables are the daylight components at their temperature", "[illuminant]") {
  struct Named {
    const char* name;
    double kelvin;
  };
  for (const Named& d : {Named{"D50", 5000}, Named{"D55", 5500}, Named{"D60", 6000},
                         Named{"D65", 6500}, Named{"D75", 7500}}) {
    const SpectrumPtr table = illuminant(d.name);
    const SpectrumPtr computed = daylight_spectrum(d.kelvin * 1.4388 / 1.4380);
    for (double nm = 380.0; nm <= 780.0; nm += 5.0) {
      INFO(d.name << " at " << nm);
      // M1 and M2 are rounded to three decimals in the tables.
      CHECK((*computed)(nm) == Approx((*table)(nm)).epsilon(0).margin(0.05));
    }
  }
  CHECK_THROWS_AS(daylight_spectrum(3999.0), InputError);
  CHECK_THROWS_AS(daylight_spectrum(std::nan("")), InputError);
}

// CIE 184: indoor daylight is daylight through one window glass, so both ratios are its
// transmittance (in units of the value at 560 nm), within the rounding of the last of four digits.
TEST_CASE("Indoor daylight is daylight through the same glass", "[illuminant]") {
  const SpectrumPtr d50 = illuminant("D50"), d65 = illuminant("D65"), id50 = illuminant("ID50"),
                    id65 = illuminant("ID65");
  for (double nm = 380.0; nm <= 780.0; nm += 5.0) {
    INFO(nm);
    CHECK((*id50)(nm) / (*d50)(nm) == Approx((*id65)(nm) / (*d65)(nm)).epsilon(0).margin(4e-4));
  }
}

TEST_CASE("The filtered tungsten of B and C is smooth", "[illuminant]") {
  for (const char* name : {"B", "C"}) {
    const SpectrumPtr s = illuminant(name);
    for (double nm = s->range().min_nm + 10.0; nm <= s->range().max_nm - 10.0; nm += 5.0) {
      const double fourth =
          (*s)(nm - 10) - 4 * (*s)(nm - 5) + 6 * (*s)(nm)-4 * (*s)(nm + 5) + (*s)(nm + 10);
      INFO(name << " at " << nm);
      CHECK(std::abs(fourth) < 5.0);  // 4 % of the peak: an error of 0.8 in one value shows
    }
  }
}

TEST_CASE("A normalised spectrum has Y = 1", "[illuminant]") {
  for (const std::string& name : illuminant_names()) {
    const SpectrumPtr s = normalised(illuminant(name));
    CHECK(s->description().find("illuminant " + name) != std::string::npos);
    CHECK(xyz_of_emission(*s, observer("cie1931"))[1] == Approx(1.0).epsilon(1e-12));
  }
  CHECK_THROWS_AS(normalised(constant_spectrum(0.0)), InputError);
}

TEST_CASE("An unknown illuminant is an error that names a near one", "[illuminant]") {
  CHECK_THROWS_WITH(illuminant("d65"), Catch::Contains("D65"));
  CHECK_THROWS_AS(illuminant("../cie/cie1931"), InputError);
  CHECK_THROWS_AS(illuminant(""), InputError);
}
