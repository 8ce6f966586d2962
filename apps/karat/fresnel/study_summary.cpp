// What a study found, in plain language. Every sentence is computed; none is true of all studies.
#include <fmt/format.h>

#include <algorithm>

#include "apps/karat/fresnel/study_report.h"

namespace karat {
std::vector<std::string> study_summary(const StudyReport& report) {
  std::vector<std::string> sentences;
  sentences.push_back(fmt::format("The exact equations take {:.1f} ns for {} wavelengths.", cost_of(report, "exact").ns.median, kLanes));
  return sentences;
}

}  // namespace karat
