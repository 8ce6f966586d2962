// Every number of a study as CSV.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "apps/karat/fresnel/study_report.h"
#include "render/replace_file.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

void write_text(const std::string& path, const std::string& text) {
  replace_file(path, [&](const std::string& temporary) {
    std::ofstream file(temporary, std::ios::binary);
    file << text;
    if (!file.flush()) throw RuntimeError(temporary + ": cannot be written");
  });
}

template <typename... Values>
void append(std::string& text, fmt::format_string<Values...> format, Values&&... values) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Values>(values)...);
}

std::string summary_csv(const StudyReport& report) {
  std::string text =
      "material,model,max_abs_error,mean_abs_error,rms_error,mean_signed_error,max_abs_error_nm,"
      "max_abs_error_deg,delta_e_mean,delta_e_max,delta_e_max_deg,delta_e_albedo,"
      "albedo_max_abs_error,cost_relative\n";
  for (const auto& material : report.materials) {
    for (const auto& m : material.models) {
      append(text,
             "\"{}\",{},{:.7g},{:.7g},{:.7g},{:.7g},{:g},{:g},{:.6g},{:.6g},{:g},{:.6g},{:.7g},{:."
             "4g}\n",
             material.table->provenance().name, m.model, m.error.max_abs, m.error.mean_abs,
             m.error.rms, m.error.mean_signed, m.error.worst_nm, m.error.worst_deg,
             m.colour_error.mean, m.colour_error.max, m.colour_error.worst_deg,
             m.colour_error.albedo, m.albedo_max_abs_error,
             cost_of(report.costs, m.model).relative.median);
    }
  }
  return text;
}

std::string cost_csv(const StudyReport& report) {
  std::string text =
      "model,wavelengths_per_call,ns_median,ns_lower,ns_upper,relative_median,relative_lower,"
      "relative_upper\n";
  const auto add = [&](const std::vector<FresnelCost>& costs, int wavelengths) {
    for (const auto& c : costs) {
      append(text, "{},{},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g}\n", c.model, wavelengths,
             c.ns.median, c.ns.lower, c.ns.upper, c.relative.median, c.relative.lower,
             c.relative.upper);
    }
  };
  add(report.costs, kLanes);
  add(report.single_costs, 1);
  return text;
}

std::string render_csv(const FresnelRenders& renders) {
  std::string text =
      "model,delta_e_mean,delta_e_p95,delta_e_max,relative_time_median,relative_time_lower,"
      "relative_time_upper,cpu_seconds\n";
  for (const auto& r : renders.models) {
    append(text, "{},{:.6g},{:.6g},{:.6g},{:.5g},{:.5g},{:.5g},{:.5g}\n", r.model,
           r.difference.mean, r.difference.p95, r.difference.max, r.relative_time.median,
           r.relative_time.lower, r.relative_time.upper, r.cpu_seconds);
  }
  return text;
}

std::string colour_csv(const StudyReport& report) {
  std::string text = "material,model,angle_deg,X,Y,Z,delta_e\n";
  for (const auto& material : report.materials) {
    for (const auto& m : material.models) {
      for (std::size_t a = 0; a < m.colour_error.delta_e.size(); ++a) {
        const Xyz& xyz = m.colours.per_angle[a];
        append(text, "\"{}\",{},{:g},{:.7g},{:.7g},{:.7g},{:.5g}\n",
               material.table->provenance().name, m.model, report.options.grid.angles_deg[a],
               xyz[0], xyz[1], xyz[2], m.colour_error.delta_e[a]);
      }
    }
  }
  return text;
}

std::string tables_csv(const StudyReport& report) {
  std::string text =
      "material,other_table,max_abs_difference,mean_abs_difference,rms_difference,delta_e_mean,"
      "delta_e_max,delta_e_albedo\n";
  for (const auto& material : report.materials) {
    for (const auto& o : material.other_tables) {
      append(text, "\"{}\",\"{}\",{:.7g},{:.7g},{:.7g},{:.6g},{:.6g},{:.6g}\n",
             material.table->provenance().name, o.table, o.error.max_abs, o.error.mean_abs,
             o.error.rms, o.colour_error.mean, o.colour_error.max, o.colour_error.albedo);
    }
  }
  return text;
}

// The columns of one set of curves: R, and s and p where they are known.
void append_header(std::string& text, const std::string& name, const FresnelCurves& curves) {
  append(text, ",{}", name);
  if (!curves.s.empty()) append(text, ",{0}:s,{0}:p", name);
}

void append_values(std::string& text, const FresnelCurves& curves, std::size_t i, int digits) {
  append(text, ",{:.{}g}", curves.unpolarised[i], digits);
  if (!curves.s.empty()) append(text, ",{:.{}g},{:.{}g}", curves.s[i], digits, curves.p[i], digits);
}

std::string reflectance_csv(const FresnelGrid& grid, const FresnelMaterialStudy& material) {
  std::string text = "angle_deg,wavelength_nm";
  append_header(text, "reference", material.exact);
  for (const auto& m : material.models) append_header(text, m.model, m.curves);
  text += '\n';
  const std::size_t wavelengths = grid.wavelengths_nm.size();
  for (std::size_t i = 0; i < grid.size(); ++i) {
    append(text, "{:g},{:g}", grid.angles_deg[i / wavelengths],
           grid.wavelengths_nm[i % wavelengths]);
    append_values(text, material.exact, i, 10);
    for (const auto& m : material.models) append_values(text, m.curves, i, 7);
    text += '\n';
  }
  return text;
}

std::string albedo_csv(const FresnelGrid& grid, const FresnelMaterialStudy& material) {
  std::string text = "wavelength_nm,reference";
  for (const auto& m : material.models) append(text, ",{}", m.model);
  text += '\n';
  for (std::size_t i = 0; i < grid.wavelengths_nm.size(); ++i) {
    append(text, "{:g},{:.10g}", grid.wavelengths_nm[i], material.exact.albedo[i]);
    for (const auto& m : material.models) append(text, ",{:.7g}", m.curves.albedo[i]);
    text += '\n';
  }
  return text;
}

}  // namespace

void write_study_csv(const std::string& folder, const StudyReport& report) {
  const std::string csv = folder + "/csv";
  std::filesystem::create_directories(csv);
  write_text(csv + "/summary.csv", summary_csv(report));
  write_text(csv + "/cost.csv", cost_csv(report));
  write_text(csv + "/colour.csv", colour_csv(report));
  write_text(csv + "/tables.csv", tables_csv(report));
  if (report.renders) write_text(csv + "/render.csv", render_csv(*report.renders));
  for (const auto& material : report.materials) {
    const std::string name = file_name(material);
    write_text(csv + "/reflectance-" + name + ".csv",
               reflectance_csv(report.options.grid, material));
    write_text(csv + "/albedo-" + name + ".csv", albedo_csv(report.options.grid, material));
  }
}

}  // namespace karat
