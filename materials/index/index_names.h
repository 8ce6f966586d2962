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

// What to say of a name that no table has, by the same rules: `did you mean "main/Au/Johnson"?`, or
// `did you mean one of main/C/Peter, main/C/Phillip?` (a few, then a count). Where nothing matches,
// the pages of the book that was typed; a slip in a page is mended within its book alone, because
// the table of another metal is no answer. "" where there is nothing to say.
std::string name_hint(const std::string& typed, const std::vector<TitledName>& known);

}  // namespace karat
