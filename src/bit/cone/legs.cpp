#include "bit/cone/legs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "bit/bit.hpp"
#include "core/types.hpp"
#include "mesh/measures.hpp"

namespace tdbd::bit {
namespace {

struct OutlinePoint {
  double x, y;  ///< m
};

/// The shank's outline normal to the bit's axis, counter-clockwise about +z, in a frame rotated
/// about it.
using ShankOutline = std::vector<OutlinePoint>;

/// Frame P of a leg: its origin is the bit's origin; x is along the horizontal projection of the
/// journal.
struct LegFrame {
  Pose X_BP;
  Vec3 s_P;     ///< along the journal, outwards
  Vec3 down_P;  ///< perpendicular to the journal, downwards
  Vec3 base_P;  ///< where the journal meets the leg's inner plane
};

LegFrame leg_frame(const Cone& cone, const Legs& legs) {
  const Vec3 s_B = -cone.X_BK.R.col(2);
  const Vec3 x_B = Vec3(s_B.x(), s_B.y(), 0.0).normalized();
  LegFrame f;
  f.X_BP.R << x_B, Vec3::UnitZ().cross(x_B), Vec3::UnitZ();
  f.X_BP.p = Vec3::Zero();
  f.s_P = f.X_BP.R.transpose() * s_B;
  f.down_P = f.s_P.cross(Vec3::UnitY());
  f.base_P =
      f.X_BP.R.transpose() * cone.X_BK.p + (cone.layout.shell.back().s + legs.clearance) * f.s_P;
  return f;
}

const Part* shank_of(const Bit& bit) {
  const auto at = std::ranges::find(bit.parts, "bit-body", &Part::name);
  return at == bit.parts.end() || bit.shank.radius <= 0.0 ? nullptr : &*at;
}

ShankOutline shank_outline(const Part& shank, const Pose& X_BP) {
  ShankOutline outline;
  const double lower_end = mesh::bounding_box(shank.mesh_P).hi.z();
  for (const Vec3& x_B : shank.mesh_P.positions)
    if (const Vec3 x_P = X_BP.R.transpose() * x_B;
        x_B.z() == lower_end && x_P.head<2>().norm() > 0.0)
      outline.push_back({x_P.x(), x_P.y()});
  std::ranges::sort(outline, {}, [](const OutlinePoint& c) { return std::atan2(c.y, c.x); });
  return outline;
}

/// The outline's largest x at y; nothing outside its width.
std::optional<double> side_at(const ShankOutline& outline, double y) {
  std::optional<double> x;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const OutlinePoint &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if (std::min(a.y, b.y) > y || std::max(a.y, b.y) < y || a.y == b.y) continue;
    x = std::max(x.value_or(-1e300), a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
  }
  return x;
}

double tip_radius_of(const Cone& cone, const Legs& legs) {
  return legs.tip_radius > 0.0 ? legs.tip_radius : cone.layout.shell.back().r;
}

/// A slice at one y: the shirttail's edge on the inner plane and on the gage, the shoulder, the
/// top, the shank's lower edge, and the point where the plane meets the shank's lower end.
constexpr std::size_t slice_corners = 6;
using LegSlice = std::array<Vec3, slice_corners>;

struct LegShape {
  LegFrame frame;
  ShankOutline shank;
  double radius = 0.0;  ///< m, distance of the outer side from the bit's axis
  double tip_radius = 0.0;
  double half_width = 0.0;
  double lower_end = 0.0, shoulder = 0.0, top = 0.0;  ///< m, heights above the bit's origin
};

LegShape shape_of(const Bit& bit, std::size_t k, const Legs& legs) {
  LegShape s;
  s.frame = leg_frame(bit.cones[k], legs);
  s.shank = shank_outline(*shank_of(bit), s.frame.X_BP);
  s.radius = bit.gage_radius - legs.under_gage;
  s.tip_radius = tip_radius_of(bit.cones[k], legs);
  s.half_width = 0.5 * legs.width;
  s.lower_end = bit.shank.height;
  s.shoulder = legs.shoulder;
  s.top = legs.top;
  return s;
}

/// The shirttail's edge on the inner plane, at u from the journal, measured across it.
Vec3 tip_at(const LegShape& leg, double u) {
  const double below = std::sqrt(std::max(0.0, leg.tip_radius * leg.tip_radius - u * u));
  return leg.frame.base_P + below * leg.frame.down_P + u * Vec3::UnitY();
}

/// Where the inner plane meets the shank's lower end.
double inner_x(const LegShape& leg) {
  const LegFrame& f = leg.frame;
  return f.base_P.x() + (-leg.lower_end - f.base_P.z()) / f.down_P.z() * f.down_P.x();
}

LegSlice slice_at(const LegShape& leg, double u) {
  const double y = leg.frame.base_P.y() + u;
  const double outer = std::sqrt(leg.radius * leg.radius - y * y);
  const double side = side_at(leg.shank, y).value_or(0.0);
  const Vec3 tip = tip_at(leg, u);
  return {tip,
          tip + (outer - tip.x()) / leg.frame.s_P.x() * leg.frame.s_P,
          Vec3(outer, y, -leg.shoulder),
          Vec3(side, y, -leg.top),
          Vec3(side, y, -leg.lower_end),
          Vec3(inner_x(leg), y, -leg.lower_end)};
}

/// Places of the slices across the journal: both sides, the shank's corners, and others in between,
/// closer where the shirttail's arc is steeper.
std::vector<double> slice_places(const LegShape& leg, int slices) {
  constexpr double apart = 1e-5;  // m
  std::vector<double> places{-leg.half_width, leg.half_width};
  const auto add = [&](double u) {
    if (std::abs(u) < leg.half_width &&
        std::ranges::none_of(places, [&](double p) { return std::abs(p - u) < apart; }))
      places.push_back(u);
  };
  for (const OutlinePoint& c : leg.shank)
    if (c.x > 0.0) add(c.y - leg.frame.base_P.y());
  for (int k = 1; k < slices; ++k)
    add(leg.half_width * std::sin(right_angle * (2.0 * k / slices - 1.0)));
  std::ranges::sort(places);
  return places;
}

mesh::TriangleMesh leg_mesh(const LegShape& leg, int slices) {
  constexpr int n = static_cast<int>(slice_corners), shank_edge = 4;
  mesh::TriangleMesh m;
  for (const double u : slice_places(leg, slices))
    for (const Vec3& x_P : slice_at(leg, u)) m.positions.push_back(x_P);
  const int last = static_cast<int>(m.positions.size()) - n;
  for (int first = 0; first < last; first += n)
    for (int i = 0; i < n; ++i) {
      const int a = first + i, b = first + (i + 1) % n;
      m.triangles.push_back({a, b, b + n});
      m.triangles.push_back({a, b + n, a + n});
    }
  for (int i = 1; i + 1 < n; ++i) {  // a fan from the only reentrant corner
    const int b = (shank_edge + i) % n, c = (shank_edge + i + 1) % n;
    m.triangles.push_back({shank_edge, c, b});
    m.triangles.push_back({last + shank_edge, last + b, last + c});
  }
  return m;
}

/// Heights above the bit's origin, in the middle of the leg, between which its outer side is on the
/// gage.
struct OuterFace {
  double from, to;
};

OuterFace outer_face(const LegShape& leg) { return {-slice_at(leg, 0.0)[1].z(), leg.shoulder}; }

Part insert_part(const LegShape& leg, const Legs& legs, double height) {
  constexpr int segments = 24;
  const double y = leg.frame.base_P.y(), r = 0.5 * legs.insert_diameter;
  const double face = legs.insert_protrusion, back = face - legs.insert_length;
  const Vec3 out(std::sqrt(leg.radius * leg.radius - y * y) / leg.radius, y / leg.radius, 0.0);
  Pose X_LP;
  X_LP.R << out, Vec3::UnitZ().cross(out), Vec3::UnitZ();
  X_LP.p = leg.radius * out - height * Vec3::UnitZ();
  Part insert;
  insert.kind = PartKind::gage_pad;
  insert.cutting = legs.cutting;
  insert.X_BP = leg.frame.X_BP * X_LP;
  insert.mesh_P = surface_of_revolution(
      {{0.0, face, 1}, {r, face, segments}, {r, back, segments}, {0.0, back, 1}});
  insert.update_direction_B = Vec3::UnitX();
  return insert;
}

using LegFaults = std::vector<LegFault>;

void check_shape(const LegShape& leg, std::size_t k, const Legs& legs, LegFaults& faults) {
  const std::string name = fmt::format("leg-{}", k + 1);
  const double y = std::abs(leg.frame.base_P.y()) + leg.half_width;
  if (leg.half_width > leg.tip_radius)
    return faults.push_back({LegTable::legs, k, "width", mm_text(legs.width),
                             "at most twice the shirttail's radius, " + mm_text(leg.tip_radius)});
  const std::optional<double> side = side_at(leg.shank, y), other = side_at(leg.shank, -y);
  if (!side || !other)
    return faults.push_back({LegTable::legs, k, "width",
                             fmt::format("{}, of a leg that reaches {} from the plane through the "
                                         "bit's axis",
                                         mm_text(legs.width), mm_text(y)),
                             "a leg narrower than the shank"});
  for (const double u : slice_places(leg, usual_leg_slices))
    if (const double reach = tip_at(leg, u).head<2>().norm(); reach >= leg.radius)
      return faults.push_back(
          {LegTable::legs, k, "tip_radius",
           fmt::format("{}, a shirttail that reaches {} from the bit's axis",
                       mm_text(leg.tip_radius), mm_text(reach)),
           "one inside the gage radius less under_gage, " + mm_text(leg.radius)});
  const double inner = inner_x(leg), nearest = std::min(*side, *other);
  if (inner >= nearest || inner <= 0.0)
    return faults.push_back(
        {LegTable::shank, k, "height",
         fmt::format("{}, where the inner side of {} is {} from the bit's axis",
                     mm_text(leg.lower_end), name, mm_text(inner)),
         fmt::format("a height at which the shank, there {} from the axis, meets the leg",
                     mm_text(nearest))});
  double tip = -1e300;
  for (const double u : slice_places(leg, usual_leg_slices))
    tip = std::max(tip, -slice_at(leg, u)[1].z());
  if (leg.shoulder <= tip || leg.shoulder > leg.top)
    faults.push_back({LegTable::legs, k, "shoulder", mm_text(leg.shoulder),
                      fmt::format("a height above the shirttail's, {}, and at most legs.top, {}",
                                  mm_text(tip), mm_text(leg.top))});
}

void check_inserts(const Bit& bit, const LegShape& leg, std::size_t k, const Legs& legs,
                   LegFaults& faults) {
  if (legs.inserts == 0) return;
  const OuterFace face = outer_face(leg);
  const double high = face.to - face.from;
  if (legs.inserts * legs.insert_diameter > high)
    faults.push_back({LegTable::legs, k, "inserts",
                      fmt::format("{} of {}", legs.inserts, mm_text(legs.insert_diameter)),
                      fmt::format("at most {}, on an outer side {} high",
                                  std::floor(high / legs.insert_diameter), mm_text(high))});
  const double reach = std::hypot(leg.radius + legs.insert_protrusion, 0.5 * legs.insert_diameter);
  if (reach > bit.gage_radius)
    faults.push_back({LegTable::legs, k, "insert_protrusion",
                      fmt::format("{}, inserts that reach {} from the bit's axis",
                                  mm_text(legs.insert_protrusion), mm_text(reach)),
                      "inserts that stay inside the gage radius, " + mm_text(bit.gage_radius)});
}

/// Each leg must be in its own sector about the bit's axis, with slots between the legs.
void check_sectors(const Bit& bit, const std::vector<LegShape>& shapes, const Legs& legs,
                   LegFaults& faults) {
  struct Sector {
    double middle, before, after;  ///< rad
  };
  std::vector<Sector> sectors;
  for (const LegShape& leg : shapes) {
    Sector s{std::atan2(leg.frame.X_BP.R(1, 0), leg.frame.X_BP.R(0, 0)), 0.0, 0.0};
    for (const Vec3& x_P : leg_mesh(leg, usual_leg_slices).positions) {
      const double angle = std::atan2(x_P.y(), x_P.x());
      s.before = std::max(s.before, -angle);
      s.after = std::max(s.after, angle);
    }
    sectors.push_back(s);
  }
  for (std::size_t i = 0; i < sectors.size(); ++i)
    for (std::size_t k = 0; k < sectors.size(); ++k) {
      if (i == k) continue;
      double turn = std::fmod(sectors[k].middle - sectors[i].middle, full_turn);
      if (turn < 0.0) turn += full_turn;
      const double gap = turn - sectors[i].after - sectors[k].before;
      if (gap < 0.0)
        faults.push_back(
            {LegTable::legs, i, "width",
             fmt::format("{}, with which the azimuths of leg-{} and leg-{} overlap by {}",
                         mm_text(legs.width), i + 1, k + 1, degree_text(-gap)),
             fmt::format("a slot between all {} legs", bit.cones.size())});
    }
}

}  // namespace

std::vector<LegFault> leg_faults(const Bit& bit, const Legs& legs) {
  constexpr double least_cosine =
      0.2;  // of a journal's angle: beyond about 78 degrees legs are nearly horizontal
  if (shank_of(bit) == nullptr)
    return {{LegTable::legs, 0, "width", mm_text(legs.width) + ", legs without a shank",
             "[shank] with a radius"}};
  LegFaults faults;
  const Shank& shank = bit.shank;
  if (shank.radius >= bit.gage_radius - legs.under_gage)
    faults.push_back({LegTable::shank, 0, "radius", mm_text(shank.radius),
                      "less than the gage radius less legs.under_gage, " +
                          mm_text(bit.gage_radius - legs.under_gage)});
  if (legs.top <= shank.height || legs.top > shank.height + shank.length)
    faults.push_back(
        {LegTable::legs, 0, "top", mm_text(legs.top),
         fmt::format("a height above the shank's lower end, {}, and at most its upper one, {}",
                     mm_text(shank.height), mm_text(shank.height + shank.length))});
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    if (const double out = bit.cones[k].X_BK.R.col(2).head<2>().norm(); out < least_cosine)
      faults.push_back({LegTable::cone, k, "journal_angle", degree_text(std::acos(out)),
                        "at most 78 deg with legs"});
  if (!faults.empty()) return faults;
  std::vector<LegShape> shapes;
  for (std::size_t k = 0; k < bit.cones.size(); ++k) shapes.push_back(shape_of(bit, k, legs));
  for (std::size_t k = 0; k < shapes.size() && faults.empty(); ++k) {
    check_shape(shapes[k], k, legs, faults);
    if (faults.empty()) check_inserts(bit, shapes[k], k, legs, faults);
  }
  if (faults.empty()) check_sectors(bit, shapes, legs, faults);
  return faults;
}

void add_legs(Bit& bit, const Legs& legs, int slices) {
  bit.legs = legs;
  std::vector<Part> parts;
  for (std::size_t k = 0; k < bit.cones.size(); ++k) {
    const LegShape shape = shape_of(bit, k, legs);
    Part leg;
    leg.name = fmt::format("leg-{}", k + 1);
    leg.kind = PartKind::bit_body;
    leg.cutting = legs.cutting;
    leg.X_BP = shape.frame.X_BP;
    leg.mesh_P = leg_mesh(shape, slices);
    leg.density = legs.density;
    parts.push_back(leg);
    const OuterFace face = outer_face(shape);
    for (int i = 0; i < legs.inserts; ++i) {
      const double height = face.from + (i + 0.5) / legs.inserts * (face.to - face.from);
      parts.push_back(insert_part(shape, legs, height));
      parts.back().name = fmt::format("{}/insert-{}", leg.name, i + 1);
    }
  }
  for (Part& part : parts) bit.parts.push_back(std::move(part));
}

}  // namespace tdbd::bit
