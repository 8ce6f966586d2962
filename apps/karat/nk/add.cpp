// karat nk add: makes an index table of the user's own out of a measured file.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <memory>

#include "apps/karat/as_usage.h"
#include "apps/karat/command.h"
#include "apps/karat/json_output.h"
#include "apps/karat/swatch.h"
#include "materials/index/import/format.h"
#include "materials/index/import/header.h"
#include "materials/index/index_colour.h"
#include "materials/index/index_coverage.h"
#include "materials/index/index_import.h"
#include "materials/index/index_path.h"
#include "materials/index/index_table_file.h"
#include "render/replace_file.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;
using Kind = IndexPathEntry::Kind;

struct Options {
  std::string file, name, unit;
  std::vector<std::string> columns;
  bool force = false, dry_run = false, as_json = false;
  IndexImportOptions import;
};

// A table of the project comes before the user's: a second one of its name would never be used.
void require_free(const Options& options, const fs::path& target) {
  std::optional<std::string> own;
  try {
    own = find_index_file(options.name, Kind::kProject);
  } catch (const InputError&) {  // an id that stands for two files is taken, too
    own = options.name;
  }
  if (own) {
    throw InputError(fmt::format(
        "\"{}\" is one of Karat's own tables, which come first; choose another name, such as "
        "my{}",
        options.name, options.name.substr(std::min(options.name.find('/'), options.name.size()))));
  }
  if (fs::exists(target) && !options.force) {
    throw InputError(fmt::format("\"{}\" exists already ({}); --force replaces it", options.name,
                                 target.string()));
  }
}

AxisUnit unit_named(const std::string& name) {
  if (const auto unit = axis_unit(name)) return *unit;
  std::vector<std::string> known;
  for (const AxisUnit unit : kAxisUnits) known.push_back(axis_unit_name(unit));
  throw InputError("--unit: " + unknown_name_message("unit", name, known));
}

IndexImportOptions import_options(const Options& options) {
  IndexImportOptions import = options.import;
  import.file_name = fs::path(options.file).filename().string();
  import.date = fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)));
  return import;
}

json range_json(const std::optional<ValueRange>& range) {
  return range ? json{range->min, range->max} : json(nullptr);
}

json facts_of(const Options& options, const IndexImport& import, const IndexTable& table,
              const std::string& file) {
  json facts = {{"name", options.name},
                {"file", file},
                {"written", !options.dry_run},
                {"format", import.format},
                {"read_as", import.description},
                {"unit", import.unit},
                {"rows", import.rows},
                {"rows_visible", import.visible_rows},
                {"reference", table.provenance().reference},
                {"range_nm", {table.range().min_nm, table.range().max_nm}},
                {"covers_visible", is_covered(table.range(), kVisible)},
                {"has_k", table.has_k()},
                {"n", range_json(import.n)},
                {"k", range_json(import.k)},
                {"f0_linear_srgb", nullptr},
                {"f0_srgb_hex", nullptr},
                {"warnings", import.warnings}};
  for (const std::string& warning : table.warnings()) facts["warnings"].push_back(warning);
  if (const auto later = find_index_file(options.name, Kind::kVariable)) {
    facts["warnings"].push_back("comes before the table of the same name in KARAT_NK_PATH, " +
                                *later);
  }
  if (const auto xyz = normal_colour(table)) {
    const Rgb rgb = linear_srgb_of_xyz(*xyz);
    facts["f0_linear_srgb"] = rgb;
    facts["f0_srgb_hex"] = display_hex(rgb);
  }
  return facts;
}

std::string text_of(const char* name, const json& range) {
  if (range.is_null()) return "";
  return fmt::format("{} {:.6g} to {:.6g}", name, range[0].get<double>(), range[1].get<double>());
}

void print_line(const char* key, const std::string& value) {
  if (!value.empty()) fmt::print("{:<11} {}\n", key, value);
}

