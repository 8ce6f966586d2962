#include "apps/karat/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace karat {
namespace {

constexpr double kSecondsBetweenLines = 2.0;
constexpr int kBarWidth = 30;

std::string duration(double seconds) {
  const auto whole = static_cast<long>(std::ceil(std::min(seconds, 1e9)));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

double rays_per_second(const RenderProgress& progress) {
  return progress.seconds > 0.0 ? static_cast<double>(progress.rays) / progress.seconds : 0.0;
}

}  // namespace

Progress::Progress(const std::string& style, double time_limit_seconds)
    : time_limit_seconds_(time_limit_seconds) {
  const bool terminal = isatty(STDERR_FILENO) != 0;
  style_ = style == "bar"     ? Style::kBar
           : style == "lines" ? Style::kLines
           : style == "json"  ? Style::kJson
           : style == "none"  ? Style::kNone
           : terminal         ? Style::kBar
                              : Style::kLines;
}

double Progress::seconds_left(const RenderProgress& progress, int first_sample) const {
  const int done = progress.samples_done - first_sample;
  const double by_samples =
      done > 0 ? progress.seconds * (progress.samples_total - progress.samples_done) / done : 0.0;
  if (!(time_limit_seconds_ > 0.0)) return by_samples;
  return std::min(by_samples, std::max(0.0, time_limit_seconds_ - progress.seconds));
}

void Progress::update(const RenderProgress& progress, int first_sample) {
  const bool last = progress.samples_done >= progress.samples_total;
  if (style_ == Style::kNone) return;
  if (style_ == Style::kLines && !last &&
      progress.seconds - last_shown_seconds_ < kSecondsBetweenLines) {
    return;
  }
  last_shown_seconds_ = progress.seconds;
  const double left = seconds_left(progress, first_sample);
  if (style_ == Style::kJson) {
    const nlohmann::json line = {{"spp", progress.samples_done},
                                 {"spp_total", progress.samples_total},
                                 {"seconds", progress.seconds},
                                 {"rays_per_second", rays_per_second(progress)},
                                 {"seconds_left", left}};
    fmt::print(stderr, "{}\n", line.dump());
    return;
  }
  const std::string text =
      fmt::format("{} / {} spp, {:.2f} Mrays/s, {} left", progress.samples_done,
                  progress.samples_total, rays_per_second(progress) * 1e-6, duration(left));
  if (style_ == Style::kLines) {
    fmt::print(stderr, "{}\n", text);
    return;
  }
  const double by_time = time_limit_seconds_ > 0.0 ? progress.seconds / time_limit_seconds_ : 0.0;
  const double by_samples = static_cast<double>(progress.samples_done) / progress.samples_total;
  const int filled = static_cast<int>(kBarWidth * std::min(1.0, std::max(by_time, by_samples)));
  fmt::print(stderr, "\r[{:=<{}}{: <{}}] {}\x1b[K", "", filled, "", kBarWidth - filled, text);
}

// A bar is redrawn for every percent; lines say only which stage has begun.
void Progress::stage(const std::string& name, double done) {
  const int percent = static_cast<int>(100.0 * std::clamp(done, 0.0, 1.0));
  const bool same_stage = name == stage_;
  if (style_ == Style::kNone || (same_stage && percent == stage_percent_)) return;
  stage_ = name, stage_percent_ = percent;
  if (style_ == Style::kJson) {
    const nlohmann::json line = {{"stage", name}, {"done", done}};
    fmt::print(stderr, "{}\n", line.dump());
  } else if (style_ == Style::kBar) {
    const int filled = kBarWidth * percent / 100;
    fmt::print(stderr, "\r[{:=<{}}{: <{}}] {:3} %  {}\x1b[K", "", filled, "", kBarWidth - filled,
               percent, name);
  } else if (!same_stage) {
    fmt::print(stderr, "{} ...\n", name);
  }
}

void Progress::finish() {
  const bool shown = last_shown_seconds_ >= 0.0 || stage_percent_ >= 0;
  if (style_ == Style::kBar && shown) fmt::print(stderr, "\n");
}

void Progress::note(const std::string& text) const {
  if (style_ == Style::kBar || style_ == Style::kLines) fmt::print(stderr, "karat: {}\n", text);
}

}  // namespace karat
