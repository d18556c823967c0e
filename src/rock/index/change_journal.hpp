#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "core/single.hpp"
#include "core/types.hpp"

namespace tdbd::rock {

/// A coordinate of a place that does not exist: no comparison with it holds.
inline constexpr Single nowhere = std::numeric_limits<Single>::quiet_NaN();

/// What happened to vertices, in its order: where they came to, nowhere if they were removed.
/// Columns padded to whole packs.
struct VertexChanges {
  std::vector<Single> x, y, z;  ///< m
  std::vector<int> v;
};

/// Vertex v was inserted at x_W or moved there.
void note_place(VertexChanges& changes, int v, const Vec3& x_W);

void note_removal(VertexChanges& changes, int v);

void clear(VertexChanges& changes);

/// The last changes of an index, so that a list of some of its vertices need not be made anew after
/// each: those with the numbers from `first` on. Bounded: a list that is older than the journal is
/// made anew.
struct ChangeJournal {
  /// A longer journal costs a list more than being made anew.
  static constexpr std::size_t most = 1024;

  VertexChanges changes;
  long first = 0;  ///< number of the first change that is held; those before are forgotten

  /// The number of the next change: how many there have been.
  long end() const { return first + static_cast<long>(changes.v.size()); }
};

/// Counts changes of which nothing is noted, and forgets what came before.
void pass_over(ChangeJournal& journal, long changes);

/// Makes room for one more change: forgets all of them if there are too many.
void keep_bounded(ChangeJournal& journal);

}  // namespace tdbd::rock