void print_facts(const json& facts) {
  for (const char* key : {"name", "file", "reference"}) print_line(key, facts[key]);
  print_line("read as", facts["read_as"]);
  print_line("unit", facts["unit"]);
  if (facts["rows"] > 0) {
    print_line("rows", fmt::format("{}, {} of them in 380 to 780 nm", facts["rows"].get<int>(),
                                   facts["rows_visible"].get<int>()));
  }
  const std::string k = text_of("k", facts["k"]);
  print_line("values", text_of("n", facts["n"]) + (k.empty() ? "" : ", " + k));
  print_line("range",
             fmt::format("{:.7g} to {:.7g} nm, {}; {} 380 to 780 nm",
                         facts["range_nm"][0].get<double>(), facts["range_nm"][1].get<double>(),
                         facts["has_k"].get<bool>() ? "n and k" : "n alone",
                         facts["covers_visible"].get<bool>() ? "covers" : "does not cover"));
  if (!facts["f0_linear_srgb"].is_null()) {
    const Rgb rgb = facts["f0_linear_srgb"];
    print_line("F0 (D65)",
               fmt::format("linear sRGB {:.4f} {:.4f} {:.4f}, {}{}", rgb[0], rgb[1], rgb[2],
                           facts["f0_srgb_hex"].get<std::string>(), swatch(rgb)));
  }
  for (const json& warning : facts["warnings"]) print_line("warning", warning);
  const std::string name = facts["name"];
  if (facts["written"].get<bool>()) {
    fmt::print("\nAdded. Look at it: karat nk show {0}; in a scene: \"nk\": \"{0}\"\n", name);
  } else {
    fmt::print("\nNothing was written (--dry-run).\n");
  }
}

int run_add(const Options& options) {
  const fs::path target = user_index_file(options.name);
  require_free(options, target);
  const IndexImport import = import_index_file(options.file, import_options(options));
  const IndexTablePtr table = load_index_table_text(import.yaml, options.name);
  const json facts = facts_of(options, import, *table, target.string());
  if (!options.dry_run) {
    std::error_code error;
    fs::create_directories(target.parent_path(), error);
    if (error) {
      throw RuntimeError(fmt::format("cannot create the folder {}: {}",
                                     target.parent_path().string(), error.message()));
    }
    replace_file(target.string(), [&](const std::string& temporary) {
      std::ofstream stream(temporary, std::ios::binary);
      if (!(stream << import.yaml) || !stream.flush()) throw RuntimeError("the disk is full");
    });
  }
  if (options.as_json) {
    print_json(facts);
  } else {
    print_facts(facts);
  }
  return 0;
}

// A file of the database has its reference in it; whoever measured the others knows theirs.
void require_reference(const Options& options) {
  const bool yaml = options.import.format == "yaml" || options.file.ends_with(".yml") ||
                    options.file.ends_with(".yaml");
  if (options.import.reference.empty() && !yaml) {
    throw CLI::ValidationError(
        "--reference",
        "is required: who measured this, and where is it published? Every image that uses the "
        "table says so");
  }
}

// An option that means nothing is wrong usage, whatever the file holds.
void read_import_options(Options& options) {
  as_usage([&] {
    if (!options.unit.empty()) options.import.unit = unit_named(options.unit);
    options.import.columns = column_names(options.columns);
  });
}

class NkAdd final : public Command {
 public:
  void add_to(CLI::App& nk, std::function<int()>& action) const override {
    const auto options = std::make_shared<Options>();
    CLI::App* add = nk.add_subcommand(
        "add", "Make a table of your own from CSV, text, SOPRA or IMD .nk, permittivity, or YAML");
    add->add_option("file", options->file, "Measured wavelengths with n and k, or eps1 and eps2")
        ->required();
    add->add_option("--name", options->name, "What to call it: shelf/book/page, e.g. my/gold/film")
        ->required();
    add->add_option("--reference", options->import.reference,
                    "Who measured it and where that is published; required except for YAML");
    add->add_option(
        "--unit", options->unit,
        "Unit of the first column: nm, um, angstrom, eV or cm-1; else as the file says");
    add->add_option("--columns", options->columns,
                    "What the columns are: wavelength,n,k (also energy, wavenumber, eps1, eps2; - "
                    "skips one); else as the file says")
        ->delimiter(',')
        ->allow_extra_args(false);  // what follows is the file
    add->add_option("--format", options->import.format, "How the file is read; else as it looks")
        ->check(CLI::IsMember(Registry<IndexFormat>::instance().names()));
    add->add_flag("--negate-k", options->import.negate_k,
                  "The file has the other sign convention, n - ik: change the sign of k");
    add->add_flag("--accept-implausible", options->import.accept_implausible,
                  "Add what looks wrong all the same, with warnings");
    add->add_flag("--force", options->force, "Replace a table of that name");
    add->add_flag("--dry-run", options->dry_run, "Show what is understood; write nothing");
    add->add_flag("--json", options->as_json, "Machine-readable output");
    add->footer(
        "Example: karat nk add film.csv --name my/gold/film --reference \"A. Author, 2026\"\n"
        "Your tables lie in $XDG_DATA_HOME/karat/nk or ~/.local/share/karat/nk.");
    add->callback([&action, options] {
      require_reference(*options);
      read_import_options(*options);
      action = [options] { return run_add(*options); };
    });
  }
};

KARAT_REGISTER(Command, "nk add", NkAdd);

}  // namespace
}  // namespace karat
