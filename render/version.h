// Which Karat this is.
#pragma once

#include <string>

namespace karat {

std::string version();   // "0.1.0"
std::string commit();    // abbreviated hash of the sources, or "" where it was not known
std::string compiler();  // "GCC 12.2.0"

// "Embree 3.13.5, OpenColorIO 2.1.2, ..." as found when this was built.
std::string libraries();

}  // namespace karat
