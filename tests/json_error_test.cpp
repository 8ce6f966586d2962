#include "render/json_error.h"

#include <catch2/catch.hpp>

#include "render/scene_json.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

std::string error_of(const std::string& text) {
  try {
    parse_json(text, "s.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST_CASE("text that is not JSON: the mistake is named where it was made", "[json_error]") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"{\n \"a\": 1,\n}", "s.json: line 2, column 8: a comma before \"}\""},
      {"[1, 2,]", "s.json: line 1, column 6: a comma before \"]\""},
      {"{\n \"a\": 1\n \"b\": 2}", "s.json: line 2 ends without a comma"},
      {"{\"a\": {}\n\n \"b\": 2}", "s.json: line 1 ends without a comma"},
      {"{\"a\": \"x\\\"\" \"b\": 2}", "s.json: line 1, column 13: no comma before \"b\""},
      {"[1 2]", "s.json: line 1, column 4: no comma before 2"},
      {"[[1] [2]]", "s.json: line 1, column 6: no comma before ["},
      {"[1, , 2]", "s.json: line 1, column 5: two commas"},
      {"[, 2]", "s.json: line 1, column 2: a comma without a value before it"},
      {"{\"a\": }", "s.json: line 1, column 7: no value before \"}\""},
      {"{\"a\" 1}", "s.json: line 1, column 5: \":\" and a value are missing after the key"},
      {"{\"a\" = 1}",
       "s.json: line 1, column 6: \":\" stands between a key and its value, not \"=\""},
      {"[1}", "s.json: line 1, column 3: \"}\" where \"]\" must stand"},
      {"{\n// size\n\"a\": 1}", "s.json: line 2, column 1: comments are not JSON"},
      {"{\"a\": 1, /* size */ \"b\": 1}", "s.json: line 1, column 10: comments are not JSON"},
      {"{\"a\": 1 # size\n}", "s.json: line 1, column 9: comments are not JSON"},
      {"{'a': 1}", "s.json: line 1, column 2: texts stand in double quotes, not in single ones"},
      {"{a: 1}", "s.json: line 1, column 2: a key stands in double quotes: \"a\""},
      {"[.5]", "s.json: line 1, column 2: .5 is not a number in JSON (those are 0.5, -2, 1e-3)"},
      {"[1., 2]", "s.json: line 1, column 2: 1. is not a number in JSON (those are 0.5, -2, 1e-3)"},
      {"[+1]", "s.json: line 1, column 2: +1 is not a number in JSON (those are 0.5, -2, 1e-3)"},
      {"[01]", "s.json: line 1, column 2: 01 is not a number in JSON (those are 0.5, -2, 1e-3)"},
      {"{\"a\": 1} x", "s.json: line 1, column 10: x after the last bracket"},
      {"{\"a\": 1", "s.json: line 1: the file ends where \"}\" is missing"},
      {"{\"a\": [1,\n", "s.json: line 2: the file ends where \"]\" is missing"},
      {"{\"a", "s.json: line 1: the file ends inside a text in quotes"},
      {"{\"a\n\": 1}", "s.json: line 1, column 4: the text in quotes has no end on this line"},
      {"[\"C:\\dir\"]",
       "s.json: line 1, column 6: a backslash in a text is written \\\\ (and paths with / as "
       "well)"},
      {"[\"\x01\"]", "s.json: line 1, column 3: a text cannot hold the control character 0x01"},
      {"[\"\xff\"]", "s.json: line 1, column 3: byte 0xff is not UTF-8; save the file as UTF-8"},
      {"[\"\xc3\xa4\", x]",
       "s.json: line 1, column 7: x is not a value in JSON: texts stand in double "
       "quotes; others are numbers, true, false and null"},
      {"", "s.json: the file is empty"},
      {" \n", "s.json: the file is empty"},
      {std::string("{\0\"\0", 4), "s.json: the file is UTF-16; save it as UTF-8"},
      {"\xff\xfe{", "s.json: the file is UTF-16; save it as UTF-8"},
      {"\x89PNG\r\n\x1a\n", "s.json: a PNG image, not a JSON file"}};
  for (const auto& [text, expected] : rows) {
    INFO(text);
    CHECK(error_of(text) == expected);
  }
}

TEST_CASE("words of JSON in other spellings", "[json_error]") {
  for (const std::string word : {"True", "None", "NaN", "nul", "red"}) {
    INFO(word);
    CHECK_THAT(error_of("{\"a\": " + word + "}"),
               Catch::StartsWith("s.json: line 1, column 7: " + word + " is not a value in JSON"));
  }
}

TEST_CASE("no text makes the reader leave the text or print control bytes", "[json_error]") {
  const std::string good = R"({"a": [1.5, -2e3, "x\"\\", {"b": true}], "c": null, "d": ""})";
  const std::string bytes = std::string("{}[],:\"'\\/#=x1.-+e \n\t\x01\x7f\x80\xff") + '\0';
  for (std::size_t at = 0; at <= good.size(); ++at) {
    for (const char byte : bytes) {
      for (const bool cut : {false, true}) {
        const std::string text =
            good.substr(0, at) + byte + (cut ? "" : good.substr(std::min(at + 1, good.size())));
        for (const char c : error_of(text)) {
          const auto shown = static_cast<unsigned char>(c);
          if (shown < 0x20 || shown == 0x7f) FAIL("control byte for: " << text);
        }
      }
    }
  }
}

}  // namespace
}  // namespace karat
