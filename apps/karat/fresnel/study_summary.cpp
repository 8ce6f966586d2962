// What a study found, in plain language. Every sentence is computed; none is true of all studies.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/karat/fresnel/study_report.h"

namespace karat {
namespace {

// Two colours side by side that differ by less can hardly be told apart.
constexpr double kVisible2000 = 1.0;
// Differences that cannot be told from rounding.
constexpr double kSame = 1e-5;

using Sentences = std::vector<std::string>;

std::string percent(double part) { return fmt::format("{:.0f} %", 100.0 * part); }

std::string listed(const std::vector<std::string>& names) {
  if (names.size() < 2) return names.empty() ? "none" : names.front();
  return fmt::format("{} and {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

const FresnelRank* rank_named(const StudyReport& report, const std::string& name) {
  const auto rank = std::find_if(report.ranking.begin(), report.ranking.end(),
                                 [&](const FresnelRank& r) { return r.model == name; });
  return rank == report.ranking.end() ? nullptr : &*rank;
}

// The cheapest model that `accepts`, or nothing; of several that cost the same, the nearest in
// colour.
template <typename F>
const FresnelRank* cheapest(const StudyReport& report, F&& accepts) {
  double least = std::numeric_limits<double>::infinity();
  for (const FresnelRank& rank : report.ranking) {
    if (accepts(rank)) least = std::min(least, rank.cost_relative);
  }
  const FresnelRank* best = nullptr;
  for (const FresnelRank& rank : report.ranking) {
    if (!accepts(rank) || rank.cost_relative > least * (1.0 + kSameCost)) continue;
    if (!best || rank.delta_e_mean < best->delta_e_mean) best = &rank;
  }
  return best;
}

void say_cost(const StudyReport& report, Sentences& sentences) {
  const FresnelCost& exact = cost_of(report.costs, "exact");
  sentences.push_back(fmt::format(
      "Exact takes {:.1f} ns for {} wavelengths on this machine, of which {:.1f} ns are the call "
      "itself; "
      "alone, straight from n and k in double precision, one wavelength takes {:.0f} ns.",
      exact.ns.median, kLanes, report.call_ns, cost_of(report.single_costs, "exact").ns.median));
}

std::string choice(const std::string& wish, const FresnelRank* rank) {
  if (!rank) return fmt::format("{}: no model of this study.", wish);
  return fmt::format(
      "{}: {}, at {} of the cost of exact (colour difference {:.2g} on average, {:.2g} at worst, "
      "on {}).",
      wish, rank->model, percent(rank->cost_relative), rank->delta_e_mean, rank->delta_e_max,
      rank->worst_material);
}

void say_choices(const StudyReport& report, Sentences& sentences) {
  sentences.push_back(
      choice("The cheapest model whose colour cannot be told from exact on any of these materials "
             "at any angle (CIEDE2000 below 1)",
             cheapest(report, [](const FresnelRank& r) { return r.delta_e_max < kVisible2000; })));
  sentences.push_back(choice(
      "The cheapest whose colour differs by less than 1 on average over angles and materials",
      cheapest(report, [](const FresnelRank& r) { return r.delta_e_mean < kVisible2000; })));
  sentences.push_back(
      choice("The cheapest whose reflectance is never wrong by more than 0.01",
             cheapest(report, [](const FresnelRank& r) { return r.max_abs_error <= 0.01; })));
  sentences.push_back(
      fmt::format("Costs within {} of each other count as equal here: then the nearer is named.",
                  percent(kSameCost)));
  std::vector<std::string> efficient, beaten;
  for (const FresnelRank& rank : report.ranking) {
    (rank.efficient ? efficient : beaten).push_back(rank.model);
  }
  sentences.push_back(
      "Worth choosing at all, since no other model is nearer in colour and as cheap, or cheaper "
      "and as near: " +
      listed(efficient) + ".");
  std::vector<std::string> dearer;
  for (const FresnelRank& rank : report.ranking) {
    if (rank.model != "exact" && rank.cost_relative >= 0.95) dearer.push_back(rank.model);
  }
  if (!dearer.empty()) {
    sentences.push_back(
        "Approximations that cost as much as exact (95 % or more), and so save nothing: " +
        listed(dearer) + ".");
  }
}

double largest_difference(const StudyReport& report, std::size_t i, std::size_t j) {
  double largest = 0.0;
  for (const auto& material : report.materials) {
    const GridValues& a = material.models[i].curves.unpolarised;
    const GridValues& b = material.models[j].curves.unpolarised;
    for (std::size_t v = 0; v < a.size(); ++v) largest = std::max(largest, std::abs(a[v] - b[v]));
  }
  return largest;
}

// Models that give the same values at all that was studied, which does not make them one function.
void say_same(const StudyReport& report, Sentences& sentences) {
  const auto& models = report.options.models;
  std::vector<bool> named(models.size());
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (named[i]) continue;
    std::vector<std::string> same{models[i]};
    double largest = 0.0;
    for (std::size_t j = i + 1; j < models.size(); ++j) {
      const double difference = named[j] ? 1.0 : largest_difference(report, i, j);
      if (difference > kSame) continue;
      same.push_back(models[j]);
      named[j] = true;
      largest = std::max(largest, difference);
    }
    if (same.size() < 2) continue;
    sentences.push_back(
        fmt::format("On these materials, wavelengths and angles {} cannot be told apart: they "
                    "differ by {:.1g} at most.",
                    listed(same), largest));
  }
}

void say_2005(const StudyReport& report, Sentences& sentences) {
  static constexpr std::pair<const char*, double> kPublished[]{
      {"schlick", 0.28}, {"lazanyi", 0.33}, {"lazanyi-compensated", 0.54}};
  std::vector<std::string> parts;
  for (const auto& [name, published] : kPublished) {
    const FresnelRank* rank = rank_named(report, name);
    if (!rank) continue;
    parts.push_back(
        fmt::format("{} {} (then {})", name, percent(rank->cost_relative), percent(published)));
  }
  if (parts.empty()) return;
  sentences.push_back("Against the figures of 2005, relative to exact: " + listed(parts) + ".");
}

// Models whose error is below what measurements of the same material differ by.
void say_tables(const StudyReport& report, Sentences& sentences) {
  std::vector<double> differences;
  for (const auto& material : report.materials) {
    for (const auto& other : material.other_tables) {
      differences.push_back(other.colour_error.mean);
    }
  }
  if (differences.empty()) return;
  const auto half = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), half, differences.end());
  const double middle = *half;
  std::vector<std::string> below;
  std::size_t approximations = 0;
  for (const FresnelRank& rank : report.ranking) {
    if (rank.model == "exact") continue;
    ++approximations;
    if (rank.delta_e_mean < middle) below.push_back(rank.model);
  }
  std::string sentence = fmt::format(
      "Other measurements of the same materials differ from the tables used here by CIEDE2000 "
      "{:.1f} in the median ({} tables)",
      middle, differences.size());
  if (approximations > 0) {
    sentence += fmt::format(": more than {} of the {} approximations do from exact on average",
                            below.size(), approximations);
  }
  sentences.push_back(sentence + ".");
}

void say_render(const StudyReport& report, Sentences& sentences) {
  if (!report.renders) return;
  const FresnelRenders& renders = *report.renders;
  sentences.push_back(
      fmt::format("In the render of rings, exact Fresnel takes {:.2g} % of the time: no "
                  "approximation can save more than that.",
                  100.0 * renders.fresnel_share.median));
  // Of pictures that differ by less than noise: a darker metal ends paths earlier.
  std::vector<double> times;
  for (const FresnelRender& render : renders.models) {
    if (render.model == "exact" || render.difference.mean > renders.noise.mean) continue;
    times.push_back(render.relative_time.median);
  }
  if (times.empty()) return;
  const auto [least, most] = std::minmax_element(times.begin(), times.end());
  sentences.push_back(fmt::format(
      "Whole renders whose picture differs from exact by less than the noise does took {:.1f} to "
      "{:.1f} % of the time of exact; a second render with exact and other random numbers took "
      "{:.1f} %.",
      100.0 * *least, 100.0 * *most, 100.0 * renders.noise_time.median));
}

}  // namespace

std::vector<std::string> study_summary(const StudyReport& report) {
  Sentences sentences;
  say_choices(report, sentences);
  say_cost(report, sentences);
  say_2005(report, sentences);
  say_render(report, sentences);
  say_tables(report, sentences);
  say_same(report, sentences);
  return sentences;
}

}  // namespace karat
