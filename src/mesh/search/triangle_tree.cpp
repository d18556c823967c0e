#include "mesh/search/triangle_tree.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tdbd::mesh {
namespace {

constexpr int leaf_facets = 4;

Facet facet(const TriangleMesh& m, int i) {
  const Triangle& t = m.triangles[at(i)];
  const auto corner = [&](int k) { return m.positions[at(k)]; };
  return {corner(t[0]), corner(t[1]), corner(t[2])};
}

void add(Box& box, const Facet& f) {
  box.add(f.a);
  box.add(f.b);
  box.add(f.c);
}

/// Three times the centroid.
Vec3 middle(const Facet& f) { return f.a + f.b + f.c; }

}  // namespace

TriangleTree::TriangleTree(const TriangleMesh& m) {
  if (m.triangles.empty()) return;
  std::vector<int> order(m.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  facets_.reserve(order.size());
  build(order, 0, static_cast<int>(order.size()), m);
}

void TriangleTree::build(std::vector<int>& order, int first, int last, const TriangleMesh& m) {
  const std::size_t self = nodes_.size();
  nodes_.emplace_back();
  Box box, middles;
  for (int k = first; k < last; ++k) {
    const Facet f = facet(m, order[at(k)]);
    add(box, f);
    middles.add(middle(f));
  }
  nodes_[self].box = box;
  if (last - first <= leaf_facets) {
    nodes_[self].next = static_cast<int>(facets_.size());
    nodes_[self].facets = last - first;
    for (int k = first; k < last; ++k) facets_.push_back(facet(m, order[at(k)]));
    return;
  }
  Eigen::Index axis = 0;
  middles.size().maxCoeff(&axis);
  const auto key = [&](int i) { return std::pair(middle(facet(m, i))[axis], i); };
  std::sort(order.begin() + first, order.begin() + last,
            [&](int i, int j) { return key(i) < key(j); });
  const int half = first + (last - first) / 2;
  build(order, first, half, m);
  nodes_[self].next = static_cast<int>(nodes_.size());
  build(order, half, last, m);
}

}  // namespace tdbd::mesh
