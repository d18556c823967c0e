#pragma once

#include <array>
#include <vector>

#include "mesh/facet.hpp"
#include "mesh/measures.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Bounding-volume tree over the facets of a mesh: boxes halved at the median centre along their
/// longest side. Queries cost the logarithm of the facets plus what they find, allocate nothing,
/// and visit in an order that depends on the mesh alone. Thesis: 4.1.3.3, 4.1.3.4 (its fallback
/// search; reconstructed).
class TriangleTree {
 public:
  TriangleTree() = default;
  explicit TriangleTree(const TriangleMesh& m);

  /// Of all facets; empty (lo > hi) without any.
  Box box() const { return nodes_.empty() ? Box{} : nodes_.front().box; }
  const std::vector<Facet>& facets() const { return facets_; }

  /// Calls visit(facet) for every facet in every leaf whose box and all boxes around it satisfy
  /// meets(box). Ends early when visit returns false, and then returns false.
  template <class Meets, class Visit>
  bool visit(Meets&& meets, Visit&& visit) const {
    std::array<int, 64> waiting;  // as deep as the tree of 2^63 facets
    std::size_t count = 0;
    if (!nodes_.empty()) waiting[count++] = 0;
    while (count > 0) {
      const int at = waiting[--count];
      const Node& node = nodes_[static_cast<std::size_t>(at)];
      if (!meets(node.box)) continue;
      if (node.facets == 0) {
        waiting[count++] = node.next;
        waiting[count++] = at + 1;
      }
      for (int i = node.next; i < node.next + node.facets; ++i)
        if (!visit(facets_[static_cast<std::size_t>(i)])) return false;
    }
    return true;
  }

 private:
  /// An inner node's first child follows it.
  struct Node {
    Box box;
    int next = 0;    ///< inner: second child; leaf: first facet
    int facets = 0;  ///< leaf: how many; inner: 0
  };
  void build(std::vector<int>& order, int first, int last, const TriangleMesh& m);

  std::vector<Node> nodes_;
  std::vector<Facet> facets_;
};

}  // namespace tdbd::mesh
