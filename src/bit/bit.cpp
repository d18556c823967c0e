#include "bit/bit.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/types.hpp"

namespace tdbd::bit {
namespace {

std::string joined_by(char sign, std::string words) {
  std::ranges::replace(words, ' ', sign);
  return words;
}

}  // namespace

std::string_view kind_words(PartKind kind) {
  switch (kind) {
    case PartKind::face:
      return "face";
    case PartKind::chamfer:
      return "chamfer";
    case PartKind::cse:
      return "cse";
    case PartKind::cutter_body:
      return "cutter body";
    case PartKind::gage_pad:
      return "gage pad";
    case PartKind::bit_body:
      return "bit body";
    case PartKind::cone:
      return "cone";
    case PartKind::tooth:
      return "tooth";
  }
  return "unknown";
}

std::string kind_name(PartKind kind) { return joined_by('-', std::string(kind_words(kind))); }

std::string kind_key(PartKind kind) { return joined_by('_', std::string(kind_words(kind))); }

std::vector<std::string_view> part_kind_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    all.reserve(part_kinds.size());
    for (const PartKind kind : part_kinds) all.push_back(kind_name(kind));
    return all;
  }();
  return {names.begin(), names.end()};
}

PartKind part_kind_named(std::string_view name) {
  for (const PartKind kind : part_kinds)
    if (kind_name(kind) == name) return kind;
  return PartKind::face;
}

std::string cutting_name(Cutting cutting) {
  switch (cutting) {
    case Cutting::cuts:
      return "yes";
    case Cutting::rubs:
      return "rubs";
    case Cutting::never:
      break;
  }
  return "no";
}

mesh::TriangleMesh mesh_B(const Part& part) {
  mesh::TriangleMesh m = part.mesh_P;
  for (Vec3& x : m.positions) x = part.X_BP * x;
  return m;
}

double largest_radius(const std::vector<Part>& parts) {
  double radius = 0.0;
  for (const Part& part : parts) {
    if (part.cutting != Cutting::cuts) continue;
    for (const Vec3& x_P : part.mesh_P.positions) {
      const Vec3 x_B = part.X_BP * x_P;
      radius = std::max(radius, std::hypot(x_B.x(), x_B.y()));
    }
  }
  return radius;
}

namespace {

/// Inertia of a point mass at x about the origin, and of any body from its second moments.
Mat3 inertia_from_moments(const Mat3& second_moments) {
  return second_moments.trace() * Mat3::Identity() - second_moments;
}

}  // namespace

MassProperties mass_properties(const mesh::TriangleMesh& m, double density) {
  const Vec3 o = m.positions.front();
  double volume = 0.0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  for (const mesh::Triangle& t : m.triangles) {
    const Vec3 a = m.positions[t[0]] - o, b = m.positions[t[1]] - o, c = m.positions[t[2]] - o;
    const double v = a.dot(b.cross(c)) / 6.0;
    const Vec3 s = a + b + c;
    volume += v;
    first += v / 4.0 * s;
    second +=
        v / 20.0 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
  }
  const Vec3 centre = first / volume;
  const Mat3 central = second - volume * centre * centre.transpose();
  return {density * volume, o + centre, density * inertia_from_moments(central)};
}

MassProperties transformed(const MassProperties& body_P, const Pose& X_AP) {
  return {body_P.mass, X_AP * body_P.centre, X_AP.R * body_P.inertia * X_AP.R.transpose()};
}

MassProperties combined(const MassProperties& a, const MassProperties& b) {
  const double mass = a.mass + b.mass;
  if (mass == 0.0) return {};
  const Vec3 d = b.centre - a.centre;
  const double reduced = a.mass * b.mass / mass;
  return {mass, a.centre + b.mass / mass * d,
          a.inertia + b.inertia + reduced * inertia_from_moments(d * d.transpose())};
}

MassProperties mass_properties(const Bit& bit) {
  MassProperties sum;
  for (const Part& part : bit.parts)
    if (part.density > 0.0)
      sum = combined(sum, transformed(mass_properties(part.mesh_P, part.density), part.X_BP));
  return sum;
}

namespace {

Vec3 ring_point(const Ring& ring, int k) {
  if (ring.count == 1) return {ring.x, 0.0, 0.0};
  const double angle = full_turn * k / ring.count;
  return {ring.x, ring.radius * std::sin(angle), -ring.radius * std::cos(angle)};
}

/// Triangles between a ring of na points that starts at index a and the next ring, nb points from
/// b.
void stitch(int a, int na, int b, int nb, std::vector<mesh::Triangle>& triangles) {
  const int steps_a = na == 1 ? 0 : na, steps_b = nb == 1 ? 0 : nb;
  for (int i = 0, j = 0; i < steps_a || j < steps_b;) {
    const bool advance_b = i == steps_a || (j < steps_b && (j + 1) * na <= (i + 1) * nb);
    const int at_a = a + i % na, at_b = b + j % nb;
    if (advance_b)
      triangles.push_back({at_a, at_b, b + ++j % nb});
    else
      triangles.push_back({at_a, at_b, a + ++i % na});
  }
}

}  // namespace

mesh::TriangleMesh surface_of_revolution(const std::vector<Ring>& rings) {
  mesh::TriangleMesh m;
  int previous_start = 0, previous_count = 0;
  for (const Ring& ring : rings) {
    const int start = static_cast<int>(m.positions.size());
    for (int k = 0; k < ring.count; ++k) m.positions.push_back(ring_point(ring, k));
    if (previous_count > 0) stitch(previous_start, previous_count, start, ring.count, m.triangles);
    previous_start = start;
    previous_count = ring.count;
  }
  return m;
}

namespace {

/// U~ of eq. 4.1: the cutter's -Z, rotated to azimuth 0 and projected on the X-Z plane.
Vec3 preliminary_direction(const Pose& X_BC) {
  const double r = std::hypot(X_BC.p.x(), X_BC.p.y());
  const double cos_azimuth = r > 0.0 ? X_BC.p.x() / r : 1.0;
  const double sin_azimuth = r > 0.0 ? X_BC.p.y() / r : 0.0;
  const Vec3 minus_z_B = -X_BC.R.col(2);
  return {cos_azimuth * minus_z_B.x() + sin_azimuth * minus_z_B.y(), 0.0, minus_z_B.z()};
}

Vec3 inside_direction(InsideRule rule) {
  switch (rule) {
    case InsideRule::plus_x:
      return Vec3::UnitX();
    case InsideRule::minus_x:
      return -Vec3::UnitX();
    case InsideRule::down:
      break;
  }
  return Vec3::UnitZ();
}

}  // namespace

Vec3 update_direction(const Pose& X_BC, DirectionRule rule, InsideRule inside) {
  return update_direction(preliminary_direction(X_BC), rule, inside);
}

Vec3 update_direction(const Vec3& u, DirectionRule rule, InsideRule inside) {
  if (rule == DirectionRule::all_down) return Vec3::UnitZ();
  if (rule == DirectionRule::hybrid && u.x() <= 0.0) return inside_direction(inside);
  if (u.norm() == 0.0)
    throw InputError("cutter: found a -Z axis that points sideways, expected one along (r, z)");
  return u.normalized();
}

}  // namespace tdbd::bit
