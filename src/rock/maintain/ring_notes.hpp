#pragma once

#include <cstdint>
#include <vector>

#include "rock/maintain/limits.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// @file
/// Notes on the triangles around a vertex, computed for eight triangles at once in single
/// precision. Not in the thesis. A note is valid until the ring changes: the vertex or a neighbour
/// moves, or the neighbours change. Notes are conservative, so results do not depend on them: a
/// note excludes only what cannot occur; otherwise the triangles are tested.

/// Bits of RingNotes::of. Each of the upper eight bits is set if a triangle of the star leans, that
/// is, if it may not face up.
inline constexpr unsigned
    ring_unchanged = 1,  ///< the vertex itself did not change since the last maintenance began
    ring_known = 2,      ///< the ring was checked and has not changed since
    ring_may_fold = 4,   ///< a leaning triangle may be turned over against another one
    ring_fine = 8;       ///< no triangle of the ring needs an operation, is steep or folded
inline constexpr int first_leaning_bit = 8;

/// The limits, tightened by more than the rounding error of single precision.
RingLimits ring_limits(const MaintenanceLimits& limits);

/// Computes the note for the triangles around v. Open rings and rings of more than eight neighbours
/// are not tested: all their triangles may lean and fold.
std::uint16_t look_at_ring(const mesh::Surface& s, int v, const RingLimits& limits);

/// Returns the note of v; computes it if there is none.
inline std::uint16_t note_at(const mesh::Surface& s, int v, RingNotes& notes) {
  std::uint16_t& note = notes.of[at(v)];
  if ((note & ring_known) == 0) note = look_at_ring(s, v, notes.limits);
  return note;
}

/// Whether notes of earlier maintenances are used. Results are the same; `used` is faster.
enum class OldNotes { used, discarded };

/// Begins a maintenance. Discards the notes of rings that changed since the last one, or all notes
/// if the limits changed. Computes the notes of all touched vertices that have none, in parallel.
/// `unknown`: buffer. Operations of maintenance touch every vertex whose ring they change, so notes
/// stay valid until the next cut.
void begin_notes(Rock& rock, const MaintenanceLimits& limits, OldNotes old_notes,
                 std::vector<int>& unknown);

}  // namespace tdbd::rock
