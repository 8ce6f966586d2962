// The only file that knows Embree: geometry in, nearest hits and occlusion out. Compiles against
// Embree 3.13 and 4. Rays are plain numbers; nothing of Karat crosses this interface.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

struct RTCSceneTy;  // Embree's own

namespace karat {

struct EmbreeRay {
  float origin[3];
  float direction[3];  // distances are counted in its length
  float tnear = 0.0f;
  float tfar = std::numeric_limits<float>::infinity();
};

struct EmbreeHit {
  float distance;
  float normal[3];  // geometric, not unit, in the coordinates of the hit geometry's own scene
  float u, v;
  std::uint32_t geometry;  // as returned by add_*
  std::uint32_t primitive;
  std::uint32_t instance;  // as returned by add_instance, or kNoInstance
};

// Rays and hits of a packet, component by component.
inline constexpr int kPacket = 16;
struct EmbreePacket {
  alignas(64) float origin[3][kPacket];
  alignas(64) float direction[3][kPacket];
  alignas(64) float tfar[kPacket];
};
struct EmbreePacketHits {
  alignas(64) float distance[kPacket];
  alignas(64) float normal[3][kPacket];
  alignas(64) float u[kPacket];
  alignas(64) float v[kPacket];
  alignas(64) std::uint32_t geometry[kPacket];
  alignas(64) std::uint32_t primitive[kPacket];
  alignas(64) std::uint32_t instance[kPacket];

  EmbreeHit operator[](int i) const {
    return {distance[i], {normal[0][i], normal[1][i], normal[2][i]},
            u[i],        v[i],
            geometry[i], primitive[i],
            instance[i]};
  }
};

// How alike the directions of a packet are: Embree takes rays that start in one point through its
// tree together.
enum class Coherence : std::uint8_t { kNone, kCamera };

// A ray as it was traced, for measurements that trace it again without a renderer around it.
struct RecordedRay {
  EmbreeRay ray;
  bool occlusion;
};

inline constexpr std::uint32_t kNoInstance = 0xffffffffu;

class RayScene {
 public:
  RayScene();
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  // Buffers are copied. Each returns the geometry's number, counted from 0.
  std::uint32_t add_triangles(const float* positions, std::size_t vertices,
                              const std::uint32_t* indices, std::size_t triangles);
  std::uint32_t add_quads(const float* positions, std::size_t vertices,
                          const std::uint32_t* indices, std::size_t quads);
  std::uint32_t add_sphere(const float center[3], float radius);
  std::uint32_t add_disk(const float center[3], const float normal[3], float radius);
  // `transform`: 3x4 column-major, local to world. `scene` must be committed and outlive this one.
  std::uint32_t add_instance(const RayScene& scene, const float transform[12]);

  // Builds the acceleration structure; nothing can be traced before. Throws RuntimeError when
  // Embree reports an error (out of memory).
  void commit();

  bool intersect(const EmbreeRay& ray, EmbreeHit& hit) const;
  bool occluded(const EmbreeRay& ray) const;

  // The same for the rays of a packet whose bit in `active` is set; returns the bits of those that
  // hit something. A ray's result may differ in its last bits from what it is alone.
  std::uint32_t intersect(const EmbreePacket& rays, std::uint32_t active, Coherence coherence,
                          EmbreePacketHits& hits) const;
  std::uint32_t occluded(const EmbreePacket& rays, std::uint32_t active) const;

  // From now on every ray is appended to `target` as well (one thread only); null ends it.
  void record_to(std::vector<RecordedRay>* target);

  // Bounding box of everything, {lower xyz, upper xyz}.
  void bounds(float lower[3], float upper[3]) const;

 private:
  void record(const EmbreeRay& ray, bool occlusion) const;
  void record(const EmbreePacket& rays, std::uint32_t active, bool occlusion) const;

  RTCSceneTy* scene_;
  std::vector<RecordedRay>* record_ = nullptr;
};

}  // namespace karat
