#include "render/ray_scene.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <bit>
#include <cstddef>
#include <cstring>
#include <mutex>
#include <string>
#include <utility>

#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr unsigned kEverything = 0xffffffffu;  // masks are set explicitly: their default changed

// Embree reports errors per device; the last one is kept until commit() turns it into an exception.
struct Device {
  RTCDevice handle = rtcNewDevice(nullptr);
  std::mutex mutex;
  std::string error;

  Device() {
    if (!handle) throw RuntimeError("Embree could not be started");
    rtcSetDeviceErrorFunction(
        handle,
        [](void* self, RTCError, const char* text) {
          auto* device = static_cast<Device*>(self);
          const std::lock_guard lock(device->mutex);
          device->error = text ? text : "unknown error";
        },
        this);
  }
  ~Device() { rtcReleaseDevice(handle); }

  std::string take_error() {
    const std::lock_guard lock(mutex);
    return std::exchange(error, {});
  }
};

Device& device() {
  static Device device;
  return device;
}

// Copies an array of `count` items of `components` 4-byte numbers into a new buffer of a geometry.
void copy_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, const void* source,
                 std::size_t components, std::size_t count) {
  const std::size_t stride = components * sizeof(float);
  void* target = rtcSetNewGeometryBuffer(geometry, type, 0, format, stride, count);
  if (!target) throw RuntimeError("Embree: " + device().take_error());
  if (count > 0) std::memcpy(target, source, stride * count);
}

std::uint32_t attach(RTCScene scene, RTCGeometry geometry) {
  rtcSetGeometryMask(geometry, kEverything);
  rtcCommitGeometry(geometry);
  const unsigned number = rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  return number;
}

std::uint32_t add_mesh(RTCScene scene, RTCGeometryType type, RTCFormat index_format,
                       std::size_t face_vertices, const float* positions, std::size_t vertices,
                       const std::uint32_t* indices, std::size_t faces) {
  RTCGeometry geometry = rtcNewGeometry(device().handle, type);
  copy_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, positions, 3, vertices);
  copy_buffer(geometry, RTC_BUFFER_TYPE_INDEX, index_format, indices, face_vertices, faces);
  return attach(scene, geometry);
}

}  // namespace

RayScene::RayScene() : scene_(rtcNewScene(device().handle)) {}
RayScene::~RayScene() {
  if (scene_) rtcReleaseScene(scene_);
}
RayScene::RayScene(RayScene&& other) noexcept
    : scene_(std::exchange(other.scene_, nullptr)), record_(other.record_) {}
RayScene& RayScene::operator=(RayScene&& other) noexcept {
  std::swap(scene_, other.scene_);
  std::swap(record_, other.record_);
  return *this;
}

std::uint32_t RayScene::add_triangles(const float* positions, std::size_t vertices,
                                      const std::uint32_t* indices, std::size_t triangles) {
  return add_mesh(scene_, RTC_GEOMETRY_TYPE_TRIANGLE, RTC_FORMAT_UINT3, 3, positions, vertices,
                  indices, triangles);
}

std::uint32_t RayScene::add_quads(const float* positions, std::size_t vertices,
                                  const std::uint32_t* indices, std::size_t quads) {
  return add_mesh(scene_, RTC_GEOMETRY_TYPE_QUAD, RTC_FORMAT_UINT4, 4, positions, vertices, indices,
                  quads);
}

std::uint32_t RayScene::add_sphere(const float center[3], float radius) {
  RTCGeometry geometry = rtcNewGeometry(device().handle, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  const float vertex[4] = {center[0], center[1], center[2], radius};
  copy_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, vertex, 4, 1);
  return attach(scene_, geometry);
}

std::uint32_t RayScene::add_disk(const float center[3], const float normal[3], float radius) {
  RTCGeometry geometry = rtcNewGeometry(device().handle, RTC_GEOMETRY_TYPE_ORIENTED_DISC_POINT);
  const float vertex[4] = {center[0], center[1], center[2], radius};
  copy_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, vertex, 4, 1);
  copy_buffer(geometry, RTC_BUFFER_TYPE_NORMAL, RTC_FORMAT_FLOAT3, normal, 3, 1);
  return attach(scene_, geometry);
}

