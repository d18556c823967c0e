#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rock/rock.hpp"

namespace tdbd::rock {

struct MaintenanceLimits;

/// A triangle as the limits of maintenance see it. Lengths and quality squared: comparing needs no
/// root.
struct Shape {
  std::array<double, 3> edge2{};  ///< m2, of the edge that faces corner i
  double quality2 = 0.0;
  Vec3 doubled_area = Vec3::Zero();  ///< m2, twice the area vector
};

Shape shape_of(const mesh::Surface& s, int t);

inline bool is_below(const Shape& shape, double quality) {
  return shape.quality2 < quality * quality;
}

/// The triangles at touched vertices, looked at once at the beginning of a maintenance, and those
/// of them that some operation may want. The operations change few of the others; these alone need
/// a second look.
struct TouchedRegion {
  std::vector<int> steep, with_long_edges, to_collapse, to_flip, to_smooth;  ///< triangles
  std::vector<int> changed;    ///< vertices that were touched since, as find_changed found
  std::vector<int> triangles;  ///< all
  std::vector<Vec3> areas;     ///< Shape::doubled_area of each
  std::vector<std::uint8_t> wants_collapse;  ///< of each
  std::vector<int> place;                    ///< per triangle: where it stands in `triangles`
};

/// Where the triangle stands in the region; -1 if it does not.
inline int place_of(const TouchedRegion& region, int t) {
  const auto i = static_cast<std::size_t>(t);
  if (i >= region.place.size()) return -1;
  const auto k = static_cast<std::size_t>(region.place[i]);
  return k < region.triangles.size() && region.triangles[k] == t ? region.place[i] : -1;
}

/// Looks at every living triangle at a touched vertex. To be collapsed: with edges below the
/// shortest, of a quality below the worst, or folded back to back on a neighbour.
void look_through(Rock& rock, const MaintenanceLimits& limits, TouchedRegion& region);

/// Finds the vertices that were touched since. A triangle that an operation changed has one.
void find_changed(const Rock& rock, TouchedRegion& region);

/// Whether two area vectors are turned back to back.
inline bool are_folded(const Vec3& n, const Vec3& m) {
  constexpr double back_to_back = -0.5;  // cosine of the normals
  const double product = n.dot(m);
  return product < 0.0 && product < back_to_back * n.norm() * m.norm();
}

}  // namespace tdbd::rock
