#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/pose.hpp"
#include "core/single.hpp"
#include "core/types.hpp"
#include "mesh/measures.hpp"
#include "rock/index/change_journal.hpp"

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

/// The box between three orthogonal slabs, by its centre and half its size along their normals, m.
struct SlabBox {
  Vec3 centre_W, half;
};

SlabBox slab_box(const std::array<Slab, 3>& slabs);

/// The axis-aligned box around three orthogonal slabs.
mesh::Box box_around(const std::array<Slab, 3>& slabs);

/// The region with its slabs and sides moved outwards by `by` (m).
inline Region widened(Region r, double by) {
  r.box.lo.array() -= by;
  r.box.hi.array() += by;
  for (Slab& s : r.slabs) {
    s.lo -= by;
    s.hi += by;
  }
  return r;
}

/// Bound of rounding, m: n . x of a vertex in the box, with the index's single coordinates and
/// those of a unit normal, is off by less. A few roundings of 6e-8 of the largest coordinate.
inline double single_slack(const mesh::Box& box_W) {
  return 1e-6 * box_W.lo.cwiseAbs().cwiseMax(box_W.hi.cwiseAbs()).maxCoeff();
}

/// Who tells the lists of an index (near_list.hpp) that a vertex moved: the index's journal, or
/// whoever moved it.
enum class Teller { journal, mover };

/// Uniform grid over the rock's vertices: the spatial index of thesis 4.1.1. Cells are grouped in
/// tiles of 4 x 4 x 4, so that one word tells which of a tile's cells hold vertices and empty space
/// costs one number per tile. A cell is a chain of small blocks that hold its vertices' numbers and
/// places side by side. A vertex outside the grid's box belongs to the nearest border cell, so no
/// query misses it. Moving a vertex costs a few writes; a query costs its tiles, cells and
/// vertices.
class VertexGrid {
 public:
  VertexGrid() = default;
  VertexGrid(const mesh::Box& box_W, double cell);

  /// Puts these vertices into the empty grid, neighbouring cells side by side in memory.
  void insert_all(const std::vector<Vec3>& positions_W, std::vector<int> vertices);
  void insert(int v, const Vec3& x_W);
  void remove(int v);
  void move(int v, const Vec3& x_W, Teller teller = Teller::journal);

  /// The box whose vertices the grid tells apart by their cells, in whole cells, m.
  mesh::Box box() const { return {lo_, lo_ + cell_ * Vec3(nx_, ny_, nz_)}; }
  double cell() const { return cell_; }

  /// The greatest depth z at which a vertex has been, m.
  double deepest() const { return deepest_; }

  /// Prefetches the memory that move() needs.
  void prefetch(int v) const { __builtin_prefetch(&places_[at(v)]); }

  /// How often a vertex was inserted, removed or moved.
  long changes() const { return journal_.end(); }

  /// What the last changes were, those left out of which their mover tells.
  const ChangeJournal& journal() const { return journal_; }

  /// No vertex between the heights z_lo and z_hi (m) is nearer to the z axis of space than this, m:
  /// what turns inside a borehole without reaching its wall need not search the wall. Only a bound:
  /// a layer of cells remembers its nearest vertex after that has left.
  double nearest_to_axis(double z_lo, double z_hi) const;

  /// Finds the nearest vertex of one layer of cells anew; the next call takes the next layer.
  void refresh_one_layer();

  /// A run of a cell's vertices in two cache lines. Places are rounded to single precision: they
  /// serve to reject vertices, not to compute with.
  static constexpr int block_size = 7;
  using Column = std::array<Single, block_size>;
  struct alignas(64) Block {
    Column x{}, y{}, z{};
    std::array<int, block_size> v{};
    int count = 0, next = -1;
  };

  /// Vertex v becomes number[v]; there are `vertices` afterwards. Neighbouring cells come side by
  /// side in memory again. The journal forgets all. `room` exchanges its memory with the blocks.
  void renumber(const std::vector<int>& number, int vertices, std::vector<Block>& room);

  /// Calls visit(block) for every block of every cell that the region may meet: a superset of the
  /// vertices inside. `chains` is a buffer: the cells are gathered there first, so that many blocks
  /// can be prefetched at once.
  template <class Visit>
  void visit(const Region& region_W, std::vector<int>& chains, Visit&& visit) const {
    find_chains(region_W, chains);
    for (int b : chains)
      for (; b >= 0; b = blocks_[at(b)].next) visit(blocks_[at(b)]);
  }

  /// How much of the grid a question is about.
  enum class Span { cell, tile };

  /// The same for every block of every cell in the box for which may(middle_P, Span::cell) is true, in
  /// a tile for which may(middle_P, Span::tile) is: those whose vertices the caller cannot exclude.
  /// Their middles are in the frame P of the caller. Cells on the border hold vertices from outside
  /// them, and are always visited.
  template <class May, class Visit>
  void visit_where(const mesh::Box& box_W, const Pose& X_PW, const May& may, Visit&& visit) const {
    const Cell lo = cell_at(box_W.lo), hi = cell_at(box_W.hi);
    const auto offsets_P = cell_middles(X_PW.R);
    for (int tk = lo.k / 4; tk <= hi.k / 4; ++tk)
      for (int tj = lo.j / 4; tj <= hi.j / 4; ++tj)
        for (int ti = lo.i / 4; ti <= hi.i / 4; ++ti) {
          const int number = tile_at_[tile_place(ti, tj, tk)];
          if (number >= 0) visit_tile_where(tiles_[at(number)], X_PW, offsets_P, may, visit);
        }
  }

