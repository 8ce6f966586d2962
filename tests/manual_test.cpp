// The manual says what the program says: pages that are printed, lists that must be complete,
// scenes that must load.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "render/scene_schema.h"
#include "spectral/spectrum_file.h"
#include "tests/run_cli.h"

namespace karat {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;

std::string page(const std::string& name) {
  std::ifstream stream(fs::path(KARAT_TEST_DOCS_DIR) / name);
  REQUIRE(stream);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// The text between ```json or a shell's "cat > FILE.json <<'END'" and its end.
std::vector<std::string> json_blocks(const std::string& text) {
  std::vector<std::string> blocks;
  std::istringstream lines(text);
  std::string line, block, end;
  while (std::getline(lines, line)) {
    if (!end.empty() && line == end) {
      blocks.push_back(std::exchange(block, ""));
      end.clear();
    } else if (!end.empty()) {
      block += line + "\n";
    } else if (line == "```json") {
      end = "```";
    } else if (line.find(".json <<'END'") != std::string::npos) {
      end = "END";
    }
  }
  return blocks;
}

TEST_CASE("docs/scene_reference.md is what karat schema --markdown prints", "[manual]") {
  const test::Outcome outcome = test::karat_run({"schema", "--markdown"});
  CHECK(outcome.code == 0);
  CHECK(outcome.out == page("scene_reference.md"));
}

TEST_CASE("the manual lists every alloy", "[manual]") {
  const std::string text = page("alloys_and_layers.md");
  for (const std::string& name : data_names("alloys")) CHECK_THAT(text, Contains("`" + name + "`"));
}

TEST_CASE("whole scenes in the manual conform to the schema", "[manual]") {
  int scenes = 0;
  for (const auto& entry : fs::directory_iterator(KARAT_TEST_DOCS_DIR)) {
    if (entry.path().extension() != ".md") continue;
    for (const std::string& block : json_blocks(page(entry.path().filename().string()))) {
      const Json document = Json::parse(block, nullptr, false);
      if (!document.is_object() || !document.contains("camera")) continue;  // a part of a scene
      INFO(entry.path().filename().string() << ": " << block);
      CHECK(schema_violation(document) == "");
      ++scenes;
    }
  }
  CHECK(scenes >= 3);  // first_scene.md, scenes.md, tables.md
}

}  // namespace
}  // namespace karat
