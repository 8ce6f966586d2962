#include "materials/index/element.h"

#include <algorithm>
#include <cctype>

#include "spectral/spectrum_file.h"
#include "spectral/support/data_path.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

const SpectrumFile& elements() {
  static const SpectrumFile file(data_path("elements/elements.json"));
  return file;
}

double above_zero(const std::string& key) {
  const double number = elements().number(key);
  if (number > 0.0) return number;
  throw InputError(data_path("elements/elements.json"), key, "must be above 0");
}

}  // namespace

std::optional<Element> find_element(const std::string& symbol) {
  const auto letter = [](unsigned char c) { return std::isalpha(c) != 0; };
  const std::string place = "elements/" + symbol;
  if (symbol.empty() || !std::all_of(symbol.begin(), symbol.end(), letter)) return std::nullopt;
  if (!elements().has(place)) return std::nullopt;
  return Element{symbol, above_zero(place + "/density"), above_zero(place + "/mass")};
}

std::optional<Element> element_of_table(const std::string& name) {
  const auto shelf = name.find('/');
  if (shelf == std::string::npos) return std::nullopt;
  const auto book = name.find('/', shelf + 1);
  if (book == std::string::npos) return std::nullopt;
  return find_element(name.substr(shelf + 1, book - shelf - 1));
}

std::string elements_source() { return elements().text("source"); }

}  // namespace karat
