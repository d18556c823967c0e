#pragma once

#include <vector>

#include "rock/maintain/invariants.hpp"

namespace tdbd::rock {

/// Debug builds ask the promises of M1 and M5 around every operation of maintenance, at a cost that
/// follows the operation, not the rock.
#ifdef TDBD_CHECK_EVERY_OPERATION
inline constexpr bool check_every_operation = true;
#else
inline constexpr bool check_every_operation = false;
#endif

/// What the triangles at some vertices say before an operation among them.
struct LocalState {
  std::vector<int> vertices;
  Vec3 origin_W = Vec3::Zero();
  double volume = 0.0;  ///< m3 of hole about the origin under their triangles
  double size = 0.0;    ///< m, their farthest distance from the origin
};

/// Of these vertices, all whose triangles the operation may change among them.
LocalState local_state(const mesh::Surface& s, std::vector<int> vertices);

/// M1 around the state's vertices that live: corners and their opposites agree, no neighbour comes
/// twice, the index has the vertex in its place. M5: their volume has changed by `volume_change`.
std::vector<Violation> check_around(const Rock& rock, const LocalState& before,
                                    double volume_change);

/// Throws RunError with the first violations, if there are any. `what`: the operation's name.
void demand_around(const Rock& rock, const LocalState& before, double volume_change,
                   const char* what);

}  // namespace tdbd::rock
