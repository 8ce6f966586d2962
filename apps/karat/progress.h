// How far a render is, on stderr.
#pragma once

#include <memory>
#include <string>

#include "render/renderer.h"

namespace karat {

class Progress {
 public:
  // "bar", "lines", "json", "none", or "" for a bar on a terminal and lines elsewhere. With a time
  // limit the time left is that of the limit.
  Progress(const std::string& style, double time_limit_seconds);

  // `first_sample`: what a checkpoint held; it does not count for the speed.
  void update(const RenderProgress& progress, int first_sample);
  // For work that is no render: `done` of the stage, in [0, 1].
  void stage(const std::string& name, double done);
  void finish();

  // A line for people: left out where the style is json or none.
  void note(const std::string& text) const;

 private:
  enum class Style { kBar, kLines, kJson, kNone };
  double seconds_left(const RenderProgress& progress, int first_sample) const;

  Style style_;
  double time_limit_seconds_;
  double last_shown_seconds_ = -1e9;
  std::string stage_;  // the last one shown, and the percentage of it
  int stage_percent_ = -1;
};

}  // namespace karat