std::uint32_t RayScene::add_instance(const RayScene& scene, const float transform[12]) {
  RTCGeometry geometry = rtcNewGeometry(device().handle, RTC_GEOMETRY_TYPE_INSTANCE);
  rtcSetGeometryInstancedScene(geometry, scene.scene_);
  rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, transform);
  return attach(scene_, geometry);
}

void RayScene::commit() {
  rtcCommitScene(scene_);
  if (const std::string error = device().take_error(); !error.empty()) {
    throw RuntimeError("Embree: " + error);
  }
}

namespace {

// Embree loads origin and direction as vectors of four, which waits long for four separate stores:
// so they are stored as vectors too.
typedef float Float4 __attribute__((vector_size(16)));

RTCRay to_embree(const EmbreeRay& ray) {
  constexpr float kTime = 0.0f;
  const Float4 origin{ray.origin[0], ray.origin[1], ray.origin[2], ray.tnear};
  const Float4 direction{ray.direction[0], ray.direction[1], ray.direction[2], kTime};
  RTCRay r;
  static_assert(offsetof(RTCRay, tnear) == 12 && offsetof(RTCRay, dir_x) == 16 &&
                offsetof(RTCRay, time) == 28);
  std::memcpy(&r.org_x, &origin, sizeof origin);
  std::memcpy(&r.dir_x, &direction, sizeof direction);
  r.tfar = ray.tfar;
  r.mask = kEverything;
  r.id = 0;
  r.flags = 0;
  return r;
}

}  // namespace

void RayScene::record_to(std::vector<RecordedRay>* target) { record_ = target; }

// Apart from the callers, which would load the whole ray before they know that nobody listens.
[[gnu::noinline]] void RayScene::record(const EmbreeRay& ray, bool occlusion) const {
  record_->push_back({ray, occlusion});
}

bool RayScene::intersect(const EmbreeRay& ray, EmbreeHit& hit) const {
  if (record_) [[unlikely]]
    record(ray, false);
  RTCRayHit query;
  query.ray = to_embree(ray);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
  rtcIntersect1(scene_, &query);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene_, &context, &query);
#endif
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
  hit.distance = query.ray.tfar;
  hit.normal[0] = query.hit.Ng_x, hit.normal[1] = query.hit.Ng_y, hit.normal[2] = query.hit.Ng_z;
  hit.u = query.hit.u, hit.v = query.hit.v;
  hit.geometry = query.hit.geomID;
  hit.primitive = query.hit.primID;
  hit.instance = query.hit.instID[0];
  return true;
}

bool RayScene::occluded(const EmbreeRay& ray) const {
  if (record_) [[unlikely]]
    record(ray, true);
  RTCRay query = to_embree(ray);
#if RTC_VERSION_MAJOR >= 4
  rtcOccluded1(scene_, &query);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene_, &context, &query);
#endif
  return query.tfar < 0.0f;  // Embree marks an occluded ray with tfar = -inf
}

namespace {

// Fewer rays are faster alone: a packet costs nearly the same however many of it are alive.
constexpr int kFewestForPacket = 4;

EmbreeRay ray_of(const EmbreePacket& rays, int i) {
  return {{rays.origin[0][i], rays.origin[1][i], rays.origin[2][i]},
          {rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]},
          0.0f,
          rays.tfar[i]};
}

// Fills what a query needs of its rays, and Embree's own form of the mask.
struct alignas(64) PacketMask {
  int valid[kPacket];
};
PacketMask to_embree(const EmbreePacket& rays, std::uint32_t active, RTCRay16& query) {
  constexpr std::size_t kBytes = sizeof rays.tfar;
  std::memcpy(query.org_x, rays.origin[0], kBytes);
  std::memcpy(query.org_y, rays.origin[1], kBytes);
  std::memcpy(query.org_z, rays.origin[2], kBytes);
  std::memcpy(query.dir_x, rays.direction[0], kBytes);
  std::memcpy(query.dir_y, rays.direction[1], kBytes);
  std::memcpy(query.dir_z, rays.direction[2], kBytes);
  std::memcpy(query.tfar, rays.tfar, kBytes);
  PacketMask mask;
#pragma omp simd
  for (int i = 0; i < kPacket; ++i) {
    query.tnear[i] = 0.0f;
    query.time[i] = 0.0f;
    query.mask[i] = kEverything;
    query.id[i] = 0;
    query.flags[i] = 0;
    mask.valid[i] = ((active >> i) & 1u) != 0 ? -1 : 0;
  }
  return mask;
}

}  // namespace

