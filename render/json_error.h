// What is wrong with text that is not JSON, in words for whoever wrote it.
#pragma once

#include <cstddef>
#include <string>

namespace karat {

// Where the parser stopped: `byte` is how many bytes it had read (nlohmann's parse_error::byte),
// and `what` its own message. `open`: the bracket that waits for its end, '{' or '[', or 0.
struct JsonStop {
  std::size_t byte = 0;
  std::string what;
  char open = 0;
};

struct JsonErrorText {
  std::string place;  // "line 8, column 18", or "" for the whole file
  std::string message;
};

// The likeliest mistake, from the text around the place. Never contains control bytes.
JsonErrorText json_error(const std::string& text, const JsonStop& stop);

// What the first bytes say a file is when it is no JSON text: "a PNG image", "UTF-16 text", ..., or
// "".
std::string foreign_format(const std::string& text);

}  // namespace karat
