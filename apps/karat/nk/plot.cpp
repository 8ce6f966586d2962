// karat nk plot: n, k and reflectance of index tables over wavelength, as SVG or PNG.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "apps/karat/command.h"
#include "apps/karat/nk/index_argument.h"
#include "apps/karat/nk/index_chart.h"
#include "apps/karat/number_check.h"
#include "apps/karat/picture_check.h"
#include "apps/karat/size_option.h"
#include "materials/index/index_interpolation.h"

namespace karat {
namespace {

struct Options {
  std::vector<std::string> names;
  std::string output;
  std::vector<double> range_nm;  // two, or none
  std::vector<std::string> log_axes;
  std::optional<PictureSize> size;
  std::string interpolation = "linear";
  double angle_deg = 0.0;
};

// Throws ValidationError (wrong usage).
void require_rising(const std::vector<double>& range_nm) {
  if (range_nm.empty() || range_nm[0] < range_nm[1]) return;
  throw CLI::ValidationError(
      "--nm", fmt::format("found {:g}:{:g}, allowed: the shorter wavelength first", range_nm[0],
                          range_nm[1]));
}

IndexChartOptions chart_options(const Options& options) {
  IndexChartOptions chart;
  if (!options.range_nm.empty()) {
    chart.range = WavelengthRange{options.range_nm[0], options.range_nm[1]};
  }
  if (!options.log_axes.empty()) chart.log_axes = options.log_axes;
  chart.angle_deg = options.angle_deg;
  if (options.size) chart.width = options.size->width, chart.height = options.size->height;
  return chart;
}

int run_plot(const Options& options) {
  const Interpolation interpolation = interpolation_named(options.interpolation);
  std::vector<IndexTablePtr> tables;
  for (const std::string& name : options.names) {
    tables.push_back(interpolated(index_of_argument(name), interpolation));
  }
  draw_chart(index_chart(tables, chart_options(options)), options.output);
  fmt::print("{}\n", options.output);
  return 0;
}

class NkPlot final : public Command {
 public:
  void add_to(CLI::App& nk, std::function<int()>& action) const override {
    const auto options = std::make_shared<Options>();
    CLI::App* plot = nk.add_subcommand("plot", "Draw n, k and reflectance over wavelength");
    plot->add_option("names", options->names, "Drawn over each other; " + index_argument_help())
        ->required();
    plot->add_option("-o,--output", options->output, "Picture to write: .svg or .png")
        ->required()
        ->check(picture_check);
    plot->add_option("--nm", options->range_nm, "From one wavelength to another, in nm: 300:900")
        ->delimiter(':')
        ->expected(2)
        ->type_name("FROM:TO")
        ->check(number_check(1e-3, 1e9).description(""));
    plot->add_option("--angle", options->angle_deg, "Angle of incidence for the reflectance [0]")
        ->check(number_check(0.0, 90.0));
    plot->add_option("--log", options->log_axes,
                     "Logarithmic axes, separated by commas: wavelength, n, k, reflectance, or "
                     "none [those that span far]")
        ->delimiter(',')
        ->check(CLI::IsMember({"wavelength", "n", "k", "reflectance", "none"}));
    plot->add_option("--interpolation", options->interpolation,
                     "Between measured points: linear or monotone-cubic [linear]")
        ->check(CLI::IsMember(interpolation_names()));
    add_size_option(
        *plot, [size = &options->size](PictureSize given) { *size = given; }, 200, 10000,
        "Width and height in pixels [760x640]");
    plot->footer("Example: karat nk plot main/Au/Johnson main/Au/McPeak --nm 300:900 -o gold.svg");
    plot->callback([&action, options] {
      require_rising(options->range_nm);
      action = [options] { return run_plot(*options); };
    });
  }
};

KARAT_REGISTER(Command, "nk plot", NkPlot);

}  // namespace
}  // namespace karat
