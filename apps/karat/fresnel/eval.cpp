// karat fresnel eval: the Fresnel models at given indices and angles.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iostream>
#include <limits>
#include <memory>
#include <string_view>

#include "apps/karat/command.h"
#include "apps/karat/fresnel/named_values.h"
#include "materials/fresnel_eval.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

using Models = Registry<FresnelModel>;

// A column of the input: where its number goes and what it may be.
struct Column {
  const char* name;
  double FresnelQuery::*number;
  double min, max;
  const char* allowed;
};
// Far above any index; the equations' eighth powers of it are numbers still.
constexpr double kLargest = 1e30;
constexpr Column kColumns[]{
    {"n", &FresnelQuery::n, 0.0, kLargest, "a number from 0 to 1e30"},
    {"k", &FresnelQuery::k, 0.0, kLargest, "a number from 0 to 1e30"},
    {"theta_deg", &FresnelQuery::theta_deg, 0.0, 90.0, "an angle from 0 to 90 degrees"},
    {"n_exterior", &FresnelQuery::n_exterior, 1e-3, 1e3, "a number from 0.001 to 1000"},
};
constexpr std::size_t kRequiredColumns = 3;

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0;;) {
    const std::size_t comma = line.find(',', begin);
    cells.push_back(trimmed(line.substr(begin, comma - begin)));
    if (comma == std::string_view::npos) return cells;
    begin = comma + 1;
  }
}

// Reads lines of bounded length and knows where it is.
class QueryReader {
 public:
  QueryReader(std::istream& in, std::string file) : in_(in), file_(std::move(file)) {
    if (!next_line())
      throw InputError(file_, "", "is empty; a header line " + header() + " is needed");
    if (line_.substr(0, 3) == "\xEF\xBB\xBF") line_.remove_prefix(3);
    read_header();
  }

  std::string_view line() const { return line_; }

  // Blank lines are passed over. False at the end of the file.
  bool next(FresnelQuery& query) {
    do {
      if (!next_line()) return false;
    } while (line_.empty());
    const auto cells = cells_of(line_);
    if (cells.size() != order_.size()) {
      fail("", fmt::format("{} columns, where the header has {}", cells.size(), order_.size()));
    }
    for (std::size_t i = 0; i < cells.size(); ++i)
      query.*order_[i]->number = number(cells[i], *order_[i]);
    return true;
  }

 private:
  static std::string header() { return "\"n,k,theta_deg\" or \"n,k,theta_deg,n_exterior\""; }

  [[noreturn]] void fail(const std::string& column, const std::string& message) const {
    const std::string place = fmt::format("line {}", number_);
    throw InputError(file_, column.empty() ? place : place + ", column " + column, message);
  }

  bool next_line() {
    if (!in_.getline(buffer_, sizeof buffer_)) {
      if (in_.bad()) throw InputError(file_, "", "cannot be read");
      if (in_.gcount() == 0) return false;
      ++number_;
      fail("", fmt::format("longer than {} characters", sizeof buffer_ - 1));
    }
    ++number_;
    line_ = trimmed(buffer_);
    return true;
  }

  void read_header() {
    for (const std::string_view cell : cells_of(line_)) {
      const auto column = std::find_if(std::begin(kColumns), std::end(kColumns),
                                       [&](const Column& c) { return cell == c.name; });
      if (column == std::end(kColumns)) {
        fail(std::string(cell), "unknown column; the header must be " + header());
      }
      if (std::find(order_.begin(), order_.end(), column) != order_.end()) {
        fail(column->name, "named twice in the header");
      }
      order_.push_back(column);
    }
    for (std::size_t i = 0; i < kRequiredColumns; ++i) {
      if (std::find(order_.begin(), order_.end(), &kColumns[i]) == order_.end()) {
        fail(kColumns[i].name, "missing from the header, which must be " + header());
      }
    }
  }

  double number(std::string_view cell, const Column& column) const {
    double value = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    const bool parsed = error == std::errc() && end == cell.data() + cell.size();
    if (!(parsed && value >= column.min && value <= column.max)) {
      fail(column.name, fmt::format("found \"{}\", needs {}", cell, column.allowed));
    }
    return value;
  }

  std::istream& in_;
  std::string file_;
  char buffer_[4096];
  std::string_view line_;
  std::size_t number_ = 0;
  std::vector<const Column*> order_;
};

