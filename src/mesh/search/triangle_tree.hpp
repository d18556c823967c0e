#pragma once

#include <array>
#include <vector>

#include "mesh/facet.hpp"
#include "mesh/measures.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Bounding-volume tree over the facets of a mesh. Boxes are split at the median centroid along
/// their longest side. The run time of a query grows with the logarithm of the number of facets
/// plus the number of facets found. A query allocates nothing, and its order depends on the mesh
/// only. Thesis: the fallback search of 4.1.3.3 and 4.1.3.4, reconstructed.
class TriangleTree {
 public:
  TriangleTree() = default;
  explicit TriangleTree(const TriangleMesh& m);

  /// The box of all facets; empty (lo > hi) if there are none.
  Box box() const { return nodes_.empty() ? Box{} : nodes_.front().box; }
  const std::vector<Facet>& facets() const { return facets_; }

  /// Calls visit(facet) for every facet of every leaf for which meets(box) is true for its box and
  /// all enclosing boxes. Stops if visit returns false, and then returns false.
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
  /// The first child of an inner node is the next node.
  struct Node {
    Box box;
    int next = 0;    ///< inner: second child; leaf: first facet
    int facets = 0;  ///< leaf: number of facets; inner: 0
  };
  void build(std::vector<int>& order, int first, int last, const TriangleMesh& m);

  std::vector<Node> nodes_;
  std::vector<Facet> facets_;
};

}  // namespace tdbd::mesh
