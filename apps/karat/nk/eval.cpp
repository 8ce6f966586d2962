// karat nk eval: n and k of one table at given wavelengths, as CSV.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <vector>

#include "apps/karat/command.h"
#include "apps/karat/json_output.h"
#include "apps/karat/nk/index_argument.h"
#include "apps/karat/number_list.h"
#include "materials/index/index_coverage.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

using nlohmann::json;

struct Options {
  std::string name;
  std::vector<double> wavelengths_nm;
  bool as_json = false;
};

// All wavelengths are looked at before anything is printed: half a list is no list.
std::vector<ComplexIndex> values_of(const IndexTable& table, const std::vector<double>& asked) {
  std::vector<ComplexIndex> values;
  for (const double nm : asked) {
    if (!covers_wavelength(table, nm)) {
      throw InputError(
          fmt::format("index table \"{}\" covers {:.9g} to {:.9g} nm; {:.9g} nm is "
                      "outside, where nobody measured{}",
                      table.provenance().name, table.range().min_nm, table.range().max_nm, nm,
                      unit_hint("--nm", {nm, nm}, table.range())));
    }
    values.push_back(table.at(nm));
  }
  return values;
}

json values_json(const IndexTable& table, const std::vector<double>& wavelengths_nm,
                 const std::vector<ComplexIndex>& values) {
  json result = {{"name", table.provenance().name},
                 {"file", table.provenance().file},
                 {"range_nm", {table.range().min_nm, table.range().max_nm}},
                 {"has_k", table.has_k()},
                 {"wavelength_nm", wavelengths_nm},
                 {"n", json::array()},
                 {"k", json::array()}};
  for (const ComplexIndex& value : values) {
    result["n"].push_back(value.n);
    result["k"].push_back(table.has_k() ? json(value.k) : json());
  }
  return result;
}

// Shortest decimals that give the same doubles back.
void print_csv(const IndexTable& table, const std::vector<double>& wavelengths_nm,
               const std::vector<ComplexIndex>& values) {
  fmt::print("wavelength_nm,n,k\n");
  for (std::size_t i = 0; i < values.size(); ++i) {
    fmt::print("{},{},{}\n", wavelengths_nm[i], values[i].n,
               table.has_k() ? fmt::format("{}", values[i].k) : "");
  }
}

int run_eval(const Options& options) {
  const IndexTablePtr table = index_of_argument(options.name);
  const auto values = values_of(*table, options.wavelengths_nm);
  if (options.as_json) {
    print_json(values_json(*table, options.wavelengths_nm, values));
  } else {
    print_csv(*table, options.wavelengths_nm, values);
  }
  return 0;
}

class NkEval final : public Command {
 public:
  void add_to(CLI::App& nk, std::function<int()>& action) const override {
    const auto options = std::make_shared<Options>();
    CLI::App* eval = nk.add_subcommand("eval", "n and k of one table at given wavelengths, as CSV");
    eval->add_option("page", options->name, index_argument_help())->required();
    add_number_list(*eval, "--nm", options->wavelengths_nm,
                    "Wavelengths in nm: 400,550:600:10 is 400, 550, 560, ..., 600", 1e-3, 1e15)
        ->required();
    eval->add_flag("--json", options->as_json, "Machine-readable output, k null where unknown");
    eval->footer(
        "Prints wavelength_nm,n,k with all digits. n and k are linear in wavelength between rows.\n"
        "k stays empty where the table lists n alone. A wavelength outside the table's range is "
        "an\n"
        "error (exit code 3), and nothing is printed.\n"
        "Example: karat nk eval main/Au/Johnson --nm 400,550:600:10");
    eval->callback([&action, options] { action = [options] { return run_eval(*options); }; });
  }
};

KARAT_REGISTER(Command, "nk eval", NkEval);

}  // namespace
}  // namespace karat
