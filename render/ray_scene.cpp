#include "render/ray_scene.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

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

void RayScene::bounds(float lower[3], float upper[3]) const {
  RTCBounds box;
  rtcGetSceneBounds(scene_, &box);
  lower[0] = box.lower_x, lower[1] = box.lower_y, lower[2] = box.lower_z;
  upper[0] = box.upper_x, upper[1] = box.upper_y, upper[2] = box.upper_z;
}

}  // namespace karat
