#pragma once

#include <vector>

#include "core/types.hpp"

namespace tdbd::reference {

/// A box along the axes, m; points on its sides are inside.
struct SearchBox {
  Vec3 lo = Vec3::Zero(), hi = Vec3::Zero();
};

/// Orthogonal range search over points, twin of our vertex index. Thesis 4.1.1 finds the rock's
/// vertices in the motion box of a part (the box around the part in both its places) with a
/// library, PiRaT by P. Krysl, of which we have seen the name only. This one is the textbook's k-d
/// tree: points halved along the longest side of the box around them, down to leaves of a few. A
/// query costs the nodes that its box meets and the points that it holds.
class RangeSearch {
 public:
  /// Points by their number: positions[i] has the number i.
  explicit RangeSearch(const std::vector<Vec3>& positions);

  /// After points have moved, with the same numbers: boxes of all nodes anew. The halves stay as
  /// they were, so a tree whose points move far gets slower, not wrong.
  void refit(const std::vector<Vec3>& positions);

  /// Writes the numbers of all points in the box, in the order of the tree, reusing `found`.
  void find(const SearchBox& box, std::vector<int>& found) const;

 private:
  static constexpr int leaf_size = 8;
  /// The points from `first` to `last`; the halves are the nodes `near` and `far`, 0 for a leaf.
  struct Node {
    SearchBox around;
    int first = 0, last = 0, near = 0, far = 0;
  };

  int split(const std::vector<Vec3>& positions, int first, int last);
  void surround(Node& node) const;

  std::vector<Node> nodes_;  ///< halves after the whole
  std::vector<int> numbers_;
  std::vector<Vec3> points_;  ///< in the order of numbers_
};

}  // namespace tdbd::reference
