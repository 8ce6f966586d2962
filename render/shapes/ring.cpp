// A finger ring: one of the classic profiles, turned around the z axis.
//
// The section lies in the half plane (rho, z), symmetric in z. Its outer and inner sides are
// circular arcs (or straight), its flanks z = +-width/2 are straight, and arcs of radius
// `edge_radius` join them without a kink, so that the normal turns continuously around the section:
//
//   flat     straight outside and inside
//   court    domed outside, and inside more gently (comfort fit)
//   d-shape  domed outside, straight inside
#include <cmath>

#include "render/shape.h"
#include "render/shapes/revolution.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

constexpr double kPiD = 3.14159265358979323846;

// A dome's height as a fraction of the thickness.
struct Domes {
  double outer, inner;
};

Domes domes_of(const std::string& profile) {
  if (profile == "flat") return {0.0, 0.0};
  if (profile == "court") return {0.4, 0.15};
  return {0.6, 0.0};  // d-shape
}

// One long side of the section, seen as if it were the outer one with its middle at height 0: a
// dome that touches the edge arc of radius `edge` at the angle `tilt` from the middle's normal.
struct Side {
  double radius;       // of the dome's arc; 0: straight
  double tilt;         // radians
  double edge_center;  // height of the edge arc's center (negative: below the middle)

  // A dome of height `rise` over the half width `half`; a half circle at most.
  Side(double rise, double half, double edge) {
    rise = std::min(rise, half);
    const double run = half - edge;
    if (rise == 0.0) {
      radius = tilt = 0.0;
      edge_center = -edge;
      return;
    }
    radius = (half * half + rise * rise) / (2.0 * rise);
    // The edge arc touches the dome from inside: the centers are radius - edge apart.
    tilt = radius > half ? std::asin(run / (radius - edge)) : 0.5 * kPiD;
    edge_center = -radius + (radius - edge) * std::cos(tilt);
  }
};

class Section {
 public:
  Section(double inner_radius, double width, double thickness, double edge, Domes domes,
          int segments)
      : half_(0.5 * width),
        edge_(edge),
        outer_(domes.outer * thickness, half_, edge),
        inner_(domes.inner * thickness, half_, edge),
        resolution_(1e-6 * (inner_radius + thickness)) {
    const double outer_radius = inner_radius + thickness;
    const double flank = (outer_radius + outer_.edge_center) - (inner_radius - inner_.edge_center);
    if (!(flank > 0.0)) {
      throw InputError("the ring's flanks vanish: thickness " + std::to_string(thickness) +
                       " is too small for width " + std::to_string(width) + " and edge_radius " +
                       std::to_string(edge) + " in this profile");
    }
    // Curved parts share the segments by the angle through which they turn.
    per_radian_ = segments / (2.0 * kPiD);
    add_half(outer_, outer_radius, 1.0);
    add_half(inner_, inner_radius, -1.0);
    points_.push_back(points_.front());
    spread_v();
  }

  std::vector<ProfilePoint> take() { return std::move(points_); }

 private:
  // The outer (side = 1) or inner (side = -1) half of the section, counter-clockwise: an edge arc,
  // the dome, the other edge arc. Straight parts need no points of their own.
  void add_half(const Side& s, double middle_rho, double side) {
    const double edge_rho = middle_rho + side * s.edge_center, edge_z = half_ - edge_;
    add_arc(edge_rho, -side * edge_z, edge_, -0.5 * kPiD, -s.tilt, side);
    if (s.radius > 0.0) {
      add_arc(middle_rho - side * s.radius, 0.0, s.radius, -s.tilt, s.tilt, side);
    }
    add_arc(edge_rho, side * edge_z, edge_, s.tilt, 0.5 * kPiD, side);
  }

  // Both ends and the middle included, but not a point that is there already, as far as float can
  // tell.
  void add_arc(double rho, double z, double radius, double from, double to, double side) {
    const int steps = 2 * std::max(1, static_cast<int>(std::ceil(0.5 * (to - from) * per_radian_)));
    for (int i = 0; i <= steps; ++i) {
      const double angle = from + (to - from) * i / steps;
      const double c = side * std::cos(angle), s = side * std::sin(angle);
      const ProfilePoint p{rho + radius * c, z + radius * s, c, s, 0.0};
      if (points_.empty() || distance(points_.back(), p) > resolution_) points_.push_back(p);
    }
  }

  static double distance(const ProfilePoint& a, const ProfilePoint& b) {
    return std::hypot(a.rho - b.rho, a.z - b.z);
  }

  // v is the length along the section, as a fraction of the whole.
  void spread_v() {
    double length = 0.0;
    for (std::size_t i = 1; i < points_.size(); ++i) {
      length += distance(points_[i - 1], points_[i]);
      points_[i].v = length;
    }
    for (ProfilePoint& p : points_) p.v /= length;
  }

  double half_, edge_;
  Side outer_, inner_;
  double resolution_;
  double per_radian_ = 0.0;
  std::vector<ProfilePoint> points_;
};

class RingShape final : public ShapeType {
 public:
  std::string description() const override {
    return "A finger ring around the z axis with rounded edges.";
  }

  std::vector<ParameterInfo> parameters() const override {
    return {{.name = "inner_radius",
             .description = "Smallest radius of the opening, in scene units.",
             .default_json = "1",
             .min = 0,
             .exclusive_min = true},
            {.name = "width",
             .description = "Extent along the axis, in scene units.",
             .default_json = "0.5",
             .min = 0,
             .exclusive_min = true},
            {.name = "thickness",
             .description = "From the opening to the outermost point, in scene units.",
             .default_json = "0.2",
             .min = 0,
             .exclusive_min = true},
            {.name = "profile",
             .type = ParameterType::kChoice,
             .description = "The section: straight, domed on both sides, or domed outside only.",
             .default_json = "\"court\"",
             .choices = {"flat", "court", "d-shape"}},
            {.name = "edge_radius",
             .description = "Radius of the rounded edges, in scene units; a tenth of the lesser of "
                            "width and thickness unless given.",
             .min = 0,
             .exclusive_min = true},
            segments_around_axis(),
            {.name = "segments_v",
             .type = ParameterType::kInteger,
             .description = "Faces along the curved parts of the section, about.",
             .default_json = "96",
             .min = 8,
             .max = 16384}};
  }

  Geometry create(const Parameters& parameters) const override {
    const double width = parameters.number("width"), thickness = parameters.number("thickness");
    const double most = 0.5 * std::min(width, thickness);
    const double edge =
        parameters.has("edge_radius") ? parameters.number("edge_radius") : 0.2 * most;
    if (!(edge < most)) {
      throw InputError("edge_radius " + std::to_string(edge) +
                       " must be less than half of width and of thickness, " +
                       std::to_string(most));
    }
    Section section(parameters.number("inner_radius"), width, thickness, edge,
                    domes_of(parameters.string("profile")), parameters.integer("segments_v"));
    return revolved(section.take(), parameters.integer("segments_u"));
  }
};

KARAT_REGISTER(ShapeType, "ring", RingShape);

}  // namespace
}  // namespace karat