  /// The first blocks of all cells that are not empty and that the region may meet, prefetched.
  void find_chains(const Region& region_W, std::vector<int>& chains) const;

  const Block& block(int number) const { return blocks_[at(number)]; }

 private:
  struct Cell {
    int i, j, k;
  };
  struct Place {
    int cell = -1, block = -1, slot = -1;  ///< cell: 64 times its tile, and its bit there
  };
  /// Bit i + 4 j + 16 k stands for a cell. Heads: first block of each chain, the only one that is
  /// not full.
  struct Tile {
    std::uint64_t occupied = 0;
    Cell first{};  ///< its cell with the smallest numbers
    std::array<int, 64> head{};
  };

  /// How far along each slab's normal the middles of a tile's cells lie beyond that of its first
  /// cell, and the slabs widened by half a cell, m.
  struct CellOffsets {
    std::array<std::array<double, 64>, 3> along;
    std::array<double, 3> lo, hi;
  };

  int along(double x, double lo, int n) const {
    return static_cast<int>(std::clamp((x - lo) * inverse_cell_, 0.0, static_cast<double>(n - 1)));
  }
  Cell cell_at(const Vec3& x) const {
    return {along(x.x(), lo_.x(), nx_), along(x.y(), lo_.y(), ny_), along(x.z(), lo_.z(), nz_)};
  }
  static Cell cell_of_bit(const Cell& first, int bit) {
    return {first.i + bit % 4, first.j + bit / 4 % 4, first.k + bit / 16};
  }
  /// Border cells also hold the vertices outside the grid, however far.
  bool on_border(const Cell& c) const {
    return c.i == 0 || c.j == 0 || c.k == 0 || c.i == nx_ - 1 || c.j == ny_ - 1 || c.k == nz_ - 1;
  }
  std::size_t tile_place(int ti, int tj, int tk) const {
    const auto row = static_cast<std::ptrdiff_t>(tk) * tiles_y_ + tj;
    return static_cast<std::size_t>(row * tiles_x_ + ti);
  }

  template <class May, class Visit>
  void visit_tile_where(const Tile& tile, const Pose& X_PW, const std::array<Vec3, 64>& offsets_P,
                        const May& may, Visit&& visit) const {
    if (tile.occupied == 0) return;
    const Vec3 middle_P = X_PW * middle_of(tile.first, 4.0);
    const bool inner = is_inner(tile.first);
    if (inner && !may(middle_P, Span::tile)) return;
    for (std::uint64_t cells = tile.occupied; cells != 0; cells &= cells - 1) {
      const int bit = std::countr_zero(cells);
      if ((inner || !on_border(cell_of_bit(tile.first, bit))) &&
          !may(middle_P + offsets_P[at(bit)], Span::cell))
        continue;
      for (int b = tile.head[at(bit)]; b >= 0; b = blocks_[at(b)].next) visit(blocks_[at(b)]);
    }
  }
  /// From a tile's middle to those of its cells, turned by R_PW, m.
  std::array<Vec3, 64> cell_middles(const Mat3& R_PW) const;
  /// Whether none of a tile's cells is on the border.
  bool is_inner(const Cell& first) const {
    return first.i > 0 && first.j > 0 && first.k > 0 && first.i + 4 < nx_ && first.j + 4 < ny_ &&
           first.k + 4 < nz_;
  }
  void gather_tile(const Tile& tile, std::uint64_t cells, const Region& region_W,
                   const CellOffsets& offsets, std::vector<int>& chains) const;
  /// Whether a tile may hold a vertex of the slabs.
  bool tile_may_meet(const Region& region_W, const Cell& first) const;
  Vec3 middle_of(const Cell& first, double size) const;
  CellOffsets cell_offsets(const Region& region_W) const;
  /// The cell's number, a new tile if it is the first there.
  int open_cell(const Cell& c);
  int new_block(int next);
  /// Puts the vertices of a chain of old blocks, by their new numbers, into its cell again.
  void put_again(const std::vector<Block>& old, int cell, const std::vector<int>& number);
  void put(int v, const Vec3& x_W, int cell);
  /// Takes a vertex out of its cell.
  void take_out(int v);
  void write(const Place& place, int v, const Vec3& x_W);
  void note_radius(int layer, const Vec3& x_W);
  void note_radii(const Tile& tile, std::uint64_t cells, int layer);
  int layer_of(int cell) const;

  Vec3 lo_ = Vec3::Zero();
  double cell_ = 1.0, inverse_cell_ = 1.0;
  int nx_ = 1, ny_ = 1, nz_ = 1, tiles_x_ = 1, tiles_y_ = 1, tiles_z_ = 1;
  std::vector<int> tile_at_;  ///< per place of a tile: its number, -1 if there never was a vertex
  std::vector<Tile> tiles_;
  std::vector<Block> blocks_;
  std::vector<int> free_blocks_;
  std::vector<Place> places_;            ///< per vertex
  std::vector<double> nearest_radius2_;  ///< per layer of cells, m2
  int next_layer_ = 0;
  double deepest_ = -INFINITY;
  ChangeJournal journal_;
};

}  // namespace tdbd::rock
