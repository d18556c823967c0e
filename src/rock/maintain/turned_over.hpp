#pragma once

#include <vector>

#include "rock/maintain/limits.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// @file
/// Which triangles are turned over (star.hpp), by the notes of the rings of their corners first:
/// after begin_notes, with its limits. The answers are those of star.hpp.

/// Whether triangle t is turned over.
bool is_turned_over(const mesh::Surface& s, const MaintenanceLimits& limits, int t,
                    RingNotes& notes);

/// Whether one at v is.
bool is_turned_over_at(const mesh::Surface& s, const MaintenanceLimits& limits, int v,
                       RingNotes& notes);

/// Appends those at v that are.
void add_turned_over(const mesh::Surface& s, const MaintenanceLimits& limits, int v,
                     RingNotes& notes, std::vector<int>& triangles);

}  // namespace tdbd::rock
