#pragma once

#include <array>
#include <vector>

#include "mesh/facet.hpp"
#include "mesh/measures.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Bounding-volume tree over the facets of a mesh: boxes are split at the median centroid along their longest side. A
/// query costs the logarithm of the number of facets plus what it finds, allocates nothing, and visits in an order that
/// depends on the mesh alone. Thesis: the fallback search of 4.1.3.3 and 4.1.3.4, reconstructed.
class TriangleTree {
 public:
  TriangleTree() = default;
  explicit TriangleTree(const TriangleMesh& m);

  /// The box of all facets; empty (lo > hi) if there are none.
  Box box() const { return nodes_.empty() ? Box{} : nodes_.front().box; }
  const std::vector<Facet>& facets() const { return facets_; }

  /// Calls visit(facet) for every facet of every leaf whose box and all enclosing boxes satisfy meets(box). Stops when
  /// visit returns false, and then returns false.
  template <class Meets, class Visit>
  bool visit(Meets&& meets, Visit&& visit) const {
    std::array<int, 64> waiting;  // enough for 2^63 facets
    std::size_t count = 0;
    if (!nodes_.empty()) waiting[count++] = 0;
    while (count > 0) {
      const int n = waiting[--count];
      const Node& node = nodes_[at(n)];
      if (!meets(node.box)) continue;
      if (node.facets == 0) {
        waiting[count++] = node.next;
        waiting[count++] = n + 1;
      }
      for (int i = node.next; i < node.next + node.facets; ++i)
        if (!visit(facets_[at(i)])) return false;
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
