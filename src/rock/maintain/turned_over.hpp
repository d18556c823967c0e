#pragma once

#include <vector>

#include "rock/maintain/limits.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// @file
/// Tests for triangles that are turned over (star.hpp). The notes of the rings of their corners are
/// tested first. Requires begin_notes with the same limits. The results are those of star.hpp.

/// Whether triangle t is turned over.
bool is_turned_over(const mesh::Surface& s, const MaintenanceLimits& limits, int t,
                    RingNotes& notes);

/// Whether a triangle at v is turned over.
bool is_turned_over_at(const mesh::Surface& s, const MaintenanceLimits& limits, int v,
                       RingNotes& notes);

/// Appends the triangles at v that are turned over.
void add_turned_over(const mesh::Surface& s, const MaintenanceLimits& limits, int v,
                     RingNotes& notes, std::vector<int>& triangles);

}  // namespace tdbd::rock
