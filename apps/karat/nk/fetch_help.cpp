// karat nk fetch-help: how to get the whole database. It explains; it fetches nothing.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "apps/karat/command.h"

namespace karat {
namespace {

constexpr const char* kHelp =
    R"(The whole refractiveindex.info database (3,700 files, CC0 1.0) in three steps:

  1. Get it (the tables take 60 MB):

       git clone --depth 1 https://github.com/polyanskiy/refractiveindex.info-database.git

  2. Tell Karat where it is, for ever in ~/.profile or for this shell:

       export KARAT_NK_PATH="$PWD/refractiveindex.info-database/database"

     Several folders are separated by colons. A downloaded and unpacked ZIP of the
     repository does as well.

  3. Look:

       karat nk path
       karat nk list --all Au

Karat's own tables and yours (karat nk path) come first; a name that they have means them.
Update it with: git -C refractiveindex.info-database pull
Cite it: M. N. Polyanskiy, Sci. Data 11, 94 (2024), doi:10.1038/s41597-023-02898-2,
and the reference that the table itself names.
)";

class NkFetchHelp final : public Command {
 public:
  void add_to(CLI::App& nk, std::function<int()>& action) const override {
    CLI::App* help = nk.add_subcommand("fetch-help", "How to get the whole database");
    help->footer("Example: karat nk fetch-help");
    help->callback([&action] {
      action = [] {
        fmt::print("{}", kHelp);
        return 0;
      };
    });
  }
};

KARAT_REGISTER(Command, "nk fetch-help", NkFetchHelp);

}  // namespace
}  // namespace karat
