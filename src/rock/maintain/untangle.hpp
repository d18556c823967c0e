#pragma once

#include <vector>

#include "rock/maintain/limits.hpp"
#include "rock/maintain/maintain.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// @file
/// Tests for triangles that are turned over (limits.hpp). The notes of the rings of their corners are
/// tested first. Requires begin_notes with the same limits. The results are those of limits.hpp.

/// Whether triangle t is turned over.
bool is_turned_over(const mesh::Surface& s, const MaintenanceLimits& limits, int t,
                    RingNotes& notes);

/// Whether a triangle at v is turned over.
bool is_turned_over_at(const mesh::Surface& s, const MaintenanceLimits& limits, int v,
                       RingNotes& notes);

/// Appends the triangles at v that are turned over.
void add_turned_over(const mesh::Surface& s, const MaintenanceLimits& limits, int v,
                     RingNotes& notes, std::vector<int>& triangles);

/// Returns, sorted, corners of triangles that were steep when maintenance began, that overhang and
/// that are turned by more than 90 degrees against a triangle at one of their corners. A part that
/// moves rock along a wall by more than an edge length at once moves it past its neighbours. Where
/// that folds layers into each other, some triangle between them is turned over (M4).
std::vector<int> find_folded_places(Rock& rock, const MaintenanceLimits& limits,
                                    MaintenanceWorkspace& work);

/// Fills work.suspects with the triangles that may pass through others: those that are turned over
/// now, and all at the remaining `folded` places. Repairs may have turned the latter back while
/// they still wind twice around a vertex; otherwise triangles that all face one way cannot meet.
void find_suspects(Rock& rock, const std::vector<int>& folded, const MaintenanceLimits& limits,
                   MaintenanceWorkspace& work);

/// Removes intersections of the suspects. Edges of intersecting pairs of triangles collapse,
/// shortest first, if that leaves fewer pairs around them, in rounds until no pair is left or no
/// collapse helps. These collapses may change more volume and move the surface farther than others
/// (`untangle_volume`, `untangle_farthest`), cut ridges and turn normals; all other guards apply.
/// They are counted as untanglings. work.region receives the vertices around the changes. Returns
/// whether anything changed. Not in the thesis.
bool untangle(Rock& rock, const std::vector<int>& folded, const MaintenanceLimits& limits,
              MaintenanceWorkspace& work, MaintenanceReport& report);

}  // namespace tdbd::rock
