// `karat fresnel study` as its users meet it: the files, and the page in a browser.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/karat/fresnel/study_options.h"
#include "apps/karat/run_karat.h"
#include "materials/fresnel.h"
#include "materials/index/index_catalogue.h"
#include "spectral/support/error.h"
#include "tests/temporary_folder.h"

using namespace karat;
namespace fs = std::filesystem;
using Catch::Matchers::Contains;

namespace {

using Folder = test::TemporaryFolder;

int run_study(const fs::path& folder, std::vector<std::string> more) {
  std::vector<std::string> arguments{"karat", "fresnel", "study",        "--progress",
                                     "none",  "-o",      folder.string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  std::vector<const char*> argv;
  for (const auto& argument : arguments) argv.push_back(argument.c_str());
  return run_karat(static_cast<int>(argv.size()), argv.data());
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    ++found;
  return found;
}

class HalfMirror final : public FresnelModel {
 public:
  std::string description() const override { return "reflects a half"; }
  std::string source() const override { return "a test"; }
  FresnelTables prepare(const LatticeIndex&) const override { return {}; }
  SampledSpectrum reflectance(const FresnelTables&, int, float) const override {
    return SampledSpectrum(0.5f);
  }
  Scalar evaluate(ComplexIndex, double) const override { return {std::nullopt, std::nullopt, 0.5}; }
};

std::string browser() {
  for (const char* path :
       {"/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"}) {
    if (fs::exists(path)) return path;
  }
  return "";
}

struct OpenedPage {
  std::string shown, console;
};

// The page as a browser has it after its scripts have run.
OpenedPage opened(const fs::path& page) {
  const fs::path folder = page.parent_path();
  const std::string dom = (folder / "dom.html").string(), log = (folder / "log").string();
  const std::string command = "timeout 120 " + browser() +
                              " --headless --no-sandbox --disable-gpu --enable-logging=stderr"
                              " --window-size=1400,1000 --virtual-time-budget=10000"
                              " --user-data-dir='" +
                              (folder / "profile").string() + "' --dump-dom 'file://" +
                              page.string() + "' >'" + dom + "' 2>'" + log + "'";
  REQUIRE(std::system(command.c_str()) == 0);
  return {text_of(dom), text_of(log)};
}

const std::vector<std::string> kSections{"summary", "reflectance", "errors", "colour", "cost",
                                         "render",  "pareto",      "tables", "method"};

}  // namespace

TEST_CASE("a study writes its summary with the documented keys, and every table",
          "[fresnel_report]") {
  const Folder folder;
  auto& registry = Registry<FresnelModel>::instance();
  registry.add("half-mirror", std::make_unique<const HalfMirror>());
  const int code = run_study(
      folder.path, {"--no-render", "--nk", "main/Au/Johnson,main/Al/Rakic", "--models",
                    "exact,schlick,half-mirror", "--nm", "400:700:20", "--angles", "0:90:5"});
  registry.remove("half-mirror");
  REQUIRE(code == 0);
  const auto study = nlohmann::json::parse(text_of(folder.path / "study.json"));
  CHECK(study["grid"]["wavelengths_nm"].size() == 16);
  CHECK(study["grid"]["angles_deg"].size() == 19);
  REQUIRE(study["results"].size() == 6);
  bool found = false;
  for (const auto& result : study["results"]) {
    for (const char* key : {"max_abs_error", "mean_abs_error", "rms_error", "delta_e_mean",
                            "delta_e_max", "cost_relative"}) {
      CAPTURE(key, result["model"].get<std::string>());
      CHECK(result[key].is_number());
    }
    found = found || result["model"] == "half-mirror";
  }
  CHECK(found);
  CHECK(study["machine"]["flags"].get<std::string>().size() > 2);
  CHECK_FALSE(study["summary"].empty());
  for (const char* file :
       {"csv/summary.csv", "csv/cost.csv", "csv/colour.csv", "csv/tables.csv",
        "csv/reflectance-Au-Johnson.csv", "csv/albedo-Al-Rakic.csv",
        "figures/reflectance-Au-Johnson.svg", "figures/error-against-cost.svg", "index.html"}) {
    CAPTURE(file);
    CHECK(fs::file_size(folder.path / file) > 100);
  }
  CHECK(count(text_of(folder.path / "csv/reflectance-Au-Johnson.csv"), "\n") == 1 + 16 * 19);
}

TEST_CASE("the page of a study with renders needs nothing else, and works in a browser",
          "[fresnel_report]") {
  const Folder folder;
  REQUIRE(run_study(folder.path, {"--nk", "main/Cu/Johnson", "--models", "exact,schlick,large-nk",
                                  "--render-size", "48x27", "--spp", "2"}) == 0);
  const fs::path page = folder.path / "index.html";
  const std::string html = text_of(page);
  CHECK_THAT(html, Contains("data:image/png;base64,"));
  for (const char* outside : {"src=\"http", "href=\"http", "@import", "url(http"}) {
    CHECK(html.find(outside) == std::string::npos);
  }
  if (browser().empty()) {
    WARN("skipped: no Chromium to open the page in");
    return;
  }
  const auto [shown, console] = opened(page);
  CHECK(console.find("CONSOLE") == std::string::npos);
  CHECK_THAT(shown, Contains("data-ready=\"yes\""));
  for (std::size_t i = 0; i < kSections.size(); ++i) {
    CAPTURE(kSections[i]);
    const std::size_t begin = shown.find("<section id=\"" + kSections[i] + "\"");
    REQUIRE(begin != std::string::npos);
    const std::string section = shown.substr(begin, shown.find("</section>", begin) - begin);
    // A drawing or a filled table in every section.
    CHECK(count(section, "<td") + count(section, "<path") > 3);
  }
  CHECK(count(shown, "<button class=\"model\"") == 3);
  CHECK(count(shown, "data:image/png;base64,") >= 3);
}

// The page, with a script that acts at its end, and what that wrote down.
nlohmann::json actions_on(const fs::path& page) {
  const fs::path acted = page.parent_path() / "acted.html";
  std::string html = text_of(page);
  html.insert(html.rfind("</body>"), "<script>" + text_of(KARAT_TEST_REPORT_ACTIONS) + "</script>");
  std::ofstream(acted, std::ios::binary) << html;
  const auto [shown, console] = opened(acted);
  CHECK(console.find("CONSOLE") == std::string::npos);
  const std::string begin = "<pre id=\"actions\">";
  const std::size_t at = shown.find(begin);
  REQUIRE(at != std::string::npos);
  const std::size_t first = at + begin.size();
  return nlohmann::json::parse(shown.substr(first, shown.find("</pre>", first) - first));
}

TEST_CASE("the report answers its reader: values, zoom, models, choices, order",
          "[fresnel_report]") {
  if (browser().empty()) {
    WARN("skipped: no Chromium to open the page in");
    return;
  }
  const Folder folder;
  REQUIRE(run_study(folder.path, {"--no-render", "--nk", "main/Cu/Johnson,main/Ag/Johnson",
                                  "--models", "exact,schlick,large-nk"}) == 0);
  const auto seen = actions_on(folder.path / "index.html");
  const auto list = [&](const char* key) { return seen[key].get<std::vector<std::string>>(); };
  const auto text = [&](const char* key) { return seen[key].get<std::string>(); };

  // Values under the pointer are those of copper at 550 nm and 60 degrees.
  const ComplexIndex copper = find_index_table("main/Cu/Johnson")->at(550.0);
  CHECK_THAT(text("hover"), Contains("angle 60 deg"));
  for (const char* name : {"exact", "schlick", "large-nk"}) {
    const FresnelModel& model = *Registry<FresnelModel>::instance().find(name);
    const std::string value =
        fmt::format("{:.3g}  {}", model.evaluate(copper, 0.5).unpolarised, name);
    CHECK_THAT(text("hover"), Contains(value));
  }
  CHECK(text("left").empty());
  CHECK_THAT(text("map"), Contains("89 deg") && Contains("error") && Contains("exact 0.9"));
  CHECK_THAT(text("mark"), Contains("all materials") && Contains("cost"));

  // The wheel scrolls the page and zooms with Ctrl; dragging moves; "whole range" goes back.
  CHECK(list("ticks").front() == "0");
  CHECK(seen["wheel_alone"] == seen["ticks"]);
  CHECK(seen["zoomed"] != seen["ticks"]);
  CHECK(seen["dragged"] != seen["zoomed"]);
  CHECK(seen["reset_offered"] == true);
  CHECK(seen["whole"] == seen["ticks"]);
  CHECK(seen["double_click"] != seen["ticks"]);

  CHECK(seen["lines"] == 3);
  CHECK(seen["without_schlick"]["lines"] == 2);
  using Names = std::vector<std::string>;
  CHECK(seen["without_schlick"]["pressed"] == Names{"exact", "large-nk"});
  CHECK(seen["without_schlick"]["rows"] == Names{"exact", "large-nk"});
  CHECK(seen["schlick_alone"] == Names{"exact", "schlick"});
  CHECK(seen["all"] == Names{"exact", "schlick", "large-nk"});

  CHECK_THAT(list("other_material")[0], Contains("Ag Johnson at 550 nm, unpolarised"));
  CHECK_THAT(list("other_material")[1], Contains("Ag Johnson"));
  CHECK_THAT(seen["p_polarised"]["titles"][0].get<std::string>(), Contains("p polarised"));
  CHECK(seen["p_polarised"]["lines"] == 2);  // schlick knows no polarisation
  CHECK_THAT(list("first_wavelength")[0], Contains("380 nm"));
  auto down = list("costs");
  std::reverse(down.begin(), down.end());
  CHECK(list("costs_sorted_down") == down);
}

TEST_CASE("a second study leaves nothing of the first one in its folder", "[fresnel_report]") {
  const Folder folder;
  const std::vector<std::string> coarse{"--no-render", "--nm",     "400:700:100",  "--angles",
                                        "0:90:30",     "--models", "exact,schlick"};
  auto first = coarse, second = coarse;
  first.insert(first.end(), {"--nk", "main/Au/Johnson"});
  second.insert(second.end(), {"--nk", "main/Cu/Johnson"});
  REQUIRE(run_study(folder.path, first) == 0);
  std::ofstream(folder.path / "csv/mine.csv") << "kept";
  REQUIRE(run_study(folder.path, second) == 0);
  for (const char* file : {"csv/reflectance-Au-Johnson.csv", "csv/albedo-Au-Johnson.csv",
                           "figures/error-maps-Au-Johnson.svg"}) {
    CAPTURE(file);
    CHECK_FALSE(fs::exists(folder.path / file));
  }
  CHECK(fs::exists(folder.path / "csv/reflectance-Cu-Johnson.csv"));
  CHECK(fs::exists(folder.path / "csv/mine.csv"));
}

TEST_CASE("a study refuses what it cannot mean", "[fresnel_report]") {
  const Folder folder;
  const fs::path study = folder.path / "study";
  CHECK(run_study(study, {"--models", "exact,exact"}) == 2);
  CHECK(run_study(study, {"--models", "exact,schlik"}) == 2);
  CHECK(run_study(study, {"--nm", "780:380:5"}) == 2);
  CHECK(run_study(study, {"--angles", "0:91:1"}) == 2);
  CHECK(run_study(study, {"--nk", "main/Au/Johnson,Au/Johnson"}) == 3);
  CHECK(run_study("", {"--no-render"}) == 2);
  CHECK_FALSE(fs::exists(study));
}

TEST_CASE("steps of a grid are read or refused with what is allowed", "[fresnel_report]") {
  CHECK(parse_steps("--nm", "400:700:100", 1, 1e6) == std::vector<double>{400, 500, 600, 700});
  CHECK(parse_steps("--angles", "45:45:1", 0, 90) == std::vector<double>{45});
  for (const char* text :
       {"", "400", "400:700", "400:700:0", "400:700:-5", "700:400:5", "400:700:7",
        "400:700:5:", "a:b:c", "400:700:0.001", "nan:700:5", "0:89:1x"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(parse_steps("--nm", text, 1, 1e6), InputError);
  }
  CHECK_THROWS_WITH(parse_steps("--angles", "0:95:1", 0, 90),
                    Contains("--angles") && Contains("0 to 90"));
  CHECK(parse_size("64x48") == std::pair{64, 48});
  for (const char* text : {"", "64", "64x", "x48", "8x8", "64x48x2", "99999x99"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(parse_size(text), InputError);
  }
}

TEST_CASE("all usual tables of a study exist and cover its wavelengths", "[fresnel_report]") {
  CHECK(usual_study_tables().size() == 12);
  CHECK(usual_study_models().front() == "exact");
}
