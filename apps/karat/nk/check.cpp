// karat nk check: what an index table's own numbers say about its quality.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <vector>

#include "apps/karat/command.h"
#include "apps/karat/json_output.h"
#include "materials/index/index_catalogue.h"
#include "materials/index/index_check.h"

namespace karat {
namespace {

using nlohmann::json;

struct Options {
  std::vector<std::string> names;
  bool strict = false;
  bool as_json = false;
};

// Text in lines no wider than `width`, each indented.
void print_wrapped(const std::string& text, std::size_t indent, std::size_t width) {
  std::size_t column = indent;
  std::string line;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find(' ', start), text.size());
    if (column + end - start > width && !line.empty()) {
      fmt::print("{}\n{:{}}", line, "", indent);
      line.clear();
      column = indent;
    }
    if (!line.empty()) line += ' ';
    line.append(text, start, end - start);
    column += end - start + 1;
    start = end + 1;
  }
  fmt::print("{}\n", line);
}

void print_checks(const std::string& name, const std::vector<IndexCheck>& checks) {
  fmt::print("{}\n", name);
  for (const IndexCheck& check : checks) {
    fmt::print("  {:<11} {:<12} ", check.name, name_of(check.verdict));
    print_wrapped(check.text, 27, 100);
  }
}

json checks_json(const IndexTable& table, const std::vector<IndexCheck>& checks) {
  json list = json::array();
  for (const IndexCheck& check : checks) {
    list.push_back({{"check", check.name},
                    {"verdict", name_of(check.verdict)},
                    {"text", check.text},
                    {"figures", check.figures}});
  }
  return {{"name", table.provenance().name},
          {"file", table.provenance().file},
          {"reference", table.provenance().reference},
          {"range_nm", {table.range().min_nm, table.range().max_nm}},
          {"checks", list},
          {"warnings", table.warnings()}};
}

int run_check(const Options& options) {
  json all = json::array();
  bool bad = false;
  for (const std::string& name : options.names) {
    const IndexTablePtr table = find_index_table(full_index_name(name));
    const std::vector<IndexCheck> checks = check_index_table(table);
    bad = bad || std::any_of(checks.begin(), checks.end(), [](const IndexCheck& check) {
            return check.verdict == Verdict::kBad;
          });
    if (options.as_json) {
      all.push_back(checks_json(*table, checks));
    } else {
      print_checks(table->provenance().name, checks);
    }
  }
  if (options.as_json) print_json(all);
  return options.strict && bad ? 1 : 0;
}

class NkCheck final : public Command {
 public:
  void add_to(CLI::App& nk, std::function<int()>& action) const override {
    const auto options = std::make_shared<Options>();
    CLI::App* check = nk.add_subcommand(
        "check", "Passivity, sampling, smoothness and Kramers-Kronig consistency of tables");
    check
        ->add_option("names", options->names,
                     "Tables to check: main/Au/Johnson, short Au/Johnson, or files")
        ->required();
    check->add_flag("--strict", options->strict, "Exit code 1 where a check says \"bad\"");
    check->add_flag("--json", options->as_json, "Machine-readable output");
    check->footer("Example: karat nk check main/Au/Johnson");
    check->callback([&action, options] { action = [options] { return run_check(*options); }; });
  }
};

KARAT_REGISTER(Command, "nk check", NkCheck);

}  // namespace
}  // namespace karat
