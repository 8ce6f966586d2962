#include "spectral/ocio_view.h"

#include <OpenColorIO/OpenColorIO.h>
#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "spectral/support/data_path.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

namespace ocio = OCIO_NAMESPACE;

constexpr const char* kInterchangeRole = "aces_interchange";

std::string resolved_path(const std::string& config_path) {
  if (!config_path.empty()) return config_path;
  if (const char* variable = std::getenv("OCIO"); variable && *variable) return variable;
  return data_path("ocio/config.ocio");
}

ocio::ConstConfigRcPtr read_config(const std::string& path) {
  ocio::ConstConfigRcPtr config;
  try {
    config = ocio::Config::CreateFromFile(path.c_str());
  } catch (const ocio::Exception& e) {
    throw InputError(path, "",
                     std::string("cannot be read as an OpenColorIO configuration: ") + e.what());
  }
  if (!config->hasRole(kInterchangeRole)) {
    throw InputError(
        path, "roles",
        "lacks the role \"aces_interchange\" (the name of its ACES2065-1 space), through "
        "which Karat hands over its colours; add it, or choose another configuration");
  }
  return config;
}

std::vector<std::string> display_names(const ocio::Config& config) {
  std::vector<std::string> names;
  for (int i = 0; i < config.getNumDisplays(); ++i) names.emplace_back(config.getDisplay(i));
  return names;
}

std::vector<std::string> view_names(const ocio::Config& config, const std::string& display) {
  std::vector<std::string> names;
  for (int i = 0; i < config.getNumViews(display.c_str()); ++i) {
    names.emplace_back(config.getView(display.c_str(), i));
  }
  return names;
}

void require_known(const std::string& path, const std::string& what, const std::string& name,
                   const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    throw InputError(path, "", unknown_name_message(what, name, known));
  }
}

// Exposure and the change of primaries as one matrix, then the configuration's own display and
// view.
ocio::ConstTransformRcPtr whole_transform(const std::string& display, const std::string& view,
                                          double exposure_stops) {
  const Matrix3& primaries = aces2065_1_of_linear_srgb_matrix();
  double m44[16] = {};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      m44[4 * i + j] = std::exp2(exposure_stops) * primaries[i][j];
  }
  m44[15] = 1.0;
  const auto matrix = ocio::MatrixTransform::Create();
  matrix->setMatrix(m44);
  const auto display_view = ocio::DisplayViewTransform::Create();
  display_view->setSrc(kInterchangeRole);
  display_view->setDisplay(display.c_str());
  display_view->setView(view.c_str());
  const auto group = ocio::GroupTransform::Create();
  group->appendTransform(matrix);
  group->appendTransform(display_view);
  return group;
}

}  // namespace

struct OcioView::Implementation {
  std::string path, display, view;
  double exposure_stops = 0.0;
  ocio::ConstConfigRcPtr config;
  ocio::ConstCPUProcessorRcPtr processor;
};

OcioView::OcioView(const std::string& config_path, const std::string& display,
                   const std::string& view, double exposure_stops) {
  if (!(std::abs(exposure_stops) <= 100.0)) {
    throw InputError("exposure must lie within -100 and 100 stops, found " +
                     fmt::format("{:g}", exposure_stops));
  }
  auto made = std::make_unique<Implementation>();
  made->path = resolved_path(config_path);
  made->exposure_stops = exposure_stops;
  made->config = read_config(made->path);
  const ocio::Config& config = *made->config;
  made->display = display.empty() ? config.getDefaultDisplay() : display;
  require_known(made->path, "display", made->display, display_names(config));
  made->view = view.empty() ? config.getDefaultView(made->display.c_str()) : view;
  require_known(made->path + ": display \"" + made->display + "\"", "view", made->view,
                view_names(config, made->display));
  try {
    // Lossless: the default level allows approximated powers, and was no faster.
    made->processor = config
                          .getProcessor(whole_transform(made->display, made->view, exposure_stops),
                                        ocio::TRANSFORM_DIR_FORWARD)
                          ->getOptimizedCPUProcessor(ocio::OPTIMIZATION_LOSSLESS);
  } catch (const ocio::Exception& e) {
    throw InputError(made->path, "display \"" + made->display + "\", view \"" + made->view + "\"",
                     e.what());
  }
  implementation_ = std::move(made);
}

OcioView::~OcioView() = default;
OcioView::OcioView(OcioView&&) noexcept = default;
OcioView& OcioView::operator=(OcioView&&) noexcept = default;

void OcioView::apply(float* rgb, std::size_t pixels) const {
  // Lines of a few thousand pixels stay in the cache: 2 Mpixel in one line took ten times as long.
  constexpr std::size_t kLine = 4096;
  using Pixels = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(
      Pixels(0, pixels, kLine),
      [&](const Pixels& line) {
        ocio::PackedImageDesc image(rgb + 3 * line.begin(), static_cast<long>(line.size()), 1, 3);
        implementation_->processor->apply(image);
      },
      tbb::simple_partitioner());
}

std::string OcioView::description() const {
  const Implementation& i = *implementation_;
  // Karat's own configuration is named without the folder that it happens to lie in.
  const std::string config =
      i.path == data_path("ocio/config.ocio") ? std::string("Karat's own") : i.path;
  std::string text =
      "config " + config + ", display \"" + i.display + "\", view \"" + i.view + "\"";
  if (i.exposure_stops != 0.0) {
    text += ", exposure " + fmt::format("{:g}", i.exposure_stops) + " stops";
  }
  return text;
}

const std::string& OcioView::config_path() const { return implementation_->path; }
const std::string& OcioView::display() const { return implementation_->display; }
const std::string& OcioView::view() const { return implementation_->view; }

std::vector<std::string> OcioView::displays() const {
  return display_names(*implementation_->config);
}

std::vector<std::string> OcioView::views(const std::string& display) const {
  require_known(implementation_->path, "display", display, displays());
  return view_names(*implementation_->config, display);
}

const Matrix3& aces2065_1_of_linear_srgb_matrix() {
  static const Matrix3 matrix = [] {
    const Primaries ap0{{0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.0770}, {0.32168, 0.33767}};
    const Xyz d65 = xyz_of_xyy({0.3127, 0.3290, 1.0}), aces = xyz_of_xyy({0.32168, 0.33767, 1.0});
    return product(product(inverse(xyz_of_rgb_matrix(ap0)),
                           adaptation_matrix(d65, aces, Adaptation::kBradford)),
                   xyz_of_linear_srgb_matrix());
  }();
  return matrix;
}

}  // namespace karat
