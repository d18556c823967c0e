#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/types.hpp"
#include "mesh/measures.hpp"

namespace tdbd::rock {

/// Uniform grid of linked lists over the rock's vertices: the spatial index of section 4.1.1.
/// A vertex outside the grid's box lives in the nearest border cell, so no query misses it.
/// Moving a vertex costs two list operations; a query costs its cells and their vertices.
class VertexGrid {
 public:
  VertexGrid() = default;
  VertexGrid(const mesh::Box& box_W, double cell);

  void insert(int v, const Vec3& x_W);
  void remove(int v);
  void move(int v, const Vec3& x_W);

  /// Calls visit(v) for the vertices of every cell that the box meets: a superset of those inside.
  template <class Visit>
  void visit(const mesh::Box& box_W, Visit&& visit) const {
    const Cell lo = cell_at(box_W.lo), hi = cell_at(box_W.hi);
    for (int k = lo.k; k <= hi.k; ++k)
      for (int j = lo.j; j <= hi.j; ++j) {
        const auto row = static_cast<std::size_t>(index({0, j, k}));
        for (int i = lo.i; i <= hi.i; ++i)
          for (int v = head_[row + static_cast<std::size_t>(i)]; v >= 0;
               v = links_[static_cast<std::size_t>(v)].next)
            visit(v);
      }
  }

 private:
  struct Cell {
    int i, j, k;
  };
  struct Link {
    int next = -1, previous = -1, cell = -1;
  };
  int along(double x, double lo, int n) const {
    return static_cast<int>(
        std::clamp(std::floor((x - lo) * inverse_cell_), 0.0, static_cast<double>(n - 1)));
  }
  Cell cell_at(const Vec3& x) const {
    return {along(x.x(), lo_.x(), nx_), along(x.y(), lo_.y(), ny_), along(x.z(), lo_.z(), nz_)};
  }
  int index(const Cell& c) const { return (c.k * ny_ + c.j) * nx_ + c.i; }
  void link(int v, int cell);

  Vec3 lo_ = Vec3::Zero();
  double inverse_cell_ = 1.0;
  int nx_ = 1, ny_ = 1, nz_ = 1;
  std::vector<int> head_;
  std::vector<Link> links_;
};

}  // namespace tdbd::rock
