#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "core/single.hpp"
#include "core/types.hpp"

namespace tdbd::rock {

/// Coordinate of a removed vertex. No comparison with it is true.
inline constexpr Single nowhere = std::numeric_limits<Single>::quiet_NaN();

/// Changes of vertices in chronological order: the new place, or `nowhere` if the vertex was
/// removed. The columns are padded to whole packs of eight.
struct VertexChanges {
  std::vector<Single> x, y, z;  ///< m
  std::vector<int> v;
};

/// Records that vertex v was inserted at x_W or moved there.
void note_place(VertexChanges& changes, int v, const Vec3& x_W);

void note_removal(VertexChanges& changes, int v);

void clear(VertexChanges& changes);

/// The latest changes of an index, so that a list of some of its vertices can be updated. Its
/// length is bounded. A list that is older than the first recorded change is rebuilt.
struct ChangeJournal {
  /// Rebuilding a list is faster than applying a longer journal.
  static constexpr std::size_t most = 1024;

  VertexChanges changes;
  long first = 0;  ///< number of the first recorded change; earlier ones were discarded

  /// The number of the next change: the number of changes so far.
  long end() const { return first + static_cast<long>(changes.v.size()); }
};

/// Counts `changes` changes without recording them, and discards the recorded ones.
void pass_over(ChangeJournal& journal, long changes);

/// Makes room for one more change. Discards all of them if there are too many.
void keep_bounded(ChangeJournal& journal);

}  // namespace tdbd::rock
