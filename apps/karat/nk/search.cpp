// karat nk search: index tables by element, name, author, year, range.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <memory>

#include "apps/karat/command.h"
#include "apps/karat/json_output.h"
#include "materials/index/index_coverage.h"
#include "materials/index/index_search.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

using nlohmann::json;

struct Options {
  IndexSearchQuery query;
  std::size_t limit = 20;
  bool as_json = false;
};

// "380:780"; nothing for anything else.
std::optional<WavelengthRange> range_of(const std::string& text) {
  WavelengthRange range;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, range.min_nm);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != ':') return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, range.max_nm);
  if (second.ec != std::errc() || second.ptr != end) return std::nullopt;
  const bool sensible = range.min_nm > 0.0 && range.min_nm <= range.max_nm && range.max_nm < 1e15;
  return sensible ? std::optional(range) : std::nullopt;
}

json hit_json(const IndexSearchHit& hit) {
  const IndexFacts& facts = hit.facts;
  return {{"name", hit.name},
          {"file", hit.file},
          {"material", hit.material},
          {"title", hit.title},
          {"kind", facts.kind},
          {"form", facts.form},
          {"samples", facts.samples},
          {"range_nm", {facts.range.min_nm, facts.range.max_nm}},
          {"metal", facts.metal},
          {"covers_visible", is_covered(facts.range, kVisible)},
          {"reference", facts.reference},
          {"problem", facts.problem},
          {"score", hit.score}};
}

void print_json_result(const IndexSearchResult& result, std::size_t limit) {
  json rows = json::array();
  for (std::size_t i = 0; i < std::min(limit, result.hits.size()); ++i)
    rows.push_back(hit_json(result.hits[i]));
  print_json(rows);
}

std::string samples_text(const IndexFacts& facts) {
  return facts.samples > 0 ? fmt::format("{} rows", facts.samples) : facts.form.substr(0, 9);
}

// "(1972)" where a citation has it, as most do at their end.
std::string year_of(const std::string& reference) {
  for (std::size_t at = reference.rfind('('); at != std::string::npos && at > 0;
       at = reference.rfind('(', at - 1)) {
    const std::string year = reference.substr(at, 6);
    if (year.size() == 6 && year[5] == ')' &&
        year.find_first_not_of("0123456789", 1) == std::size_t{5})
      return year;
  }
  return "";
}

// What the catalogue says of a page, or where there is none, the start of its reference.
std::string title_text(const IndexSearchHit& hit) {
  const std::string year = hit.title.empty() ? year_of(hit.facts.reference) : "";
  const std::size_t longest = 60 - year.size();
  std::string text = hit.title.empty() ? hit.facts.reference : hit.title;
  if (!hit.facts.problem.empty() && hit.facts.kind != "k") text = hit.facts.problem;
  if (text.size() <= longest) return text;
  std::size_t end = longest - 3;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0u) == 0x80u) --end;
  text = text.substr(0, end) + "...";
  return year.empty() ? text : text + " " + year;
}

void print_hits(const IndexSearchResult& result, std::size_t limit) {
  const std::size_t count = std::min(limit, result.hits.size());
  std::size_t width = 4;
  for (std::size_t i = 0; i < count; ++i) width = std::max(width, result.hits[i].name.size());
  fmt::print("{:<{}}  {:<4}  {:>9}  {:>9}  {:>10}  {}\n", "name", width, "", "from nm", "to nm",
             "samples", "source");
  for (std::size_t i = 0; i < count; ++i) {
    const IndexSearchHit& hit = result.hits[i];
    fmt::print("{:<{}}  {:<4}  {:>9.6g}  {:>9.6g}  {:>10}  {}\n", hit.name, width,
               hit.facts.kind == "nk" ? "n, k" : hit.facts.kind, hit.facts.range.min_nm,
               hit.facts.range.max_nm, samples_text(hit.facts), title_text(hit));
  }
  if (count < result.hits.size())
    fmt::print("{} of {} tables; --limit {} shows all\n", count, result.hits.size(),
               result.hits.size());
}

void print_nothing(const IndexSearchResult& result) {
  std::string text = "no index table fits";
  if (!result.unknown_word.empty()) {
    text = fmt::format("no index table has the word \"{}\"", result.unknown_word);
    if (!result.nearest_word.empty())
      text += fmt::format("; did you mean \"{}\"?", result.nearest_word);
  }
  fmt::print(stderr, "karat: {}\n", text);
}

int run_search(const Options& options) {
  const IndexSearchResult result = search_index_tables(options.query);
  if (!result.storage_problem.empty())
    fmt::print(stderr, "karat: the index of the search is not kept: {}\n", result.storage_problem);
  if (options.as_json) {
    print_json_result(result, options.limit);
  } else if (result.hits.empty()) {
    print_nothing(result);
  } else {
    print_hits(result, options.limit);
  }
  return 0;
}

class NkSearch final : public Command {
 public:
  void add_to(CLI::App& nk, std::function<int()>& action) const override {
    const auto options = std::make_shared<Options>();
    CLI::App* search = nk.add_subcommand("search", "Tables by element, name, author, year, range");
    search->add_option("words", options->query.words,
                       "Words that must all occur: gold, Au, Johnson, 1972, film");
    search
        ->add_option_function<std::string>(
            "--covers",
            [options](const std::string& text) { options->query.covers = *range_of(text); },
            "Only tables measured from FROM to TO nm: 380:780")
        ->check([](const std::string& text) -> std::string {
          return range_of(text) ? "" : "found \"" + text + "\", allowed: FROM:TO in nm, as 380:780";
        })
        ->type_name("FROM:TO");
    search->add_flag("--metal", options->query.metal,
                     "Only metals, by their optics: k > n/2 at nine of ten wavelengths from 380 to "
                     "780 nm, mean F0 at least 0.4");
    search
        ->add_option("--kind", options->query.kind,
                     "nk: with n and k; n: n alone; k: k alone (no material)")
        ->check(CLI::IsMember({"nk", "n", "k"}));
    search->add_option("--limit", options->limit, "The most tables shown")->capture_default_str();
    search->add_flag("--json", options->as_json, "Machine-readable output");
    search->footer(
        "A word may be the start of a longer one; case and accents do not matter. All folders are\n"
        "searched: Karat's own, yours, and those in KARAT_NK_PATH. An index of them is kept in\n"
        "$XDG_CACHE_HOME/karat (or ~/.cache/karat) and made anew when a folder changes.\n"
        "Example: karat nk search gold film --covers 380:780 --kind nk");
    search->callback([&action, options] { action = [options] { return run_search(*options); }; });
  }
};

KARAT_REGISTER(Command, "nk search", NkSearch);

}  // namespace
}  // namespace karat
