#include "materials/index/index_table_file.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <utility>

#include "materials/index/index_formula.h"
#include "materials/index/index_markup.h"
#include "materials/index/index_rows.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr std::uintmax_t kLargestFile = std::uintmax_t{16} << 20;
constexpr std::size_t kMostBlocks = 64, kMostCoefficients = 64;

// What is known at the top of a file of the database; a key that is none of these is a slip.
const std::vector<std::string> kKnownKeys = {"REFERENCES", "COMMENTS", "CONDITIONS",
                                             "DATA",       "SPECS",    "PROPERTIES",
                                             "NAMES",      "LINKS",    "ABOUT"};
const std::vector<std::string> kBlockTypes = {
    "tabulated nk", "tabulated n", "tabulated k", "tabulated n2", "formula 1",
    "formula 2",    "formula 3",   "formula 4",   "formula 5",    "formula 6",
    "formula 7",    "formula 8",   "formula 9"};

std::string line_of(const YAML::Mark& mark) {
  return mark.is_null() ? std::string() : fmt::format("line {}", mark.line + 1);
}

class Loader {
 public:
  Loader(std::string origin, Provenance provenance, std::vector<IndexBlock>& blocks)
      : origin_(std::move(origin)), provenance_(std::move(provenance)), blocks_(blocks) {}

  IndexTablePtr load(const std::string& text) {
    const YAML::Node root = YAML::Load(text);
    if (!root.IsMap()) fail(root, "not an index table: no REFERENCES, no DATA");
    read_head(root);
    read_data(root["DATA"]);
    return finish();
  }

 private:
  [[noreturn]] void fail(const YAML::Node& node, const std::string& message) const {
    throw InputError(origin_, node ? line_of(node.Mark()) : "", message);
  }
  void warn(std::string message) { warnings_.push_back(std::move(message)); }

  void read_head(const YAML::Node& root) {
    for (const auto& entry : root) {
      const std::string key = scalar(entry.first, "a key");
      if (std::find(kKnownKeys.begin(), kKnownKeys.end(), key) != kKnownKeys.end()) continue;
      const std::string near = nearest_name(key, kKnownKeys);
      warn(fmt::format("{}: \"{}\" is not read{}", line_of(entry.first.Mark()), plain_text(key),
                       near.empty() ? "" : "; is it meant to be " + near + "?"));
    }
    provenance_.reference = head_text(root["REFERENCES"]);
    provenance_.comments = head_text(root["COMMENTS"]);
    provenance_.conditions = head_text(root["CONDITIONS"]);
    if (provenance_.reference.empty())
      warn("no REFERENCES: nobody can tell where this was measured");
  }

  // A text, or the flat map that CONDITIONS is: "temperature: 293; substrate: glass".
  static std::string head_text(const YAML::Node& node) {
    if (!node) return "";
    if (node.IsScalar()) return plain_text(node.Scalar());
    std::string text;
    for (const auto& entry : node) {
      const YAML::Node& value = node.IsMap() ? entry.second : entry;
      if (!value.IsScalar()) continue;
      if (!text.empty()) text += "; ";
      if (node.IsMap() && entry.first.IsScalar()) text += plain_text(entry.first.Scalar()) + ": ";
      text += plain_text(value.Scalar());
    }
    return text;
  }

  std::string scalar(const YAML::Node& node, const std::string& what) const {
    if (!node.IsScalar()) fail(node, what + " must be plain text");
    return node.Scalar();
  }
  std::string member(const YAML::Node& block, const char* key, const std::string& of) const {
    const YAML::Node node = block[key];
    if (!node) fail(block, fmt::format("{} has no \"{}\"", of, key));
    return scalar(node, fmt::format("\"{}\" of {}", key, of));
  }

