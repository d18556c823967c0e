#pragma once

#include <cstdint>
#include <vector>

#include "core/simd.hpp"
#include "mesh/surface.hpp"
#include "rock/maintain/limits.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// @file
/// The triangles around a vertex as columns in single precision, tested eight at a time. For closed
/// rings of at most eight neighbours.

/// One value per triangle; the values are repeated behind the last one. Not initialized, because
/// only stored entries are loaded.
struct alignas(32) RingColumn {
  Single at[2 * single_lanes];
};

/// One flag per triangle, all bits set or none; repeated behind the last one.
struct alignas(32) RingFlags {
  int at[2 * single_lanes];
};

/// Vectors from the vertex to its neighbours, m. Triangle i has the spokes i and i + 1.
struct Spokes {
  RingColumn x, y, z;
};

/// The two spokes of eight triangles, one triangle per lane.
struct WideSpokes {
  WideSingle ex, ey, ez, fx, fy, fz;
};

/// Loads the spokes. For functions that are TDBD_WIDE.
[[gnu::always_inline]] inline void load(const Spokes& d, WideSpokes& w) {
  TDBD_LOAD(w.ex, d.x.at);
  TDBD_LOAD(w.ey, d.y.at);
  TDBD_LOAD(w.ez, d.z.at);
  TDBD_LOAD(w.fx, d.x.at + 1);
  TDBD_LOAD(w.fy, d.y.at + 1);
  TDBD_LOAD(w.fz, d.z.at + 1);
}

/// Stores the first of n values again behind the last one.
[[gnu::always_inline]] inline void wrap(RingColumn& c, std::size_t n) { c.at[n] = c.at[0]; }

inline bool has_spokes(const mesh::VertexStar& star) {
  return star.open == 0 && star.long_ring < 0;
}

[[gnu::always_inline]] inline void find_spokes(const mesh::Surface& s, const mesh::VertexStar& star,
                                               Spokes& d) {
  const std::size_t n = star.size;
  const WideSingle none = {};
  for (RingColumn* c : {&d.x, &d.y, &d.z}) {
    TDBD_STORE(none, c->at);
    TDBD_STORE(none, c->at + single_lanes);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 spoke = s.position(star.ring[i]) - star.x;
    d.x.at[i] = static_cast<Single>(spoke.x());
    d.y.at[i] = static_cast<Single>(spoke.y());
    d.z.at[i] = static_cast<Single>(spoke.z());
  }
  for (RingColumn* c : {&d.x, &d.y, &d.z}) wrap(*c, n);
}

/// @file
/// Notes on the triangles around a vertex, computed for eight triangles at once in single
/// precision. Not in the thesis. A note is valid until the ring changes: the vertex or a neighbour
/// moves, or the neighbours change. Notes are conservative, so results do not depend on them: a
/// note excludes only what cannot occur; otherwise the triangles are tested.

/// Bits of RingNotes::of. Each of the upper eight bits is set if a triangle of the star leans, that
/// is, if it may not face up.
inline constexpr unsigned
    ring_unchanged = 1,   ///< the vertex itself did not change since the last maintenance began
    ring_note_valid = 2,  ///< the ring was checked and has not changed since
    ring_may_fold = 4,    ///< a leaning triangle may be turned over against another one
    ring_fine = 8;        ///< no triangle of the ring needs an operation, is steep or folded
inline constexpr int first_leaning_bit = 8;

/// The limits, tightened by more than the rounding error of single precision.
RingLimits ring_limits(const MaintenanceLimits& limits);

/// Computes the note for the triangles around v. Open rings and rings of more than eight neighbours
/// are not tested: all their triangles may lean and fold.
std::uint16_t compute_ring_note(const mesh::Surface& s, int v, const RingLimits& limits);

/// Returns the note of v; computes it if there is none.
inline std::uint16_t note_at(const mesh::Surface& s, int v, RingNotes& notes) {
  std::uint16_t& note = notes.of[at(v)];
  if ((note & ring_note_valid) == 0) note = compute_ring_note(s, v, notes.limits);
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

/// Bit masks of the neighbours of a vertex that are touched, and of those that are touched and have
/// a smaller number.
struct RingMarks {
  unsigned touched = 0, before = 0;
};

/// For a closed ring of at most eight neighbours (has_spokes).
RingMarks marks_around(const Rock& rock, int v);

/// The number of triangles at v of whose touched corners v has the smallest number. The sum over
/// all touched vertices counts every touched triangle once. The second overload is faster.
long triangles_first_at(const Rock& rock, int v);
long triangles_first_at(const mesh::VertexStar& star, const RingMarks& marks);

/// Whether no triangle at v needs an operation, is steep, or is folded on a neighbour, according to
/// the vertex's note (ring_notes.hpp). Requires begin_notes. Conservative: may return false for a
/// ring that needs no repair. Folds across an edge that faces v are tested only if neither of its
/// ends is touched; otherwise the rings of its ends contain them.
bool ring_is_fine(Rock& rock, int v, const RingMarks& marks);

}  // namespace tdbd::rock
