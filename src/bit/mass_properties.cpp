#include "bit/mass_properties.hpp"

namespace tdbd::bit {
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

}  // namespace tdbd::bit