  void read_data(const YAML::Node& data) {
    if (!data) throw InputError(origin_, "", "no DATA: an index table lists n, or n and k, there");
    if (!data.IsSequence() || data.size() == 0 || data.size() > kMostBlocks) {
      fail(data, fmt::format("DATA must be a list of 1 to {} blocks", kMostBlocks));
    }
    for (std::size_t i = 0; i < data.size(); ++i) {
      const std::string place = fmt::format("DATA block {}", i + 1);
      if (!data[i].IsMap()) fail(data[i], place + " must have a \"type\"");
      read_block(data[i], place);
    }
  }

  void read_block(const YAML::Node& block, const std::string& place) {
    const std::string type = member(block, "type", place);
    if (std::find(kBlockTypes.begin(), kBlockTypes.end(), type) == kBlockTypes.end()) {
      fail(block["type"], place + ": " + unknown_name_message("block type", type, kBlockTypes));
    }
    if (type == "tabulated n2") {
      warn(place + ": the nonlinear index n2 is not used: light here is too weak for it to matter");
      n2_seen_ = true;
    } else if (type.starts_with("tabulated ")) {
      read_rows(block, type.substr(type.find(' ') + 1), place);
    } else {
      read_formula(block, type.back() - '0', place);
    }
  }

  void read_rows(const YAML::Node& block, const std::string& names, const std::string& place) {
    const std::string text = member(block, "data", place + " (tabulated " + names + ")");
    const YAML::Mark mark = block["data"].Mark();
    BlockPlace where{origin_, place, mark.is_null() ? 0 : mark.line + 2};
    IndexRows rows = index_rows(text, names, where, warnings_);
    blocks_.push_back({"tabulated " + names,
                       rows.wavelengths_nm.size(),
                       {rows.wavelengths_nm.front(), rows.wavelengths_nm.back()}});
    SpectrumPtr first = rows_curve(rows.wavelengths_nm, std::move(rows.first));
    take(names[0] == 'n' ? n_ : k_, first, names.substr(0, 1), place);
    if (names.size() == 2) {
      take(k_, rows_curve(std::move(rows.wavelengths_nm), std::move(rows.second)), "k", place);
    }
  }

  void read_formula(const YAML::Node& block, int number, const std::string& place) {
    const std::string what = fmt::format("{} (formula {})", place, number);
    const std::string at = block.Mark().is_null() ? what : what + ", " + line_of(block.Mark());
    const char* key = block["wavelength_range"] ? "wavelength_range" : "range";
    const auto range = index_numbers(member(block, key, what), origin_, at + ", " + key);
    if (range.size() != 2 || !(range[0] > 0.0 && range[0] <= range[1] && range[1] <= 1e12)) {
      fail(block, what + ": wavelength_range must be two increasing wavelengths in micrometres");
    }
    DispersionFormula formula{
        number, index_numbers(member(block, "coefficients", what), origin_, at + ", coefficients")};
    check_coefficients(formula, block, what);
    const WavelengthRange stated{range[0] * 1000.0, range[1] * 1000.0};
    for (const double pole : formula.resonances_um()) {
      if (pole >= range[0] && pole <= range[1]) {
        warn(fmt::format("{}: a resonance at {:.7g} nm, within its range", what, pole * 1000.0));
      }
    }
    const FormulaCurve curve = formula_curve(std::move(formula), stated, origin_ + ": " + at);
    if (!curve.gaps.empty()) {
      warn(fmt::format("{}: n^2 is negative or infinite at {}", what, curve.gaps));
    }
    blocks_.push_back({fmt::format("formula {}", number), 0, stated});
    take(n_, curve.n, "n", place);
  }

  void check_coefficients(const DispersionFormula& formula, const YAML::Node& block,
                          const std::string& what) {
    const std::size_t count = formula.coefficients.size();
    if (count == 0 || count > kMostCoefficients) {
      fail(block,
           fmt::format("{}: {} coefficients; 1 to {} are allowed", what, count, kMostCoefficients));
    }
    const bool pairs = formula.number != 4 && formula.number <= 6;
    if (pairs && count % 2 == 0) {
      warn(fmt::format("{}: {} coefficients, so the last pair lacks its second, taken as 0", what,
                       count));
    }
  }

