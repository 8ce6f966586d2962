#include "materials/index/index_names.h"

#include <catch2/catch.hpp>

#include "materials/index/index_catalogue.h"
#include "spectral/support/error.h"

using namespace karat;
using Catch::Contains;

namespace {

using Names = std::vector<std::string>;

const std::vector<TitledName> kKnown{{"main/Au/Johnson", "Au (Gold)"},
                                     {"main/Au/Olmon-ev", "Au (Gold)"},
                                     {"main/Au/Olmon-sc", "Au (Gold)"},
                                     {"main/Co/Johnson", "Co (Cobalt)"},
                                     {"main/CO/Smith", "CO (Carbon monoxide)"},
                                     {"other/Au-Ag/Rioux", "Au-Ag (Gold-silver alloy)"},
                                     {"specs/maker/G1.yml", ""}};

Names names(const std::string& typed) { return matching_names(typed, kKnown).names; }

}  // namespace

TEST_CASE("whole parts of a name, then letters of either case", "[index][index-names]") {
  CHECK(names("Au/Johnson") == Names{"main/Au/Johnson"});
  CHECK(names("Johnson") == Names{"main/Au/Johnson", "main/Co/Johnson"});
  CHECK(names("main/Au").size() == 3);
  CHECK(names("au/johnson") == Names{"main/Au/Johnson"});
  CHECK(names("G1") == Names{"specs/maker/G1.yml"});
  // Cobalt is not carbon monoxide, unless nobody can tell.
  CHECK(names("Co") == Names{"main/Co/Johnson"});
  CHECK(names("CO") == Names{"main/CO/Smith"});
  CHECK(names("co").size() == 2);
  CHECK(matching_names("Au", kKnown).match == NameMatch::kParts);
}

TEST_CASE("words of the title, then the start of a part", "[index][index-names]") {
  CHECK(names("gold").size() == 4);
  CHECK(matching_names("gold", kKnown).match == NameMatch::kTitle);
  CHECK(names("gol").empty());
  CHECK(names("Au/Olm") == Names{"main/Au/Olmon-ev", "main/Au/Olmon-sc"});
  CHECK(names("Olmon-e") == Names{"main/Au/Olmon-ev"});
  CHECK(matching_names("Olmon-e", kKnown).match == NameMatch::kStart);
}

TEST_CASE("what is no part of a name means nothing", "[index][index-names]") {
  for (const char* typed :
       {"", "/", "/Au", "Au/", "Au//Johnson", "ohnson", "Johnson/Au", "(", " "}) {
    INFO('"' << typed << '"');
    CHECK(names(typed).empty());
    CHECK(matching_names(typed, kKnown).match == NameMatch::kNone);
  }
}

TEST_CASE("the command line takes short names, scenes do not", "[index][index-names]") {
  CHECK(full_index_name("main/Au/Johnson") == "main/Au/Johnson");
  CHECK(full_index_name("main/Au/nk/Johnson.yml") == "main/Au/nk/Johnson.yml");
  CHECK(full_index_name("3d/metals/brass") == "3d/metals/brass");
  CHECK(full_index_name("Au/Johnson") == "main/Au/Johnson");
  CHECK(full_index_name("N-BK7") == "specs/SCHOTT-optical/N-BK7");
  CHECK_THROWS_AS(find_index_table("Au/Johnson"), InputError);
  for (const char* typed : {"Johnson", "Au", "gold", "Gold"}) {
    INFO(typed);
    CHECK_THROWS_WITH(full_index_name(typed), Contains("may be any of") &&
                                                  Contains("\n  main/Au/Johnson\n") &&
                                                  Contains("karat nk search"));
  }
  CHECK_THROWS_WITH(full_index_name("Au/Jo"), Contains("did you mean") && Contains("Au/Johnson"));
  CHECK_THROWS_WITH(full_index_name("main/Au/Jonson"),
                    Contains("did you mean \"main/Au/Johnson\""));
}

TEST_CASE("a hint names tables of the book that was typed, never another metal's",
          "[index][index-names]") {
  CHECK(name_hint("Au", kKnown) ==
        "did you mean one of main/Au/Johnson, main/Au/Olmon-ev, main/Au/Olmon-sc?");
  CHECK(name_hint("Au/Johnson", kKnown) == "did you mean \"main/Au/Johnson\"?");
  CHECK(name_hint("main/Au/Jonson", kKnown) == "did you mean \"main/Au/Johnson\"?");
  CHECK(name_hint("main/Au/nk/Jonson.yml", kKnown) == "did you mean \"main/Au/Johnson\"?");
  CHECK(name_hint("mian/Au/Johnson", kKnown) == "did you mean \"main/Au/Johnson\"?");
  CHECK(name_hint("main/gold/Jonson", kKnown) == "did you mean \"main/Au/Johnson\"?");
  CHECK(name_hint("main/Au/Palik", kKnown) ==
        "did you mean one of main/Au/Johnson, main/Au/Olmon-ev, main/Au/Olmon-sc?");
  CHECK(name_hint("Jonson", kKnown) == "did you mean one of main/Au/Johnson, main/Co/Johnson?");
  for (const char* typed : {"Ag/Jonson", "main/Ru/Jonson", "main/Smyth", "Ru", "/", "", "a/"}) {
    INFO(typed);
    CHECK(name_hint(typed, kKnown).empty());
  }
}

TEST_CASE("a full name is asked for by its book's full names", "[index][index-names]") {
  CHECK_THROWS_WITH(find_index_table("Au"), Contains("did you mean one of main/Au/") &&
                                                Contains("more?") && !Contains("Ag"));
  CHECK_THROWS_WITH(find_index_table("main/C/diamond"), Contains("main/C/Peter, main/C/Phillip?"));
  CHECK_THROWS_WITH(find_index_table("main/Ru/Palik"), !Contains("did you mean"));
  CHECK_THROWS_WITH(find_index_table("main/Si/Green-2009"),
                    Contains("main/Si/") && !Contains("H2O"));
}

TEST_CASE("all tables of a material", "[index][index-names]") {
  const Names gold = matching_index_names("Au");
  CHECK(gold.size() >= 10);
  CHECK(gold == matching_index_names("main/Au"));
  CHECK(matching_index_names("main/Au/Johnson") == Names{"main/Au/Johnson"});
  CHECK_THROWS_AS(matching_index_names("Unobtainium"), InputError);
}
