#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/types.hpp"
#include "mesh/measures.hpp"

namespace tdbd::rock {

/// lo <= n . x <= hi; all of space by default.
struct Slab {
  Vec3 n = Vec3::Zero();
  double lo = -INFINITY, hi = INFINITY;
};

/// A box, cut further by slabs in other directions.
struct Region {
  mesh::Box box;
  std::array<Slab, 3> slabs{};
};

/// Uniform grid over the rock's vertices: the spatial index of section 4.1.1. A cell is a chain of
/// small blocks that hold its vertices' numbers and places side by side, so that a query reads
/// memory in runs. A vertex outside the grid's box lives in the nearest border cell, so no query
/// misses it. Moving a vertex costs a few writes; a query costs its cells and their vertices.
class VertexGrid {
 public:
  VertexGrid() = default;
  VertexGrid(const mesh::Box& box_W, double cell);

  /// Puts these vertices into the empty grid, neighbouring cells side by side in memory.
  void insert_all(const std::vector<Vec3>& positions_W, std::vector<int> vertices);
  void insert(int v, const Vec3& x_W);
  void remove(int v);
  void move(int v, const Vec3& x_W);

  /// No vertex between the heights z_lo and z_hi (m) is nearer to the z axis of space than this, m:
  /// what turns inside a borehole without reaching its wall need not look at the wall. A bound: a
  /// layer of cells remembers its nearest vertex after that has left.
  double nearest_to_axis(double z_lo, double z_hi) const;

  /// Looks one layer of cells through for its nearest vertex, the next at the next call.
  void refresh_one_layer();

  /// A run of a cell's vertices.
  static constexpr int block_size = 5;  // three cache lines
  struct Entry {
    Vec3 x_W;
    int v;
  };
  struct alignas(64) Block {
    int count = 0, next = -1;
    std::array<Entry, block_size> entries;
  };

  /// Calls visit(block) for every block of every cell that the region may meet: a superset of the
  /// vertices inside. `chains` is room to gather the cells in first, so that memory is asked for
  /// many blocks at once and not waited for one by one.
  template <class Visit>
  void visit(const Region& region_W, std::vector<int>& chains, Visit&& visit) const {
    gather(region_W, chains);
    for (int b : chains)
      for (; b >= 0; b = blocks_[static_cast<std::size_t>(b)].next)
        visit(blocks_[static_cast<std::size_t>(b)]);
  }

 private:
  struct Cell {
    int i, j, k;
  };
  struct Row {
    int first, last;
  };
  struct Place {
    int cell = -1, block = -1, slot = -1;
  };

  int along(double x, double lo, int n) const {
    return static_cast<int>(
        std::clamp(std::floor((x - lo) * inverse_cell_), 0.0, static_cast<double>(n - 1)));
  }
  Cell cell_at(const Vec3& x) const {
    return {along(x.x(), lo_.x(), nx_), along(x.y(), lo_.y(), ny_), along(x.z(), lo_.z(), nz_)};
  }
  int index(const Cell& c) const { return (c.k * ny_ + c.j) * nx_ + c.i; }

  /// The first blocks of all cells that are not empty and that the region may meet.
  void gather(const Region& region_W, std::vector<int>& chains) const;
  int new_block(int next);
  void put(int v, const Vec3& x_W, int cell);
  /// The cells from first to last of row (j, k) that no slab excludes.
  Row clip(const Region& region_W, int first, int last, int j, int k) const;
  /// The first cell from `i` on in row (j, k) that has vertices; nx_ or more if there is none.
  int next_occupied(int i, int j, int k) const;
  void mark(int cell, bool occupied);
  void note_radius(int cell, const Vec3& x_W);

  Vec3 lo_ = Vec3::Zero();
  double cell_ = 1.0, inverse_cell_ = 1.0;
  int nx_ = 1, ny_ = 1, nz_ = 1, words_ = 1;
  std::vector<std::uint64_t> occupied_;  ///< a bit per cell, `words_` words per row
  std::vector<int> head_;  ///< per cell: first block of its chain, the only one that is not full
  std::vector<Block> blocks_;
  std::vector<int> free_blocks_;
  std::vector<Place> places_;            ///< per vertex
  std::vector<double> nearest_radius2_;  ///< per layer, m2
  int next_layer_ = 0;
};

}  // namespace tdbd::rock
