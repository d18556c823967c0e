#pragma once

#include <vector>

#include "rock/maintain/limits.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// @file
/// Deferred maintenance. Not in the thesis. A cutter leaves steps in the rock that the next one
/// removes; repairing them is wasted work and causes more of it. Therefore a vertex waits until the
/// bit has not moved it for some cuts. It stays listed as touched. The longest wait is bounded.

/// Whether no cut has moved a touched vertex for `limits.rest` cuts, or it has been listed for
/// `limits.longest_wait` cuts. Moves by maintenance do not count. Rock (19).
inline bool has_waited(const Rock& rock, const MaintenanceLimits& limits, int v) {
  const MovedIn& moved = rock.moved_in[at(v)];
  return rock.cuts - moved.last >= limits.rest || rock.cuts - moved.first >= limits.longest_wait;
}

/// Whether maintenance examines a touched vertex now: it has waited, or its triangles may pass
/// through others, which must not wait (M4). Slow; set_aside uses the notes of rings.
bool is_due(const Rock& rock, const MaintenanceLimits& limits, int v);

/// Removes the vertices that are not due from the list of touched vertices and stores them in
/// `waiting`. Deleted vertices leave both. Requires begin_notes.
void set_aside(Rock& rock, const MaintenanceLimits& limits, std::vector<int>& waiting);

/// Ends a maintenance. Of the listed vertices only the waiting ones are listed again, unless
/// repairs deleted them.
void list_again(Rock& rock, const MaintenanceLimits& limits, const std::vector<int>& waiting);

/// Counts every past cut as `parts` cuts of a smaller step, so that waiting vertices wait equally
/// long in time.
void divide_cuts(Rock& rock, int parts);

}  // namespace tdbd::rock
