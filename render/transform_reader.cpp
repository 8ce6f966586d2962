#include "render/transform_reader.h"

#include <cmath>

namespace karat {
namespace {

constexpr double kLargest = 1e12;

Vec3 read_vector(const JsonValue& value) {
  const auto v = value.numbers(3, {-kLargest, kLargest});
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

Transform read_rotate(const JsonValue& value) {
  value.allow_keys({"axis", "angle_deg"});
  const Vec3 axis = read_vector(value.member("axis"));
  const float l2 = length_squared(axis);
  if (!(l2 > 1e-30f) || !std::isfinite(l2)) {
    value.member("axis").fail_found("a direction, not zero");
  }
  const double degrees = value.member("angle_deg").number({-1e6, 1e6});
  return Transform::rotate(axis, static_cast<float>(degrees * 3.14159265358979323846 / 180.0));
}

Transform read_scale(const JsonValue& value) {
  if (value.json().is_number()) {
    const auto s = static_cast<float>(value.number({-kLargest, kLargest}));
    return Transform::scale({s, s, s});
  }
  return Transform::scale(read_vector(value));
}

Transform read_look_at(const JsonValue& value) {
  value.allow_keys({"from", "to", "up"});
  const Vec3 from = read_vector(value.member("from")), to = read_vector(value.member("to"));
  const Vec3 z = to - from;
  if (!(length_squared(z) > 0.0f)) value.member("to").fail_found("a point other than \"from\"");
  const auto across = [&](const Vec3& up) {
    return length_squared(cross(up, z)) > 1e-12f * length_squared(up) * length_squared(z);
  };
  Vec3 up{0, 0, 1};
  if (value.has("up")) {
    const JsonValue given = value.member("up");
    up = read_vector(given);
    if (!(length_squared(up) > 0.0f)) given.fail_found("a direction, not zero");
    if (!across(up)) {
      given.fail_found(
          "a direction across the line from \"from\" to \"to\"; without \"up\" one is "
          "chosen");
    }
  } else if (!across(up)) {
    up = {0, 1, 0};
  }
  const Vec3 x = cross(up, z);
  const Vec3 unit_z = normalize(z), unit_x = normalize(x);
  return {unit_x, cross(unit_z, unit_x), unit_z, from};
}

Transform read_matrix(const JsonValue& value) {
  const std::size_t count = value.json().is_array() && value.size() == 12 ? 12 : 16;
  if (!value.json().is_array() || value.size() != count) {
    value.fail_found("12 or 16 numbers, row by row");
  }
  const auto numbers = value.numbers(count, {-kLargest, kLargest});
  const auto m = [&](std::size_t row, std::size_t column) {
    return static_cast<float>(numbers[4 * row + column]);
  };
  const auto column = [&](std::size_t c) { return Vec3{m(0, c), m(1, c), m(2, c)}; };
  if (count == 16 && (m(3, 0) != 0 || m(3, 1) != 0 || m(3, 2) != 0 || m(3, 3) != 1)) {
    value.fail("the last row must be 0 0 0 1: only affine transforms are allowed");
  }
  return {column(0), column(1), column(2), column(3)};
}

Transform read_operation(const JsonValue& operation) {
  operation.allow_keys({"translate", "rotate", "scale", "look_at", "matrix"});
  if (operation.size() != 1) operation.fail_found("one operation in each {...} of the list");
  const std::string name = operation.keys().front();
  const JsonValue value = operation.member(name);
  if (name == "translate") return Transform::translate(read_vector(value));
  if (name == "rotate") return read_rotate(value);
  if (name == "scale") return read_scale(value);
  if (name == "look_at") return read_look_at(value);
  return read_matrix(value);
}

}  // namespace

Transform read_transform(const JsonValue& list) {
  list.require_array();
  Transform result;
  for (std::size_t i = 0; i < list.size(); ++i) result = read_operation(list.element(i)) * result;
  const float determinant = result.determinant();
  if (!std::isfinite(determinant) || determinant == 0.0f ||
      !std::isfinite(dot(result.origin, {1, 1, 1}))) {
    list.fail(
        "the transform has no inverse: a scale is zero, or a number is too large or too small");
  }
  return result;
}

Json transform_schema() {
  const Json number = {{"type", "number"}};
  const Json vector = {{"type", "array"}, {"items", number}, {"minItems", 3}, {"maxItems", 3}};
  const auto object = [](const Json& properties, const Json& required) {
    return Json{{"type", "object"},
                {"properties", properties},
                {"required", required},
                {"additionalProperties", false}};
  };
  const Json matrix = {{"type", "array"}, {"items", number}, {"minItems", 12}, {"maxItems", 16}};
  const Json operations = {
      {"translate", vector},
      {"rotate", object({{"axis", vector}, {"angle_deg", number}}, {"axis", "angle_deg"})},
      {"scale", {{"anyOf", Json::array({number, vector})}}},
      {"look_at", object({{"from", vector}, {"to", vector}, {"up", vector}}, {"from", "to"})},
      {"matrix", matrix}};
  Json operation = object(operations, Json::array());
  operation.erase("required");
  operation["minProperties"] = 1;
  operation["maxProperties"] = 1;
  return {{"description", "Operations, the first one applied first."},
          {"type", "array"},
          {"items", operation}};
}

}  // namespace karat
