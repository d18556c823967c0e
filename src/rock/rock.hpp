#pragma once

#include <array>
#include <vector>

#include "core/simd.hpp"
#include "mesh/surface.hpp"
#include "rock/index/near_list.hpp"
#include "rock/index/vertex_grid.hpp"

namespace tdbd::rock {

/// The first and the last cut that moved a vertex since the vertex was last removed from
/// Rock::touched_list.
struct MovedIn {
  static constexpr int never = -1'000'000'000;
  int first = never, last = never;

  template <class Archive>
  void serialize(Archive& a) {
    a(first, last);
  }
};

/// Whether a part of the bit touched a vertex after the last cut. `held`: it did. `left`: it did
/// before, and the part now contains the place where the undisturbed rock was. `made`: maintenance
/// made or moved the vertex beside the contact.
enum class ContactStatus { held, left, made };

/// A vertex that a part of the bit pressed, and the sum of the displacements by that part during
/// uninterrupted contact (contact in every step): the undisturbed rock was at x - d_W.
struct PressedVertex {
  int v = 0;
  Vec3 d_W = Vec3::Zero();  ///< m
  ContactStatus hold = ContactStatus::held;

  template <class Archive>
  void serialize(Archive& a) {
    a(v, d_W, hold);
  }
};

/// Records that an operation of maintenance made vertex v or moved it along the surface. The
/// displacements of v (PressedVertex) become the weighted mean of those of `from`.
struct InterpolatedDisplacement {
  int v = 0;
  std::array<int, 3> from{};
  std::array<double, 3> weight{};

  template <class Archive>
  void serialize(Archive& a) {
    a(v, from, weight);
  }
};

/// A vertex inside a part that removes only a share of the rock in its way (bit::Part::share), and
/// how much farther the vertex would have moved if the part removed all the rock: a part that did
/// would have it at x + left_W.
struct ResidualVertex {
  int v = 0;
  int part = 0;                ///< the first part of the group that passes over it
  Vec3 left_W = Vec3::Zero();  ///< m

  template <class Archive>
  void serialize(Archive& a) {
    a(v, part, left_W);
  }
};

/// Thresholds on which a ring note depends (maintain/ring_notes.hpp).
struct RingLimits {
  Single sine2 = 0;   ///< sine of the steepest overhang, squared
  Single short2 = 0;  ///< m2, of squared edges and doubled horizontal areas
  Single long2 = 0;   ///< m2, of squared edge lengths
  Single quality2 = 0;
  bool operator==(const RingLimits&) const = default;
};

/// The result of the last check by maintenance of the triangles around each vertex
/// (maintain/ring_notes.hpp). Not stored in checkpoints, because results do not depend on it.
struct RingNotes {
  std::vector<std::uint16_t> of;  ///< per vertex; 0: changed since the last check, or never checked
  RingLimits limits;              ///< with which all notes were made
};

/// The rock: a surface whose normal points out of the rock, a spatial index of its vertices, lists
/// of the vertices near the bit, the part and the cut that last moved each vertex, and the vertices
/// that changed since the last maintenance. Frame W. Thesis: 4.1.
struct Rock {
  mesh::Surface surface;
  VertexGrid grid;
  std::vector<int> last_part;         ///< per vertex: index into Bit::parts, -1 untouched
  std::vector<std::uint8_t> touched;  ///< per vertex: nonzero if in touched_list
  std::vector<int> touched_list;
  int cuts = 0;                   ///< calls of cut_rock so far
  std::vector<MovedIn> moved_in;  ///< per vertex, in counts of `cuts`
  /// Per part of the bit, sorted by vertex: the vertices that the part touched after the last cut
  /// and those that maintenance made beside the contact (contact_areas). Empty if contact is not
  /// measured.
  std::vector<std::vector<PressedVertex>> pressed;
  std::vector<InterpolatedDisplacement>
      carried;                       ///< since the last cut, in the order of the operations
  std::vector<ResidualVertex> left;  ///< sorted by vertex, then by part (cut/left_rock.hpp)
  std::vector<NearList> near_lists;  ///< per group of the bit that cut last
  RingNotes notes;

  /// For checkpoints: the index and what follows from the surface is made again.
  template <class Archive>
  void serialize(Archive& a) {
    a(surface, last_part, touched, touched_list, cuts, moved_in, pressed, carried, left);
  }
};

/// Builds the index of a surface. `cell`: cell size in m; about twice the edge length is fastest.
/// `reach_W`: the region that the bit will visit; the grid covers it.
Rock make_rock(mesh::Surface surface, double cell, const mesh::Box& reach_W);

/// Rebuilds the index around `box_W` with the same cell size. Does not change the results of cuts
/// and repairs.
void rebuild_index(Rock& rock, const mesh::Box& box_W);

/// Rebuilds the index if the hole is deeper than the index's box by several cells, because all rock
/// below the box would be in one layer of cells. The new box reaches below the rock by its height.
void deepen_index(Rock& rock);

/// Values of Rock::touched. `classified_mark` occurs only during maintenance: the vertex was
/// classified and has not been touched since (touched_region.hpp).
inline constexpr std::uint8_t touched_mark = 1, classified_mark = 2;

/// Discards the note on the triangles around vertex v.
inline void discard_ring_note(Rock& rock, int v) {
  if (at(v) < rock.notes.of.size()) rock.notes.of[at(v)] = 0;  // a copy may have no notes
}

/// Marks a vertex as changed: it moved, or its triangles changed.
void touch(Rock& rock, int v);

/// Marks the neighbours of v as changed.
void mark_neighbours_changed(Rock& rock, int v);

/// Moves vertex v to x_W on the surface and in the index, and marks it as changed. `notify`: who
/// updates the near lists (vertex_grid.hpp).
void place_vertex(Rock& rock, int v, const Vec3& x_W, Notify notify = Notify::journal);

/// Records that the current cut moves vertex v. Must be called before the vertex is marked as
/// changed. Moves by maintenance are not recorded, so maintenance does not wait for its own moves.
void record_cut(Rock& rock, int v);

/// Whether the last cut moved vertex v. Valid until the next maintenance.
inline bool is_moved_now(const Rock& rock, int v) { return rock.moved_in[at(v)].last == rock.cuts; }

/// Extends the per-vertex arrays and the index after a bisection created vertex v.
void register_vertex(Rock& rock, int v, int last_part);

/// Sort order of Rock::left.
inline bool comes_before(const ResidualVertex& a, const ResidualVertex& b) {
  return a.v != b.v ? a.v < b.v : a.part < b.part;
}

/// Whether maintenance must record how its operations carry displacements: contact is measured, or
/// a part that removes a share is inside rock.
inline bool has_displacements(const Rock& rock) {
  return !rock.pressed.empty() || !rock.left.empty();
}

/// Records how an operation of maintenance carries displacements, if there are any.
inline void record_carried(Rock& rock, const InterpolatedDisplacement& carried) {
  if (has_displacements(rock)) rock.carried.push_back(carried);
}

}  // namespace tdbd::rock
