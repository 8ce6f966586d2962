#include "spectral/observer.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

#include "spectral/spectrum_file.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

Observer read_observer(const std::string& name) {
  const std::string path = named_data_file("cie", "observer", name);
  const SpectrumFile file(path);
  Observer o;
  o.name = name;
  o.description = file.text("description");
  o.source = file.text("source");
  o.xbar = file.table("xbar", name + " xbar");
  o.ybar = file.table("ybar", name + " ybar");
  o.zbar = file.table("zbar", name + " zbar");
  o.range = o.ybar->range();
  if (!o.range.covers(o.xbar->range()) || !o.xbar->range().covers(o.range) ||
      !o.range.covers(o.zbar->range()) || !o.zbar->range().covers(o.range)) {
    throw InputError(path, "", "xbar, ybar and zbar must have the same number of values");
  }
  const NanometreGrid grid = nanometre_grid(o.range);
  for (int i = 0; i < grid.count; ++i) o.ybar_integral += (*o.ybar)(grid.first_nm + i);
  if (!(o.ybar_integral > 0.0)) throw InputError(path, "ybar", "must have a sum above 0");
  return o;
}

}  // namespace

const Observer& observer(const std::string& name) {
  static std::mutex mutex;
  static std::map<std::string, Observer> observers;
  const std::lock_guard<std::mutex> lock(mutex);
  const auto it = observers.find(name);
  return it != observers.end() ? it->second
                               : observers.emplace(name, read_observer(name)).first->second;
}

std::vector<std::string> observer_names() { return data_names("cie"); }

NanometreGrid nanometre_grid(WavelengthRange range) {
  const int first = static_cast<int>(std::ceil(range.min_nm));
  const int last = static_cast<int>(std::floor(range.max_nm));
  return {first, std::max(0, last - first + 1)};
}

}  // namespace karat
