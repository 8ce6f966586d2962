#include "materials/index/index_check.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>

#include "apps/karat/run_karat.h"
#include "materials/index/index_catalogue.h"
#include "materials/index/kramers_kronig.h"

namespace karat {
namespace {

using Catch::Matchers::Contains;
using Complex = std::complex<double>;

constexpr double kHcNm = 1239.841984;

// Drude and Lorentz terms, exact solutions of a damped oscillator: causal by construction. eV.
Complex lorentz_index(double nm, double drude_ev) {
  const double w = kHcNm / nm;
  const Complex i(0.0, 1.0);
  Complex permittivity = 1.0 + 6.0 * 2.6 * 2.6 / (2.6 * 2.6 - w * w - i * 0.5 * w) +
                         1.5 * 6.0 * 6.0 / (6.0 * 6.0 - w * w - i * 1.0 * w);
  permittivity -= drude_ev * drude_ev / (w * w + i * 0.1 * w);
  return std::sqrt(permittivity);
}

// A table of n and k of two functions, 300 to 1500 nm in steps of 8 nm unless told.
IndexTablePtr table_of(const std::function<double(double)>& n,
                       const std::function<double(double)>& k, double step_nm = 8.0) {
  std::vector<double> nm, n_values, k_values;
  for (double at = 300.0; at <= 1500.0; at += step_nm) {
    nm.push_back(at);
    n_values.push_back(n(at));
    k_values.push_back(k(at));
  }
  Provenance provenance;
  provenance.name = "test";
  return index_from_spectra(table_spectrum(nm, n_values, "n"), table_spectrum(nm, k_values, "k"),
                            provenance);
}

IndexTablePtr oscillators(double drude_ev, double k_factor = 1.0, double step_nm = 8.0) {
  return table_of([=](double nm) { return lorentz_index(nm, drude_ev).real(); },
                  [=](double nm) { return k_factor * lorentz_index(nm, drude_ev).imag(); },
                  step_nm);
}

TEST_CASE("an oscillator's n and k agree by Kramers and Kronig, other pairs do not",
          "[index_check]") {
  for (const double drude_ev : {0.0, 8.0}) {
    INFO("plasma energy " << drude_ev);
    const IndexCheck right = check_causality(*oscillators(drude_ev));
    CHECK(right.verdict == Verdict::kGood);
    CHECK(right.figures.at("rms_share") < 0.002);
    CHECK(right.figures.at("k_factor_low") > 0.7);
    CHECK(right.figures.at("k_factor_high") < 1.4);
    CHECK(check_causality(*oscillators(drude_ev, 1.5)).verdict != Verdict::kGood);
    CHECK(check_causality(*oscillators(drude_ev, 0.6)).verdict != Verdict::kGood);
  }
  CHECK(check_causality(*oscillators(0.0, 1.5)).verdict == Verdict::kBad);
  // The n of one material with the k of another.
  const auto mixed = table_of([](double nm) { return lorentz_index(nm, 8.0).real(); },
                              [](double nm) { return lorentz_index(nm, 0.0).imag(); });
  CHECK(check_causality(*mixed).verdict == Verdict::kBad);
  // Anomalous dispersion without absorption.
  const auto anomalous =
      table_of([](double nm) { return 1.5 + 1e-4 * (nm - 300.0); }, [](double) { return 0.0; });
  CHECK(check_causality(*anomalous).verdict != Verdict::kGood);
}

TEST_CASE("the n that k implies is the oscillator's, with the absorption outside found",
          "[index_check]") {
  EnergyIndex index;
  for (double ev = 1.0; ev <= 4.0; ev += 0.03) {
    const Complex n = lorentz_index(kHcNm / ev, 0.0);
    index.energy_ev.push_back(ev);
    index.n.push_back(n.real());
    index.k.push_back(n.imag());
  }
  const KramersKronigFit fit = kramers_kronig_fit(index);
  for (std::size_t i = 0; i < index.n.size(); ++i) {
    CHECK(fit.n[i] == Approx(index.n[i]).margin(0.01));
  }
  for (const double k : fit.outer_k) CHECK(k >= 0.0);
}

TEST_CASE("known tables are judged as the literature judges them", "[index_check]") {
  for (const char* good : {"main/Au/Johnson", "main/Ag/Johnson", "main/Au/Rakic-BB",
                           "main/SiO2/Malitson", "specs/SCHOTT-optical/N-BK7"}) {
    INFO(good);
    CHECK(check_causality(*find_index_table(good)).verdict == Verdict::kGood);
  }
  // The n of gold is not that of silver.
  const IndexTablePtr gold = find_index_table("main/Au/Johnson");
  const IndexTablePtr silver = find_index_table("main/Ag/Johnson");
  const auto swapped = table_of([&](double nm) { return silver->at(nm).n; },
                                [&](double nm) { return gold->at(nm).k; }, 20.0);
  CHECK(check_causality(*swapped).verdict != Verdict::kGood);
  CHECK(check_causality(*find_index_table("other/AuAl2/Supansomboon")).verdict == Verdict::kBad);
}

TEST_CASE("negative values are found with their wavelengths", "[index_check]") {
  const auto table =
      table_of([](double) { return 1.5; }, [](double nm) { return nm > 1000.0 ? -0.01 : 0.1; });
  const IndexCheck check = check_passivity(*table);
  CHECK(check.verdict == Verdict::kBad);
  CHECK(check.figures.at("negative_k_rows") == 63);
  CHECK_THAT(check.text, Contains("k is negative in 63 rows") && Contains("1004 nm"));
  CHECK(check_passivity(*find_index_table("main/Au/Johnson")).verdict == Verdict::kGood);
}

TEST_CASE("a slip of typing is named with its wavelength", "[index_check]") {
  const auto n = [](double nm) { return lorentz_index(nm, 8.0).real(); };
  const auto k = [](double nm) { return lorentz_index(nm, 8.0).imag(); };
  CHECK(check_smoothness(*table_of(n, k)).figures.at("outliers") == 0);
  const auto slipped = [&](double nm) { return nm == 700.0 ? 1.1 * k(nm) : k(nm); };
  const IndexCheck check = check_smoothness(*table_of(n, slipped));
  CHECK(check.verdict == Verdict::kDoubtful);
  CHECK(check.figures.at("outliers") == 1);
  CHECK_THAT(check.text, Contains("k = ") && Contains("at 700 nm"));
}

TEST_CASE("samples far apart are told from samples close together", "[index_check]") {
  const IndexCheck fine = check_sampling(oscillators(8.0, 1.0, 5.0));
  const IndexCheck coarse = check_sampling(oscillators(8.0, 1.0, 120.0));
  CHECK(fine.verdict == Verdict::kGood);
  CHECK(fine.figures.at("largest_gap_nm") == Approx(5.0));
  CHECK(coarse.verdict != Verdict::kGood);
  CHECK(coarse.figures.at("delta_e_2000") > 10.0 * fine.figures.at("delta_e_2000"));
  CHECK(check_visible_rows(*oscillators(8.0)).verdict == Verdict::kGood);
  CHECK(check_visible_rows(*oscillators(8.0, 1.0, 120.0)).verdict == Verdict::kDoubtful);
  CHECK(check_sampling(find_index_table("main/SiO2/Malitson")).verdict == Verdict::kGood);
}

TEST_CASE("every shipped table can be checked, and every figure is finite", "[index_check]") {
  for (const auto& entry : list_index_tables()) {
    INFO(entry.name);
    for (const IndexCheck& check : check_index_table(find_index_table(entry.name))) {
      CHECK(!check.text.empty());
      for (const auto& [name, value] : check.figures) {
        INFO(check.name << " " << name);
        CHECK(std::isfinite(value));
      }
    }
  }
}

TEST_CASE("karat nk check fails only where it is strict and a table is bad", "[index_check]") {
  const auto run = [](std::vector<const char*> argv) {
    return run_karat(static_cast<int>(argv.size()), argv.data());
  };
  CHECK(run({"karat", "nk", "check", "other/AuAl2/Supansomboon"}) == 0);
  CHECK(run({"karat", "nk", "check", "--strict", "other/AuAl2/Supansomboon"}) == 1);
  CHECK(run({"karat", "nk", "check", "--strict", "--json", "main/Au/Johnson"}) == 0);
  CHECK(run({"karat", "nk", "check", "main/Au/Jonson"}) == 3);
}

}  // namespace
}  // namespace karat
