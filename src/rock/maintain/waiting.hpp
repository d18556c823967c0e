#pragma once

#include <vector>

#include "rock/maintain/limits.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// @file
/// Deferred maintenance, ours. A cutter leaves steps in the rock that the next one takes away; to
/// repair them is wasted work, and makes more of it. So a vertex waits until the bit has left it
/// alone for some cuts. It stays listed as touched; a greatest wait bounds how long.

/// Whether no cut has moved a touched vertex for `limits.rest` cuts, or it has been listed for
/// `limits.longest_wait`. What maintenance itself moves is no reason to wait. Rock (19).
inline bool has_waited(const Rock& rock, const MaintenanceLimits& limits, int v) {
  const MovedIn& moved = rock.moved_in[at(v)];
  return rock.cuts - moved.last >= limits.rest || rock.cuts - moved.first >= limits.longest_wait;
}

/// Whether maintenance examines a touched vertex now: it has waited, or its triangles may pass
/// through others, which does not wait (M4). Slow: set_aside uses the notes of rings.
bool is_due(const Rock& rock, const MaintenanceLimits& limits, int v);

/// Takes the vertices that are not due off the list of touched ones; `waiting` receives them.
/// Removed ones leave both. Follows begin_notes.
void set_aside(Rock& rock, const MaintenanceLimits& limits, std::vector<int>& waiting);

/// Ends a maintenance: of all that is listed only those that wait are listed again, but for what
/// repairs removed.
void list_again(Rock& rock, const MaintenanceLimits& limits, const std::vector<int>& waiting);

/// Counts every cut so far as so many of a finer step: what waits then waits as long in time.
void divide_cuts(Rock& rock, int parts);

}  // namespace tdbd::rock
