// `karat fresnel study` as its users meet it: the files, and the page in a browser.
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
#include "spectral/support/error.h"

using namespace karat;
namespace fs = std::filesystem;
using Catch::Matchers::Contains;

namespace {

// A folder that vanishes with the test.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("karat-study-" + std::to_string(std::rand()));
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

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
  const std::string dom = (folder.path / "dom.html").string(), log = (folder.path / "log").string();
  const std::string command = "timeout 120 " + browser() +
                              " --headless --no-sandbox --disable-gpu --enable-logging=stderr"
                              " --virtual-time-budget=5000 --user-data-dir='" +
                              (folder.path / "profile").string() + "' --dump-dom 'file://" +
                              page.string() + "' >'" + dom + "' 2>'" + log + "'";
  REQUIRE(std::system(command.c_str()) == 0);
  const std::string shown = text_of(dom), console = text_of(log);
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
