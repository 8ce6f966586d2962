#include "apps/karat/output_files.h"

#include <fmt/format.h>

#include <filesystem>

#include "apps/karat/run_karat.h"
#include "render/checkpoint.h"
#include "render/replace_file.h"

namespace karat {
namespace {

namespace fs = std::filesystem;

struct OutputFile {
  const char* option;
  std::string path;
};

std::vector<OutputFile> output_files(const RenderCommandOptions& options) {
  std::vector<OutputFile> files;
  for (const auto& path : options.outputs) files.push_back({"-o", path});
  if (!options.spectral.empty()) files.push_back({"--spectral", options.spectral});
  if (!options.checkpoint.empty()) files.push_back({"--checkpoint", options.checkpoint});
  if (!options.stats.empty()) files.push_back({"--stats", options.stats});
  return files;
}

void require_distinct(const std::vector<OutputFile>& files) {
  for (std::size_t i = 0; i < files.size(); ++i) {
    for (std::size_t j = i + 1; j < files.size(); ++j) {
      const auto &a = files[i], &b = files[j];
      if (!same_file(a.path, b.path)) continue;
      throw UsageError(fmt::format("{} \"{}\" and {} \"{}\" are the same file", a.option, a.path,
                                   b.option, b.path));
    }
  }
}

void require_other(const std::vector<OutputFile>& files, const std::string& input,
                   const std::string& what) {
  for (const auto& file : files) {
    if (!same_file(file.path, input)) continue;
    throw UsageError(fmt::format("{}: \"{}\" {}", file.option, file.path, what));
  }
}

void require_new_or_resumed(const RenderCommandOptions& options) {
  const std::string& path = options.checkpoint;
  std::error_code error;
  if (path.empty() || options.resume || !fs::is_regular_file(path, error)) return;
  const std::optional<int> samples = checkpoint_samples(path);
  if (!samples) {
    throw UsageError(
        fmt::format("--checkpoint: \"{}\" exists and is not a checkpoint of this version of Karat; "
                    "give another name, or delete it",
                    path));
  }
  throw UsageError(
      fmt::format("--checkpoint: \"{}\" exists and holds {} spp: --resume goes on with it, or "
                  "delete it",
                  path, *samples));
}

}  // namespace

void require_safe_outputs(const RenderCommandOptions& options) {
  const std::vector<OutputFile> files = output_files(options);
  require_other(files, options.scene, "is the scene file");
  if (!options.ocio.empty()) {
    require_other(files, options.ocio, "is the OpenColorIO configuration");
  }
  require_distinct(files);
  require_new_or_resumed(options);
}

void require_outputs_apart(const RenderCommandOptions& options,
                           const std::vector<std::string>& inputs) {
  const std::vector<OutputFile> files = output_files(options);
  for (const auto& input : inputs) require_other(files, input, "is read by the scene");
}

}  // namespace karat
