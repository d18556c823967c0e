#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/simd.hpp"
#include "core/types.hpp"
#include "mesh/measures.hpp"

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
void skip_changes(ChangeJournal& journal, long changes);

/// Makes room for one more change. Discards all of them if there are too many.
void limit_journal(ChangeJournal& journal);

/// lo <= n . x <= hi; all of space by default.
struct Slab {
  Vec3 n = Vec3::Zero();
  double lo = -INFINITY, hi = INFINITY;
};

/// The intersection of a box and slabs in other directions.
struct Region {
  mesh::Box box;
  std::array<Slab, 3> slabs{};
};

/// The box between three orthogonal slabs: its centre and its half size along their normals, m.
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

/// Rounding bound, m, of n . x of a vertex in the box, with the index's single-precision
/// coordinates and a unit normal in single precision. Covers a few roundings of 6e-8 of the largest
/// coordinate.
inline double single_slack(const mesh::Box& box_W) {
  return 1e-6 * box_W.lo.cwiseAbs().cwiseMax(box_W.hi.cwiseAbs()).maxCoeff();
}

/// Who notifies the lists of an index (near_list.hpp) of a move: the index's journal, or the code
/// that moved the vertex.
enum class Notify { journal, none };

/// Uniform grid over the rock's vertices: the spatial index of thesis 4.1.1. Cells are grouped in
/// tiles of 4 x 4 x 4. One 64-bit word stores which cells of a tile contain vertices, and an empty
/// tile takes one number. A cell is a chain of small blocks with its vertices' numbers and places.
/// A vertex outside the grid's box belongs to the nearest border cell, so every query finds it. A
/// move takes a few writes; a query takes time proportional to its tiles, cells and vertices.
class VertexGrid {
 public:
  VertexGrid() = default;
  VertexGrid(const mesh::Box& box_W, double cell);

  /// Inserts these vertices into the empty grid, with neighbouring cells adjacent in memory.
  void insert_all(const std::vector<Vec3>& positions_W, std::vector<int> vertices);
  void insert(int v, const Vec3& x_W);
  void remove(int v);
  void move(int v, const Vec3& x_W, Notify notify = Notify::journal);

  /// The box of the grid, in whole cells, m. Vertices outside it are in border cells.
  mesh::Box box() const { return {lo_, lo_ + cell_ * Vec3(nx_, ny_, nz_)}; }
  double cell() const { return cell_; }

  /// The largest depth z at which a vertex has been, m.
  double deepest() const { return deepest_; }

  /// Prefetches the memory that move() needs.
  void prefetch(int v) const { __builtin_prefetch(&places_[at(v)]); }

  /// Number of insertions, removals and moves so far.
  long changes() const { return journal_.end(); }

  /// The latest changes, except moves with Notify::none.
  const ChangeJournal& journal() const { return journal_; }

  /// A lower bound, m, of the distance from the z axis of W of all vertices between the heights
  /// z_lo and z_hi (m). A part that turns inside a borehole without reaching its wall need not
  /// search the wall. It is only a bound because a layer of cells keeps the radius of its nearest
  /// vertex after that vertex has left.
  double nearest_to_axis(double z_lo, double z_hi) const;

  /// Recomputes the nearest vertex of one layer of cells. The next call updates the next layer.
  void refresh_one_layer();

  /// Up to seven vertices of a cell, in two cache lines. Places are rounded to single precision;
  /// they serve to reject vertices, not to compute with.
  static constexpr int block_size = 7;
  using Column = std::array<Single, block_size>;
  struct alignas(64) Block {
    Column x{}, y{}, z{};
    std::array<int, block_size> v{};
    int count = 0, next = -1;
  };

  /// Renumbers vertex v as number[v]; afterwards there are `vertices` vertices. Neighbouring cells
  /// become adjacent in memory again. The journal is cleared. `room`: buffer, swapped with the
  /// blocks.
  void renumber(const std::vector<int>& number, int vertices, std::vector<Block>& room);

  /// Calls visit(block) for every block of every cell that the region may meet: a superset of the
  /// vertices inside. `chains` is a buffer. The cells are collected in it first, so that many
  /// blocks can be prefetched at once.
  template <class Visit>
  void visit(const Region& region_W, std::vector<int>& chains, Visit&& visit) const {
    find_chains(region_W, chains);
    for (int b : chains)
      for (; b >= 0; b = blocks_[at(b)].next) visit(blocks_[at(b)]);
  }

  /// The part of the grid to which a call of `may` refers.
  enum class Span { cell, tile };

  /// Calls visit(block) for every block of every cell in the box for which may(middle_P,
  /// Span::cell) is true, in every tile for which may(middle_P, Span::tile) is true. The caller
  /// returns false to exclude all vertices of a cell or tile. The middles are in the caller's frame
  /// P. Cells on the border are always visited because they also contain vertices outside them.
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

  /// The first blocks of all nonempty cells that the region may meet. Prefetches them.
  void find_chains(const Region& region_W, std::vector<int>& chains) const;

  const Block& block(int number) const { return blocks_[at(number)]; }

 private:
  struct Cell {
    int i, j, k;
  };
  struct Place {
    int cell = -1, block = -1, slot = -1;  ///< cell: 64 times its tile, plus its bit there
  };
  /// Bit i + 4 j + 16 k refers to a cell. `head`: first block of each chain; only this block may be
  /// partly filled.
  struct Tile {
    std::uint64_t occupied = 0;
    Cell first{};  ///< its cell with the smallest indices
    std::array<int, 64> head{};
  };

  /// Offsets of the middles of a tile's cells from that of its first cell along each slab's normal,
  /// and the slabs widened by half a cell, m.
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
  /// Border cells also contain all vertices outside the grid.
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
  /// Offsets from a tile's middle to those of its cells, rotated by R_PW, m.
  std::array<Vec3, 64> cell_middles(const Mat3& R_PW) const;
  /// Whether none of a tile's cells is on the border.
  bool is_inner(const Cell& first) const {
    return first.i > 0 && first.j > 0 && first.k > 0 && first.i + 4 < nx_ && first.j + 4 < ny_ &&
           first.k + 4 < nz_;
  }
  void gather_tile(const Tile& tile, std::uint64_t cells, const Region& region_W,
                   const CellOffsets& offsets, std::vector<int>& chains) const;
  /// Whether a tile may contain a vertex between the slabs.
  bool tile_may_meet(const Region& region_W, const Cell& first) const;
  Vec3 middle_of(const Cell& first, double size) const;
  CellOffsets cell_offsets(const Region& region_W) const;
  /// Returns the cell's number. Makes a new tile if the cell is the first there.
  int open_cell(const Cell& c);
  int new_block(int next);
  /// Inserts the vertices of a chain of old blocks, with their new numbers, into their cell.
  void reinsert_chain(const std::vector<Block>& old, int cell, const std::vector<int>& number);
  void put(int v, const Vec3& x_W, int cell);
  /// Removes a vertex from its cell.
  void take_out(int v);
  void write(const Place& place, int v, const Vec3& x_W);
  void note_radius(int layer, const Vec3& x_W);
  void note_radii(const Tile& tile, std::uint64_t cells, int layer);
  int layer_of(int cell) const;

  Vec3 lo_ = Vec3::Zero();
  double cell_ = 1.0, inverse_cell_ = 1.0;
  int nx_ = 1, ny_ = 1, nz_ = 1, tiles_x_ = 1, tiles_y_ = 1, tiles_z_ = 1;
  std::vector<int> tile_at_;  ///< per tile position: the tile's number, -1: never a vertex
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
