#include "reference/bit/scalloped_wall.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/types.hpp"

namespace tdbd::reference {
namespace {

/// The row of one advance that a point of the bit passes in the half-plane.
std::size_t row_of(const Vec3& x_B, double advance, std::size_t rows) {
  const double turns = x_B.z() / advance - std::atan2(x_B.y(), x_B.x()) / full_turn;
  const double share = turns - std::floor(turns);
  return std::min(static_cast<std::size_t>(share * static_cast<double>(rows)), rows - 1);
}

/// Number of samples along an edge: two for each row that it may pass, because the height changes
/// with the azimuth.
int samples(const Vec3& a, const Vec3& b, double advance, std::size_t rows) {
  const double around = (b - a).norm() / std::max(a.head<2>().norm(), 1e-9);
  const double advances = std::abs(b.z() - a.z()) / advance + around / full_turn;
  return 2 + static_cast<int>(2.0 * advances * static_cast<double>(rows));
}

}  // namespace

ScallopedWall scalloped_wall(const bit::Bit& bit, double advance, int rows) {
  ScallopedWall wall;
  wall.radius.assign(static_cast<std::size_t>(rows), 0.0);
  for (const bit::Part& part : bit.parts) {
    if (part.cutting != bit::Cutting::cuts) continue;
    for (const mesh::Triangle& t : part.mesh_P.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 a = part.X_BP * part.mesh_P.positions[static_cast<std::size_t>(t[i])],
                   b = part.X_BP * part.mesh_P.positions[static_cast<std::size_t>(t[(i + 1) % 3])];
        const int n = samples(a, b, advance, wall.radius.size());
        for (int k = 0; k <= n; ++k) {
          const Vec3 x_B = a + (b - a) * (static_cast<double>(k) / n);
          double& r = wall.radius[row_of(x_B, advance, wall.radius.size())];
          r = std::max(r, x_B.head<2>().norm());
        }
      }
  }
  for (const double r : wall.radius) {
    wall.volume += std::numbers::pi * r * r * advance / rows;
    wall.reach = std::max(wall.reach, r);
  }
  return wall;
}

}  // namespace tdbd::reference
