// Where the files of data/ are found at run time.
#pragma once

#include <string>

namespace karat {

// The full path of a file or folder below data/, for example data_path("cie/cie1931.json"). Looks
// in $KARAT_DATA, then in the source tree that the program was built from, then where it was
// installed. Throws RuntimeError naming the places when it is in none of them.
std::string data_path(const std::string& relative);

}  // namespace karat