struct EvalOptions {
  std::string model = "exact";
  std::string file = "-";
  std::string precision = "float";
  std::vector<std::string> parameters;
};

// Values of all the model's parameters in its order, or none.
std::vector<double> parameter_values(const EvalOptions& options, const FresnelModel& model) {
  const auto given = named_values(options.parameters);
  if (given.empty()) return {};
  std::vector<double> values;
  std::vector<std::string> known;
  for (const FresnelParameter& info : model.parameters()) {
    known.push_back(info.name);
    const auto it = given.find(info.name);
    if (it == given.end()) {
      throw InputError("", "--set", fmt::format("{} needs \"{}\" too", options.model, info.name));
    }
    const std::string error = parameter_error(info, it->second);
    if (!error.empty()) throw InputError("", "--set " + info.name, error);
    values.push_back(it->second);
  }
  for (const auto& [name, value] : given) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw InputError("", "--set",
                     known.empty() ? options.model + " has no free parameters"
                                   : unknown_name_message("parameter", name, known));
  }
  return values;
}

void print_block(const FresnelModel& model, FresnelPrecision precision,
                 const std::vector<double>& values, std::vector<std::string>& lines,
                 std::vector<FresnelQuery>& queries) {
  // Nine digits give a float back, seventeen a double.
  const int digits = precision == FresnelPrecision::kFloat ? 9 : 17;
  const auto text = [&](std::optional<double> value) {
    return value ? fmt::format("{:.{}g}", *value, digits) : std::string();
  };
  const auto results = evaluate_fresnel(model, queries, precision, values);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const auto& [s, p, unpolarised] = results[i];
    fmt::print("{},{},{},{}\n", lines[i], text(s), text(p), text(unpolarised));
  }
  lines.clear(), queries.clear();
}

int evaluate(const EvalOptions& options) {
  const FresnelModel& model = *Models::instance().find(options.model);
  const auto precision =
      options.precision == "double" ? FresnelPrecision::kDouble : FresnelPrecision::kFloat;
  const std::vector<double> values = parameter_values(options, model);
  std::ifstream file;
  const bool from_stdin = options.file == "-";
  if (!from_stdin) file.open(options.file);
  if (!from_stdin && !file) throw InputError(options.file, "", "cannot be opened");
  QueryReader reader(from_stdin ? std::cin : file, from_stdin ? "standard input" : options.file);
  fmt::print("{},Rs,Rp,R\n", reader.line());
  std::vector<std::string> lines;
  std::vector<FresnelQuery> queries;
  FresnelQuery query;
  while (reader.next(query)) {
    lines.emplace_back(reader.line());
    queries.push_back(query);
    if (queries.size() == kLatticeSize) print_block(model, precision, values, lines, queries);
  }
  print_block(model, precision, values, lines, queries);
  return 0;
}

class FresnelEval final : public Command {
 public:
  void add_to(CLI::App& fresnel, std::function<int()>& action) const override {
    CLI::App* eval =
        fresnel.add_subcommand("eval", "Reflectance for indices and angles in a CSV file");
    const auto options = std::make_shared<EvalOptions>();
    eval->add_option("--model", options->model, "Fresnel model, see `karat fresnel list`")
        ->capture_default_str()
        ->check([](const std::string& name) {
          return Models::instance().find(name)
                     ? std::string()
                     : unknown_name_message("Fresnel model", name, Models::instance().names());
        });
    eval->add_option("--precision", options->precision,
                     "float: the renderer's own kernel; double: the same model in double precision")
        ->capture_default_str()
        ->check(CLI::IsMember({"float", "double"}));
    eval->add_option(
            "--set", options->parameters,
            "NAME=VALUE: a free parameter (all of them, or none), see `karat fresnel list`")
        ->allow_extra_args(false)
        ->check(named_value_check());
    eval->add_option("FILE", options->file,
                     "CSV with the header n,k,theta_deg[,n_exterior]; - is standard input")
        ->capture_default_str();
    eval->footer(
        "Each line is a material of its own, with this index at every wavelength.\n"
        "Prints the lines with Rs, Rp and R appended, with 9 digits (17 in double precision);\n"
        "Rs and Rp stay empty where a model knows only R.\n"
        "Example: karat fresnel eval --model schlick angles.csv");
    eval->callback([&action, options] { action = [options] { return evaluate(*options); }; });
  }
};

KARAT_REGISTER(Command, "fresnel eval", FresnelEval);

}  // namespace
}  // namespace karat
