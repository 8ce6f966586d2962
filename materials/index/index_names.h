// What a person means who types a part of an index table's name.
#pragma once

#include <string>
#include <vector>

namespace karat {

// A table's full name, "main/Au/Johnson", and the title of its book, "Au (Gold)".
struct TitledName {
  std::string name;
  std::string title;
};

// How much of a name was typed.
enum class NameMatch {
  kNone,
  kParts,  // whole parts, in a row: "Johnson", "Au/Johnson", "main/Au"; "au/johnson" where no name
           // has these letters
  kTitle,  // words of the title: "gold"
  kStart,  // parts, the last one begun: "Au/Olm"
};

struct MatchingNames {
  NameMatch match = NameMatch::kNone;
  std::vector<std::string> names;  // in the order of `known`
};

// The names that `typed` means by the first kind of match, in the order above, that gives any.
MatchingNames matching_names(const std::string& typed, const std::vector<TitledName>& known);

// The name in `known` that is nearest to what was typed, whole or in its last parts: for
// "Au/Jonson" "main/Au/Johnson". "" where none is near.
std::string nearest_full_name(const std::string& typed, const std::vector<std::string>& known);

}  // namespace karat
