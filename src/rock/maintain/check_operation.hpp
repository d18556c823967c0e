#pragma once

#include <vector>

#include "rock/maintain/invariants.hpp"

namespace tdbd::rock {

/// Debug builds check promises M1 and M5 around every operation of maintenance. The run time
/// depends on the operation, not on the size of the rock.
#ifdef TDBD_CHECK_EVERY_OPERATION
inline constexpr bool check_every_operation = true;
#else
inline constexpr bool check_every_operation = false;
#endif

/// The triangles at some vertices before an operation that involves them.
struct LocalState {
  std::vector<int> vertices;
  Vec3 origin_W = Vec3::Zero();
  double volume = 0.0;  ///< m3 of hole between the origin and their triangles
  double size = 0.0;    ///< m, largest distance of these triangles from the origin
};

/// `vertices` must include all vertices whose triangles the operation may change.
LocalState local_state(const mesh::Surface& s, std::vector<int> vertices);

/// Checks M1 around those of the state's vertices that are alive: corners and their opposites
/// agree, no neighbour appears twice, and the index has the vertex in its place. Checks M5: their
/// volume has changed by `volume_change` (m3).
std::vector<Violation> check_around(const Rock& rock, const LocalState& before,
                                    double volume_change);

/// Throws RunError with the first violations if there are any. `what`: the operation's name.
void require_promises_around(const Rock& rock, const LocalState& before, double volume_change,
                             const char* what);

}  // namespace tdbd::rock