[[gnu::noinline]] void RayScene::record(const EmbreePacket& rays, std::uint32_t active,
                                        bool occlusion) const {
  for (; active != 0; active &= active - 1) {
    record_->push_back({ray_of(rays, std::countr_zero(active)), occlusion});
  }
}

std::uint32_t RayScene::intersect(const EmbreePacket& rays, std::uint32_t active,
                                  Coherence coherence, EmbreePacketHits& hits) const {
  std::uint32_t found = 0;
  if (std::popcount(active) < kFewestForPacket) {
    for (; active != 0; active &= active - 1) {
      const int i = std::countr_zero(active);
      EmbreeHit hit;
      if (!intersect(ray_of(rays, i), hit)) continue;
      found |= 1u << i;
      hits.distance[i] = hit.distance;
      for (int axis = 0; axis < 3; ++axis) hits.normal[axis][i] = hit.normal[axis];
      hits.u[i] = hit.u, hits.v[i] = hit.v;
      hits.geometry[i] = hit.geometry, hits.primitive[i] = hit.primitive;
      hits.instance[i] = hit.instance;
    }
    return found;
  }
  if (record_) [[unlikely]]
    record(rays, active, false);
  RTCRayHit16 query;
  const PacketMask mask = to_embree(rays, active, query.ray);
#pragma omp simd
  for (int i = 0; i < kPacket; ++i) {
    query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
#if RTC_VERSION_MAJOR >= 4
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  if (coherence == Coherence::kCamera) arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  rtcIntersect16(mask.valid, scene_, &query, &arguments);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  if (coherence == Coherence::kCamera) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect16(mask.valid, scene_, &context, &query);
#endif
  std::memcpy(hits.distance, query.ray.tfar, sizeof hits.distance);
  std::memcpy(hits.normal[0], query.hit.Ng_x, sizeof hits.normal[0]);
  std::memcpy(hits.normal[1], query.hit.Ng_y, sizeof hits.normal[1]);
  std::memcpy(hits.normal[2], query.hit.Ng_z, sizeof hits.normal[2]);
  std::memcpy(hits.u, query.hit.u, sizeof hits.u);
  std::memcpy(hits.v, query.hit.v, sizeof hits.v);
  std::memcpy(hits.geometry, query.hit.geomID, sizeof hits.geometry);
  std::memcpy(hits.primitive, query.hit.primID, sizeof hits.primitive);
  std::memcpy(hits.instance, query.hit.instID[0], sizeof hits.instance);
  for (int i = 0; i < kPacket; ++i) {
    found |= std::uint32_t{query.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID} << i;
  }
  return found & active;
}

std::uint32_t RayScene::occluded(const EmbreePacket& rays, std::uint32_t active) const {
  std::uint32_t result = 0;
  if (std::popcount(active) < kFewestForPacket) {
    for (; active != 0; active &= active - 1) {
      const int i = std::countr_zero(active);
      result |= std::uint32_t{occluded(ray_of(rays, i))} << i;
    }
    return result;
  }
  if (record_) [[unlikely]]
    record(rays, active, true);
  RTCRay16 query;
  const PacketMask mask = to_embree(rays, active, query);
#if RTC_VERSION_MAJOR >= 4
  rtcOccluded16(mask.valid, scene_, &query);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded16(mask.valid, scene_, &context, &query);
#endif
  for (int i = 0; i < kPacket; ++i) result |= std::uint32_t{query.tfar[i] < 0.0f} << i;
  return result & active;
}

void RayScene::bounds(float lower[3], float upper[3]) const {
  RTCBounds box;
  rtcGetSceneBounds(scene_, &box);
  lower[0] = box.lower_x, lower[1] = box.lower_y, lower[2] = box.lower_z;
  upper[0] = box.upper_x, upper[1] = box.upper_y, upper[2] = box.upper_z;
}

}  // namespace karat
