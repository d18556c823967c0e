#include "bit/cutter/cutter_overlap.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/measures.hpp"
#include "mesh/shape/convex.hpp"

namespace tdbd::bit {
namespace {

constexpr int most_turns = 1000;

Vec3 centre_B(const Cutter& c) { return c.X_BC * Vec3(-0.5 * c.length, 0.0, 0.0); }

double bounding_radius(const Cutter& c) { return 0.5 * std::hypot(c.length, c.diameter); }

/// The point of the cutter's cylinder that is nearest to x_B.
Vec3 nearest_B(const Cutter& c, const Vec3& x_B) {
  Vec3 x_C = c.X_BC.R.transpose() * (x_B - c.X_BC.p);
  x_C.x() = std::clamp(x_C.x(), -c.length, 0.0);
  const double radius = std::hypot(x_C.y(), x_C.z());
  if (radius > 0.5 * c.diameter) x_C.tail<2>() *= 0.5 * c.diameter / radius;
  return c.X_BC * x_C;
}

/// How far the cylinder extends along the unit vector d_B.
double reach_along(const Cutter& c, const Vec3& d_B) {
  const double along = c.X_BC.R.col(0).dot(d_B);
  const double across = std::sqrt(std::max(0.0, 1.0 - along * along));
  return d_B.dot(centre_B(c)) + 0.5 * c.length * std::abs(along) + 0.5 * c.diameter * across;
}

}  // namespace

bool closer_than(const Cutter& a, const Cutter& b, double clearance) {
  const double centres = (centre_B(a) - centre_B(b)).norm();
  if (centres >= bounding_radius(a) + bounding_radius(b) + clearance) return false;
  Vec3 in_a = centre_B(a);
  for (int turn = 0; turn < most_turns; ++turn) {
    const Vec3 in_b = nearest_B(b, in_a);
    in_a = nearest_B(a, in_b);
    const double distance = (in_a - in_b).norm();
    if (distance < clearance) return true;
    const Vec3 d = (in_b - in_a) / distance;
    if (-reach_along(b, -d) - reach_along(a, d) >= clearance) return false;
  }
  return true;
}

namespace {

constexpr double touching = 1e-6;     ///< m: cutters farther apart share no volume
constexpr double least_share = 1e-9;  ///< times a part's volume: less is rounding

/// A part of a cutter in the bit frame.
struct Piece {
  mesh::TriangleMesh surface;
  mesh::ConvexSolid solid;
};

std::vector<std::vector<Piece>> pieces_of(const Bit& bit) {
  std::vector<std::vector<Piece>> pieces(bit.cutters.size());
  for (const Part& part : bit.parts) {
    if (part.cutter < 0 || part.density <= 0.0) continue;
    mesh::TriangleMesh m = mesh_B(part);
    if (const auto solid = mesh::convex_solid(m))
      pieces[static_cast<std::size_t>(part.cutter)].push_back({std::move(m), *solid});
  }
  return pieces;
}

double common_volume(const Piece& a, const Piece& b) {
  if (!mesh::bounding_box(a.surface).overlaps(mesh::bounding_box(b.surface))) return 0.0;
  mesh::TriangleMesh m = a.surface;
  for (std::size_t i = 0; i < b.solid.planes && !m.triangles.empty(); ++i)
    m = mesh::clipped_convex(m, mesh::normal(b.solid, i), b.solid.b[i]);
  if (m.triangles.empty()) return 0.0;
  const double volume = mesh::enclosed_volume(m);
  return volume > least_share * mesh::enclosed_volume(a.surface) ? volume : 0.0;
}

}  // namespace

std::vector<CutterOverlap> cutter_overlaps(const Bit& bit) {
  const std::vector<std::vector<Piece>> pieces = pieces_of(bit);
  std::vector<CutterOverlap> overlaps;
  for (std::size_t a = 0; a < pieces.size(); ++a)
    for (std::size_t b = a + 1; b < pieces.size(); ++b) {
      if (!closer_than(bit.cutters[a], bit.cutters[b], touching)) continue;
      CutterOverlap o{static_cast<int>(a), static_cast<int>(b), 0.0};
      for (const Piece& of_a : pieces[a])
        for (const Piece& of_b : pieces[b]) o.volume += common_volume(of_a, of_b);
      if (o.volume > 0.0) overlaps.push_back(o);
    }
  return overlaps;
}

}  // namespace tdbd::bit
