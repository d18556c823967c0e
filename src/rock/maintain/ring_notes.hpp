#pragma once

#include <cstdint>
#include <vector>

#include "rock/maintain/limits.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// @file
/// Notes of what one look at all triangles around a vertex finds, eight triangles at once in single
/// precision (ours). A note is kept from one maintenance to the next until the ring changes: the
/// vertex or a neighbour moves, or its neighbours are others. Notes are conservative, so that results
/// do not depend on them: what a note excludes is excluded, for the rest triangles are tested.

/// Bits of RingNotes::of. The upper eight tell of each triangle of the star whether it leans: it may
/// not face up.
inline constexpr unsigned
    ring_unchanged = 1,  ///< the vertex itself did not change since the last maintenance began
    ring_known = 2,      ///< the ring was looked at, and has not changed
    ring_may_fold = 4,   ///< a triangle that leans may be turned over against another one
    ring_fine = 8;       ///< no operation wants a triangle of the ring, none is steep or folded
inline constexpr int first_leaning_bit = 8;

/// The limits, drawn in by more than single precision rounds.
RingLimits ring_limits(const MaintenanceLimits& limits);

/// Looks at the triangles around v. Open rings and those of more than eight neighbours are not
/// sifted: all of them may lean and fold.
std::uint16_t look_at_ring(const mesh::Surface& s, int v, const RingLimits& limits);

/// The note of v, after a look if there is none.
inline std::uint16_t note_at(const mesh::Surface& s, int v, RingNotes& notes) {
  std::uint16_t& note = notes.of[at(v)];
  if ((note & ring_known) == 0) note = look_at_ring(s, v, notes.limits);
  return note;
}

/// Whether notes of earlier maintenances are used: quicker, the same results.
enum class OldNotes { used, discarded };

/// Begins a maintenance: discards the notes of rings that changed since the last one, and all of
/// them if the limits are others. Looks at the rings of all touched vertices that have no note, in
/// parallel; `unknown` is a buffer. Operations of maintenance touch every vertex whose ring they
/// change, so that notes stay right until the next cut.
void begin_notes(Rock& rock, const MaintenanceLimits& limits, OldNotes old_notes,
                 std::vector<int>& unknown);

}  // namespace tdbd::rock
