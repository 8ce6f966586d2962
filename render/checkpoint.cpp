#include "render/checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <type_traits>

#include "render/replace_file.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr char kMagic[8] = {'K', 'A', 'R', 'A', 'T', 'C', 'K', '1'};

// Little-endian, as every machine that Embree runs on.
struct Header {
  char magic[8];
  std::uint64_t content_hash;
  std::uint64_t state_bytes;
  std::uint64_t checksum;  // of this header, with 0 here, and the state
  std::int32_t crop[4];
  std::int32_t samples;
  std::uint32_t seed;
  std::int32_t lanes;
  std::uint32_t features;
  std::int32_t spectral_bins;
  std::uint32_t unused;
};
static_assert(std::is_trivially_copyable_v<Header> && sizeof(Header) == 72);

// FNV-1a over 8-byte words, which is fast enough for films of gigabytes; each word's high bits are
// folded down, as multiplication only carries upwards.
std::uint64_t hashed(std::uint64_t hash, const void* data, std::size_t size) {
  const auto* bytes = static_cast<const std::uint8_t*>(data);
  for (std::size_t i = 0; i < size; i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes + i, std::min<std::size_t>(8, size - i));
    hash = (hash ^ word) * 0x100000001b3u;
    hash ^= hash >> 29;
  }
  return hash;
}

std::uint64_t checksum_of(Header header, const std::vector<std::uint8_t>& state) {
  header.checksum = 0;
  return hashed(hashed(0xcbf29ce484222325u, &header, sizeof header), state.data(), state.size());
}

Header header_for(const Scene& scene, const Film& film) {
  Header header{};
  std::memcpy(header.magic, kMagic, sizeof kMagic);
  header.content_hash = scene.content_hash;
  const Crop crop = film.crop();
  header.crop[0] = crop.x0, header.crop[1] = crop.y0;
  header.crop[2] = crop.x1, header.crop[3] = crop.y1;
  header.seed = scene.settings.seed;
  header.lanes = kLanes;
  header.features = film.channels().features ? 1 : 0;
  header.spectral_bins = film.channels().spectral_bins;
  return header;
}

void require_same(const std::string& path, const std::string& what, const std::string& found,
                  const std::string& needed) {
  if (found == needed) return;
  throw InputError(
      path, "checkpoint",
      fmt::format("of another render: its {} is {}, this one's is {}", what, found, needed));
}

std::string crop_text(const Header& h) {
  return fmt::format("[{}, {}, {}, {}]", h.crop[0], h.crop[1], h.crop[2], h.crop[3]);
}

void require_same_scene(const std::string& path, const Header& found, const Header& needed) {
  const auto integer = [](auto value) { return fmt::format("{}", value); };
  require_same(path, "crop", crop_text(found), crop_text(needed));
  require_same(path, "seed", integer(found.seed), integer(needed.seed));
  require_same(path, "number of lanes", integer(found.lanes), integer(needed.lanes));
  const auto features = [](const Header& h) -> std::string {
    return h.features != 0 ? "kept" : "not kept";
  };
  require_same(path, "set of feature layers (--aov)", features(found), features(needed));
  require_same(path, "number of spectral bins", integer(found.spectral_bins),
               integer(needed.spectral_bins));
  require_same(path, "content (scene file, changes to it, or version of Karat)",
               fmt::format("{:016x}", found.content_hash),
               fmt::format("{:016x}", needed.content_hash));
}

bool read_header(std::istream& stream, Header& header) {
  return stream.read(reinterpret_cast<char*>(&header), sizeof header) &&
         std::memcmp(header.magic, kMagic, sizeof kMagic) == 0;
}

}  // namespace

void save_checkpoint(const std::string& path, const Scene& scene, const Film& film,
                     int samples_done) {
  const std::vector<std::uint8_t> state = film.save();
  Header header = header_for(scene, film);
  header.samples = samples_done;
  header.state_bytes = state.size();
  header.checksum = checksum_of(header, state);
  replace_file(path, [&](const std::string& temporary) {
    std::ofstream stream(temporary, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(&header), sizeof header);
    stream.write(reinterpret_cast<const char*>(state.data()),
                 static_cast<std::streamsize>(state.size()));
    stream.close();
    if (!stream) throw RuntimeError("the disk is full or the file cannot be written");
  });
}

std::optional<int> checkpoint_samples(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  Header header{};
  if (!read_header(stream, header)) return std::nullopt;
  return header.samples;
}

int load_checkpoint(const std::string& path, const Scene& scene, Film& film) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    throw InputError(path, "", "no such checkpoint file");
  }
  const auto file_bytes = std::filesystem::file_size(path, error);
  std::ifstream stream(path, std::ios::binary);
  Header header{};
  if (error || !read_header(stream, header)) {
    throw InputError(path, "", "not a checkpoint of this version of Karat");
  }
  require_same_scene(path, header, header_for(scene, film));
  if (header.state_bytes != file_bytes - sizeof header || header.samples < 0) {
    throw InputError(path, "", "damaged checkpoint: its length does not fit its header");
  }
  // The length is the file's own, so no more memory is taken than there is file.
  std::vector<std::uint8_t> state(header.state_bytes);
  if (!stream.read(reinterpret_cast<char*>(state.data()),
                   static_cast<std::streamsize>(state.size())) ||
      checksum_of(header, state) != header.checksum) {
    throw InputError(path, "", "damaged checkpoint: its checksum does not fit");
  }
  film.load(state);
  return header.samples;
}

}  // namespace karat
