#pragma once

#include <array>
#include <vector>

#include "core/single.hpp"
#include "mesh/surface.hpp"
#include "rock/index/near_list.hpp"
#include "rock/index/vertex_grid.hpp"

namespace tdbd::rock {

/// The first and the last cut that moved a vertex since it was last off Rock::touched_list.
struct MovedIn {
  static constexpr int never = -1'000'000'000;
  int first = never, last = never;
};

/// Whether a part of the bit touched a vertex after the last cut: it did, it did before and its inside
/// is where undisturbed rock was, or maintenance made or moved the vertex beside the contact.
enum class Hold { held, left, made };

/// A vertex that a part of the bit pressed, and the sum of that part's moves of it while they were in
/// contact without a break of one step: x - d_W is where undisturbed rock was.
struct PressedVertex {
  int v = 0;
  Vec3 d_W = Vec3::Zero();  ///< m
  Hold hold = Hold::held;
};

/// An operation of maintenance made vertex v or moved it along the surface: its displacements
/// (PressedVertex) become the weighted mean of those of `from`.
struct CarriedDisplacement {
  int v = 0;
  std::array<int, 3> from{};
  std::array<double, 3> weight{};
};

/// A vertex inside a part that leaves a share of the rock in its way (bit::Part::share), and how much
/// farther it would be if the part removed all: x + left_W is where a part that did would have it.
struct LeftVertex {
  int v = 0;
  int part = 0;                ///< the first part of the group that passes over it
  Vec3 left_W = Vec3::Zero();  ///< m
};

/// Limits that decide what a RingNote says (maintain/ring_notes.hpp).
struct RingLimits {
  Single sine2 = 0;   ///< of the steepest overhang, squared
  Single short2 = 0;  ///< m2, of squared edges and of doubled areas seen from above
  Single long2 = 0;   ///< m2, of squared edges
  Single quality2 = 0;
  bool operator==(const RingLimits&) const = default;
};

/// What maintenance found when it last looked at the triangles around each vertex
/// (maintain/ring_notes.hpp). Not stored in checkpoints: results do not depend on it.
struct RingNotes {
  std::vector<std::uint16_t> of;  ///< per vertex; 0: the vertex changed, or was never looked at
  RingLimits limits;              ///< of all notes
};

/// The rock: a surface whose normal points out of the rock, an index of its vertices, lists of
/// those near the bit, the part that cut each vertex last and when it did, and the vertices that
/// changed and have not been maintained since. Frame W. Thesis: 4.1.
struct Rock {
  mesh::Surface surface;
  VertexGrid grid;
  std::vector<int> last_part;         ///< per vertex: index into Bit::parts, -1 untouched
  std::vector<std::uint8_t> touched;  ///< per vertex: a mark if listed in touched_list
  std::vector<int> touched_list;
  int cuts = 0;                   ///< calls of cut_rock so far
  std::vector<MovedIn> moved_in;  ///< per vertex, in counts of `cuts`
  /// Per part of the bit, by vertex: what it held after the last cut, and what maintenance made
  /// beside it (contact_areas). Empty: contact is not measured.
  std::vector<std::vector<PressedVertex>> pressed;
  std::vector<CarriedDisplacement> carried;  ///< since then, in the order of the operations
  std::vector<LeftVertex> left;              ///< by vertex, then by part (cut/left_rock.hpp)
  std::vector<NearList> near_lists;          ///< per group of the bit that cut last
  RingNotes notes;
};

/// Builds the index of a surface. `cell`: m; about twice the edge length is quickest. `reach_W`:
/// where the bit will go, so that the grid covers it.
Rock make_rock(mesh::Surface surface, double cell, const mesh::Box& reach_W);

/// Makes the index anew, about `box_W` and with cells as large. Cuts and repairs stay the same.
void make_index_anew(Rock& rock, const mesh::Box& box_W);

/// Makes the index anew, as deep again as the rock is high, if the hole has become deeper than the
/// index's box by some cells: one layer would hold all that is below it.
void deepen_index(Rock& rock);

/// Marks of Rock::touched. The second appears only during a maintenance: classified, and not
/// touched since (touched_region.hpp).
inline constexpr std::uint8_t touched_mark = 1, classified_mark = 2;

/// Discards what is known of the triangles around vertex v.
inline void forget_ring(Rock& rock, int v) {
  if (at(v) < rock.notes.of.size()) rock.notes.of[at(v)] = 0;  // a copy may come without notes
}

/// Notes that a vertex changed: it moved, or its triangles changed.
void touch(Rock& rock, int v);

/// Notes that the neighbours of v changed.
void touch_neighbours(Rock& rock, int v);

/// Moves vertex v to x_W on the surface and in the index, and notes that it changed. `teller`: of the
/// near lists.
void place_vertex(Rock& rock, int v, const Vec3& x_W, Teller teller = Teller::journal);

/// Notes that the cut at work moves vertex v; to be called before it is touched. What maintenance
/// moves is not noted: it does not wait for its own moves.
void note_cut(Rock& rock, int v);

/// Whether the last cut moved vertex v. Until the next maintenance.
inline bool is_moved_now(const Rock& rock, int v) { return rock.moved_in[at(v)].last == rock.cuts; }

/// Extends the per-vertex arrays and the index after a bisection made vertex v.
void register_vertex(Rock& rock, int v, int last_part);

/// The order of Rock::left.
inline bool comes_before(const LeftVertex& a, const LeftVertex& b) {
  return a.v != b.v ? a.v < b.v : a.part < b.part;
}

/// Whether maintenance has to note how its operations carry displacements: contact is measured, or a
/// part is inside rock that it leaves.
inline bool has_displacements(const Rock& rock) {
  return !rock.pressed.empty() || !rock.left.empty();
}

/// Notes how an operation of maintenance carries displacements, if there are any.
inline void note_carried(Rock& rock, const CarriedDisplacement& carried) {
  if (has_displacements(rock)) rock.carried.push_back(carried);
}

}  // namespace tdbd::rock
