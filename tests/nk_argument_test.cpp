// What the nk commands take for an index, and what they say of slips.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "apps/karat/nk/index_argument.h"
#include "spectral/support/error.h"
#include "tests/run_cli.h"

namespace {

using Catch::Contains;
using karat::index_of_argument;
using karat::test::karat_run;
using karat::test::Outcome;
using nlohmann::json;

}  // namespace

TEST_CASE("a made index stands where a table's name does", "[nk-argument]") {
  const auto preset = index_of_argument("alloy:rose-gold-18k");
  CHECK(preset->provenance().name == "alloy:rose-gold-18k");
  CHECK_THAT(preset->provenance().reference, Contains("0.75 main/Au/Johnson"));
  const auto same = index_of_argument(
      R"({"alloy": {"main/Au/Johnson": 0.75, "main/Ag/Johnson": 0.09, "main/Cu/Johnson": 0.16},
          "by": "mass"})");
  CHECK(same->at(550.0).k == preset->at(550.0).k);
  const std::string file = (std::filesystem::temp_directory_path() /
                            ("karat_nk_argument_" + std::to_string(getpid()) + ".json"))
                               .string();
  std::ofstream(file) << R"({"description": "x", "source": "y", "nk": {"alloy": "rose-gold-18k"}})";
  CHECK(index_of_argument(file)->at(550.0).k == preset->at(550.0).k);
  std::filesystem::remove(file);

  CHECK_THROWS_WITH(index_of_argument("rose-gold-18k"), Contains("write alloy:rose-gold-18k"));
  CHECK_THROWS_WITH(index_of_argument("alloy:rose-gold-19k"),
                    Contains("alloy:rose-gold-18k: ") || Contains("did you mean"));
  CHECK_THROWS_AS(index_of_argument("{"), karat::InputError);
  CHECK_THROWS_WITH(
      index_of_argument(
          R"({"substrate": "main/Ti/Johnson", "layers": [{"nk": 2.5, "thickness_nm": 40}]})"),
      Contains("stack of films"));
}

TEST_CASE("commands show made indices; list knows the presets", "[nk-argument]") {
  const Outcome colour = karat_run({"nk", "colour", "alloy:rose-gold-18k", "--json"});
  CHECK(colour.code == 0);
  CHECK(json::parse(colour.out)["name"] == "alloy:rose-gold-18k");
  CHECK(karat_run({"nk", "eval", "alloy:sterling-silver", "--nm", "550"}).code == 0);
  CHECK(karat_run({"nk", "show", "{\"drude\": {\"plasma_eV\": 9, \"gamma_eV\": 0.1}}"}).code == 0);
  CHECK(karat_run({"nk", "compare", "Au/Johnson", "alloy:yellow-gold-18k"}).code == 0);
  const Outcome list = karat_run({"nk", "list", "--alloys", "rose"});
  CHECK(list.code == 0);
  CHECK_THAT(list.out, Contains("alloy:rose-gold-18k") && !Contains("silver"));
}

TEST_CASE("slips are answered with what was meant", "[nk-argument]") {
  CHECK_THAT(karat_run({"nk", "list", "gold"}).err, Contains("karat nk search gold"));
  CHECK_THAT(karat_run({"nk", "eval", "Au/Johnson", "--nm", "0.55"}).err,
             Contains("--nm is in nm: 0.55 um is 550"));
  CHECK_THAT(karat_run({"nk", "plot", "Au/Johnson", "--nm", "0.3:0.9", "-o", "x.svg"}).err,
             Contains("--nm is in nm: 0.3 to 0.9 um is 300:900"));
  CHECK_THAT(karat_run({"nk", "colour", "main/C/Peter"}).err,
             Contains("--extrapolate clamp") && !Contains("\"clamp\""));
  const Outcome size = karat_run({"nk", "plot", "Au/Johnson", "--size", "800", "-o", "x.svg"});
  CHECK(size.code == 2);
  CHECK_THAT(size.err, Contains("found \"800\", allowed: WIDTHxHEIGHT as 640x480"));
  CHECK_THAT(karat_run({"nk", "plot", "--help"}).out, Contains("--size WxH"));
}
