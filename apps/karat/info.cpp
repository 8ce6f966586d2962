// karat info: what an image says of how it was made.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/karat/command.h"
#include "render/image_file.h"

namespace karat {
namespace {

struct Options {
  std::string file;
  bool json = false;
};

// The attributes that Karat wrote, without their prefix.
nlohmann::json provenance(const Image& image) {
  const std::string prefix = "karat:";
  nlohmann::json result = nlohmann::json::object();
  const auto add = [&](const std::string& name, const auto& value) {
    if (name.starts_with(prefix)) result[name.substr(prefix.size())] = value;
    if (name == "spectralLayoutVersion" || name == "emissiveUnits") result[name] = value;
  };
  for (const auto& [name, text] : image.attributes) add(name, text);
  for (const auto& [name, number] : image.number_attributes) {
    const auto whole = static_cast<std::int64_t>(std::clamp(number, -1e15, 1e15));
    if (static_cast<double>(whole) == number) {
      add(name, whole);
    } else {
      add(name, number);
    }
  }
  return result;
}

void print_text(const Options& options, const Image& image, const nlohmann::json& facts) {
  fmt::print("{}: {} x {} pixels", options.file, image.width, image.height);
  if (image.width != image.full_width || image.height != image.full_height) {
    fmt::print(" at ({}, {}) of {} x {}", image.x, image.y, image.full_width, image.full_height);
  }
  fmt::print("\nchannels: {}\n", fmt::join(image.channels, " "));
  for (const auto& [name, value] : facts.items()) {
    std::string text = value.is_string() ? value.get<std::string>() : value.dump();
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 3) {
      text.replace(at, 1, "\n  ");
    }
    fmt::print("{}: {}\n", name, text);
  }
  if (facts.empty()) fmt::print("no provenance: not written by karat\n");
}

int run(const Options& options) {
  const Image image = read_image_header(options.file);
  const nlohmann::json facts = provenance(image);
  if (!options.json) {
    print_text(options, image, facts);
    return 0;
  }
  const nlohmann::json all = {{"file", options.file},
                              {"width", image.width},
                              {"height", image.height},
                              {"channels", image.channels},
                              {"provenance", facts}};
  fmt::print("{}\n", all.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  return 0;
}

class InfoCommand final : public Command {
 public:
  void add_to(CLI::App& app, std::function<int()>& action) const override {
    const auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("info", "Print how an image was made");
    command->add_option("file", options->file, "Image file (EXR)")->required();
    command->add_flag("--json", options->json, "Machine-readable output");
    command->footer("Example: karat info rings.exr");
    command->callback([&action, options] { action = [options] { return run(*options); }; });
  }
};

KARAT_REGISTER(Command, "info", InfoCommand);

}  // namespace
}  // namespace karat
