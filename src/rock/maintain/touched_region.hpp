#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rock/maintain/limits.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// The properties of a triangle that maintenance limits. Lengths and quality are squared, so that
/// comparisons need no square root.
struct Shape {
  std::array<double, 3> edge2{};  ///< m2, of the edge that faces corner i
  double quality2 = 0.0;
  Vec3 doubled_area = Vec3::Zero();  ///< m2, twice the area vector
};

Shape shape_of(const mesh::Surface& s, int t);

inline bool is_below(const Shape& shape, double quality) {
  return shape.quality2 < quality * quality;
}

/// Whether triangles that need no repair are skipped. Results are the same; `passed_over` is
/// faster.
enum class RingSkipping { passed_over, classified };

/// The triangles at touched vertices, classified once at the beginning of a maintenance by the
/// operations that may repair them. Later, only triangles that an operation changed are examined
/// again.
struct TouchedRegion {
  std::vector<int> steep, with_long_edges, to_collapse, to_flip, to_smooth;  ///< triangles
  std::vector<int> changed;                  ///< vertices touched since (find_changed)
  std::vector<int> triangles;                ///< all triangles except those of fine rings
  std::vector<Vec3> areas;                   ///< per element of `triangles`: Shape::doubled_area
  std::vector<std::uint8_t> wants_collapse;  ///< per element of `triangles`
  std::vector<int> place;                    ///< per triangle: its index in `triangles`
  long asked = 0;                            ///< number of triangles at touched vertices
  RingSkipping fine_rings = RingSkipping::passed_over;
};

/// The triangle's index in the region, or -1 if it is not there.
inline int place_of(const TouchedRegion& region, int t) {
  const auto i = static_cast<std::size_t>(t);
  if (i >= region.place.size()) return -1;
  const auto k = static_cast<std::size_t>(region.place[i]);
  return k < region.triangles.size() && region.triangles[k] == t ? region.place[i] : -1;
}

/// Classifies every triangle at a touched vertex, unless its ring is fine (ring_notes.hpp). Requires
/// begin_notes. Triangles to collapse have an edge below the shortest, a quality below the worst,
/// or lie back to back with a neighbour.
void classify_touched_triangles(Rock& rock, const MaintenanceLimits& limits, TouchedRegion& region);

/// Finds the vertices touched since classification. Every triangle that an operation changed has
/// such a vertex.
void find_changed(const Rock& rock, TouchedRegion& region);

/// Whether two triangles with these area vectors lie back to back.
inline bool are_folded(const Vec3& n, const Vec3& m) {
  constexpr double back_to_back = -0.5;  // cosine of the angle between the normals
  const double product = n.dot(m);
  return product < 0.0 && product < back_to_back * n.norm() * m.norm();
}

/// @file
/// Deferred maintenance. Not in the thesis. A cutter leaves steps in the rock that the next one
/// removes; repairing them is wasted work and causes more of it. Therefore a vertex waits until the
/// bit has not moved it for some cuts. It stays listed as touched. The longest wait is bounded.

/// Whether no cut has moved a touched vertex for `limits.rest` cuts, or it has been listed for
/// `limits.longest_wait` cuts. Moves by maintenance do not count. Rock (19).
inline bool wait_is_over(const Rock& rock, const MaintenanceLimits& limits, int v) {
  const MovedIn& moved = rock.moved_in[at(v)];
  return rock.cuts - moved.last >= limits.rest || rock.cuts - moved.first >= limits.longest_wait;
}

/// Whether maintenance examines a touched vertex now: it has waited, or its triangles may pass
/// through others, which must not wait (M4). Slow; defer_vertices uses the notes of rings.
bool is_due(const Rock& rock, const MaintenanceLimits& limits, int v);

/// Removes the vertices that are not due from the list of touched vertices and stores them in
/// `waiting`. Deleted vertices leave both. Requires begin_notes.
void defer_vertices(Rock& rock, const MaintenanceLimits& limits, std::vector<int>& waiting);

/// Ends a maintenance. Of the listed vertices only the waiting ones are listed again, unless
/// repairs deleted them.
void relist_deferred(Rock& rock, const MaintenanceLimits& limits, const std::vector<int>& waiting);

/// Counts every past cut as `parts` cuts of a smaller step, so that waiting vertices wait equally
/// long in time.
void scale_cut_counts(Rock& rock, int parts);

}  // namespace tdbd::rock
