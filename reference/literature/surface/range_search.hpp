#pragma once

#include <vector>

#include "core/types.hpp"

namespace tdbd::reference {

/// An axis-aligned box, m. Points on its sides are inside.
struct SearchBox {
  Vec3 lo = Vec3::Zero(), hi = Vec3::Zero();
};

/// Orthogonal range search over points, twin of the vertex index. Thesis 4.1.1 finds the rock's
/// vertices in the motion box of a part (the box around the part in both positions) with a library,
/// PiRaT by P. Krysl, of which only the name is known to us. This is a standard k-d tree: points
/// are halved along the longest side of their bounding box, down to leaves with a few points. The
/// run time of a query is proportional to the nodes that its box meets and the points that it
/// contains.
class RangeSearch {
 public:
  /// The number of a point is its index in `positions`.
  explicit RangeSearch(const std::vector<Vec3>& positions);

  /// Recomputes the boxes of all nodes after points have moved, with the same numbers. The tree
  /// structure is kept, so queries become slower, but not wrong, if points move far.
  void refit(const std::vector<Vec3>& positions);

  /// Writes the numbers of all points in the box, in the order of the tree, to `found`.
  void find(const SearchBox& box, std::vector<int>& found) const;

 private:
  static constexpr int leaf_size = 8;
  /// The points from `first` to `last`. The child nodes are `near` and `far`, 0 for a leaf.
  struct Node {
    SearchBox around;
    int first = 0, last = 0, near = 0, far = 0;
  };

  int split(const std::vector<Vec3>& positions, int first, int last);
  void surround(Node& node) const;

  std::vector<Node> nodes_;  ///< children after their parent
  std::vector<int> numbers_;
  std::vector<Vec3> points_;  ///< in the order of numbers_
};

}  // namespace tdbd::reference
