#include "materials/index/index_markup.h"

#include <catch2/catch.hpp>
#include <ctime>
#include <string>

using karat::plain_text;

TEST_CASE("citations lose their markup and keep their DOI", "[index][markup]") {
  CHECK(plain_text("A. Author.<br>\n  <a href=\"https://doi.org/10.1103/PhysRevB.6.4370\"><i>Phys. "
                   "Rev. B</i> <b>6</b>, 4370 (1972)</a>\n") ==
        "A. Author. Phys. Rev. B 6, 4370 (1972), doi:10.1103/PhysRevB.6.4370");
  CHECK(plain_text("<a href=\"https://schott.com/x.pdf\">data sheet</a>") == "data sheet");
  CHECK(plain_text("H<sub>2</sub>O, 2 &times; 3 &amp; 4") == "H2O, 2 \u00d7 3 & 4");
  CHECK(plain_text("see **bold** and *italic* [text](https://doi.org/10.1/x) here") ==
        "see bold and italic text, doi:10.1/x here");
}

TEST_CASE("what only looks like markup stays", "[index][markup]") {
  CHECK(plain_text("cut along <111>, 0.3 < L < 2") == "cut along <111>, 0.3 < L < 2");
  CHECK(plain_text("* Ref. 2 gives a * b [1] (x)") == "* Ref. 2 gives a * b [1] (x)");
  CHECK(plain_text("R&D; a<") == "R&D; a<");
}

TEST_CASE("no control character reaches a terminal", "[index][markup]") {
  CHECK(plain_text("a\x1b[31mb\x07"
                   "c\t\r\n d ") == "a [31mb c d");
}

TEST_CASE("text of nothing but openings costs no more than other text", "[index][markup]") {
  // The square of these lengths would take minutes, their sum a second.
  const std::clock_t start = std::clock();
  for (const char opening : {'<', '['}) {
    for (const char* end : {"", ">", "]", "]("}) {
      const std::string text = std::string(2000000, opening) + end;
      if (plain_text(text) != text) FAIL("not kept: " << opening << "..." << end);
    }
  }
  CHECK(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC < 30.0);
}