  // The first block that lists a quantity counts, as on the database's own site.
  void take(SpectrumPtr& slot, SpectrumPtr curve, const std::string& quantity,
            const std::string& place) {
    if (slot) {
      warn(
          fmt::format("{}: lists {} again; the first block that does so is used", place, quantity));
    } else {
      slot = std::move(curve);
    }
  }

  IndexTablePtr finish() {
    if (!n_ && k_) {
      throw InputError(origin_, "DATA",
                       "k alone is listed: a material needs n at the same wavelengths");
    }
    if (!n_) {
      throw InputError(origin_, "DATA",
                       n2_seen_ ? "only the nonlinear index n2 is listed" : "lists no n");
    }
    if (k_ &&
        (k_->range().min_nm > n_->range().max_nm || k_->range().max_nm < n_->range().min_nm)) {
      warn(fmt::format("k covers {:.7g} to {:.7g} nm, where n is not known; n alone is used",
                       k_->range().min_nm, k_->range().max_nm));
      k_.reset();
    }
    return index_from_spectra(n_, k_, std::move(provenance_), std::move(warnings_));
  }

  std::string origin_;
  Provenance provenance_;
  std::vector<IndexBlock>& blocks_;
  std::vector<std::string> warnings_;
  SpectrumPtr n_;
  SpectrumPtr k_;
  bool n2_seen_ = false;
};

// YAML forbids tabs in indentation; some files have them there, and between columns. They stand for
// blanks up to the next multiple of eight columns, as their authors' editors showed them.
std::string without_tabs(const std::string& text) {
  if (text.find('\t') == std::string::npos) return text;
  std::string result;
  std::size_t line_start = 0;
  for (const char c : text) {
    if (c == '\t') {
      result.append(8 - (result.size() - line_start) % 8, ' ');
    } else {
      result += c;
      if (c == '\n') line_start = result.size();
    }
  }
  return result;
}

IndexTablePtr load(const std::string& text, const std::string& origin, Provenance provenance,
                   std::vector<IndexBlock>& blocks) {
  if (text.size() > kLargestFile) {
    throw InputError(
        origin, "",
        fmt::format("{} bytes; an index table has at most {}", text.size(), kLargestFile));
  }
  try {
    return Loader(origin, std::move(provenance), blocks).load(without_tabs(text));
  } catch (const YAML::Exception& error) {
    throw InputError(origin, line_of(error.mark), "not valid YAML: " + error.msg);
  }
}

}  // namespace

std::string read_index_file(const std::string& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::is_regular_file(status)) {
    throw InputError(path, "",
                     std::filesystem::is_directory(status) ? "a folder, not a file"
                     : std::filesystem::exists(status)     ? "not a regular file"
                                                           : "no such file");
  }
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw InputError(path, "", "cannot be read: " + error.message());
  if (size > kLargestFile) {
    throw InputError(path, "",
                     fmt::format("{} bytes; an index table has at most {}", size, kLargestFile));
  }
  std::string text(static_cast<std::size_t>(size), '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file.read(text.data(), static_cast<std::streamsize>(size))) {
    throw InputError(path, "", "cannot be read");
  }
  return text;
}

IndexTablePtr load_index_table_file(const std::string& path, const std::string& name) {
  std::vector<IndexBlock> blocks;
  return load_index_table_file(path, name, blocks);
}

IndexTablePtr load_index_table_file(const std::string& path, const std::string& name,
                                    std::vector<IndexBlock>& blocks) {
  return load(read_index_file(path), path, {name, path, "", "", ""}, blocks);
}

IndexTablePtr load_index_table_text(const std::string& text, const std::string& name) {
  std::vector<IndexBlock> blocks;
  return load(text, name, {name, "", "", "", ""}, blocks);
}

}  // namespace karat
