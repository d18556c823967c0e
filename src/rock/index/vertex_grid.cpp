#include "rock/index/vertex_grid.hpp"

#include <utility>

namespace tdbd::rock {
namespace {

void note(VertexChanges& c, int v, Single x, Single y, Single z) {
  const std::size_t i = c.v.size();
  if (i % single_lanes == 0)
    for (auto* column : {&c.x, &c.y, &c.z}) column->resize(i + single_lanes, nowhere);
  c.v.push_back(v);
  c.x[i] = x;
  c.y[i] = y;
  c.z[i] = z;
}

}  // namespace

void note_place(VertexChanges& changes, int v, const Vec3& x_W) {
  note(changes, v, static_cast<Single>(x_W.x()), static_cast<Single>(x_W.y()),
       static_cast<Single>(x_W.z()));
}

void note_removal(VertexChanges& changes, int v) { note(changes, v, nowhere, nowhere, nowhere); }

void clear(VertexChanges& changes) {
  changes.v.clear();
  for (auto* column : {&changes.x, &changes.y, &changes.z}) column->clear();
}

void skip_changes(ChangeJournal& journal, long changes) {
  journal.first = journal.end() + changes;
  if (!journal.changes.v.empty()) clear(journal.changes);
}

void limit_journal(ChangeJournal& journal) {
  if (journal.changes.v.size() >= ChangeJournal::most) skip_changes(journal, 0);
}

namespace {

constexpr int tile_edge = 4;
/// Factor that keeps a radius rounded to single precision below its true value.
constexpr double short_of_rounding = 1.0 - 1e-6;

int tiles_over(int cells) { return (cells + tile_edge - 1) / tile_edge; }

int number_in_tile(int i, int j, int k) {
  return i % tile_edge + 4 * (j % tile_edge) + 16 * (k % tile_edge);
}

std::uint64_t bit_of(int cell) { return std::uint64_t{1} << (cell % 64); }

/// The cells of a tile with lo <= index <= hi in one direction, in which cells are `stride` bits
/// apart. `first`: the tile's first index in that direction.
std::uint64_t cells_between(int lo, int hi, int first, int stride) {
  constexpr std::array<std::uint64_t, 3> planes{0x1111111111111111U, 0x000F000F000F000FU, 0xFFFFU};
  const std::uint64_t plane = planes[stride == 1 ? 0 : (stride == tile_edge ? 1 : 2)];
  std::uint64_t cells = 0;
  for (int n = std::max(lo - first, 0); n <= std::min(hi - first, tile_edge - 1); ++n)
    cells |= plane << (n * stride);
  return cells;
}

}  // namespace

SlabBox slab_box(const std::array<Slab, 3>& slabs) {
  SlabBox box{Vec3::Zero(), Vec3::Zero()};
  for (std::size_t k = 0; k < slabs.size(); ++k) {
    box.centre_W += 0.5 * (slabs[k].lo + slabs[k].hi) * slabs[k].n;
    box.half[static_cast<int>(k)] = 0.5 * (slabs[k].hi - slabs[k].lo);
  }
  return box;
}

mesh::Box box_around(const std::array<Slab, 3>& slabs) {
  const SlabBox box = slab_box(slabs);
  Vec3 half = Vec3::Zero();
  for (std::size_t k = 0; k < slabs.size(); ++k)
    half += box.half[static_cast<int>(k)] * slabs[k].n.cwiseAbs();
  return {box.centre_W - half, box.centre_W + half};
}

VertexGrid::VertexGrid(const mesh::Box& box_W, double cell)
    : lo_(box_W.lo), cell_(cell), inverse_cell_(1.0 / cell) {
  const Vec3 n = box_W.size() * inverse_cell_;
  nx_ = 1 + static_cast<int>(n.x());
  ny_ = 1 + static_cast<int>(n.y());
  nz_ = 1 + static_cast<int>(n.z());
  tiles_x_ = tiles_over(nx_);
  tiles_y_ = tiles_over(ny_);
  tiles_z_ = tiles_over(nz_);
  tile_at_.assign(tile_place(0, 0, tiles_z_), -1);
  nearest_radius2_.assign(static_cast<std::size_t>(nz_), INFINITY);
}

Vec3 VertexGrid::middle_of(const Cell& first, double size) const {
  return lo_ + cell_ * (Vec3(first.i, first.j, first.k) + Vec3::Constant(0.5 * size));
}

std::array<Vec3, 64> VertexGrid::cell_middles(const Mat3& R_PW) const {
  std::array<Vec3, 64> middles_P;
  for (int bit = 0; bit < 64; ++bit) {
    const Cell c = cell_of_bit(Cell{0, 0, 0}, bit);
    const double middle = 0.5 * (tile_edge - 1);
    middles_P[at(bit)] = cell_ * (R_PW * (Vec3(c.i, c.j, c.k) - Vec3::Constant(middle)));
  }
  return middles_P;
}

bool VertexGrid::tile_may_meet(const Region& region_W, const Cell& first) const {
  if (!is_inner(first)) return true;
  const Vec3 middle = middle_of(first, tile_edge);
  return std::ranges::all_of(region_W.slabs, [&](const Slab& s) {
    const double at = s.n.dot(middle), spread = 0.5 * tile_edge * cell_ * s.n.lpNorm<1>();
    return at + spread >= s.lo && at - spread <= s.hi;
  });
}

VertexGrid::CellOffsets VertexGrid::cell_offsets(const Region& region_W) const {
  CellOffsets offsets{};
  for (std::size_t s = 0; s < offsets.along.size(); ++s) {
    const Slab& slab = region_W.slabs[s];
    const Vec3 step = cell_ * slab.n;
    std::size_t bit = 0;
    for (int k = 0; k < tile_edge; ++k)
      for (int j = 0; j < tile_edge; ++j)
        for (int i = 0; i < tile_edge; ++i)
          offsets.along[s][bit++] = i * step.x() + j * step.y() + k * step.z();
    offsets.lo[s] = slab.lo - 0.5 * step.lpNorm<1>();
    offsets.hi[s] = slab.hi + 0.5 * step.lpNorm<1>();
  }
  return offsets;
}

void VertexGrid::gather_tile(const Tile& tile, std::uint64_t cells, const Region& region_W,
                             const CellOffsets& offsets, std::vector<int>& chains) const {
  const Vec3 middle = middle_of(tile.first, 1.0);
  std::array<double, 3> first{};
  for (std::size_t s = 0; s < first.size(); ++s) first[s] = region_W.slabs[s].n.dot(middle);
  for (cells &= tile.occupied; cells != 0; cells &= cells - 1) {
    const int number = std::countr_zero(cells);
    const auto bit = static_cast<std::size_t>(number);
    bool meets = true;
    for (std::size_t s = 0; s < first.size(); ++s) {
      const double at = first[s] + offsets.along[s][bit];
      meets = meets && at >= offsets.lo[s] && at <= offsets.hi[s];
    }
    if (!meets && !on_border(cell_of_bit(tile.first, number))) continue;
    const char* block = reinterpret_cast<const char*>(&blocks_[at(tile.head[bit])]);
    __builtin_prefetch(block);
    __builtin_prefetch(block + 64);
    chains.push_back(tile.head[bit]);
  }
}

void VertexGrid::find_chains(const Region& region_W, std::vector<int>& chains) const {
  const Cell lo = cell_at(region_W.box.lo), hi = cell_at(region_W.box.hi);
  const CellOffsets offsets = cell_offsets(region_W);
  chains.clear();
  for (int tk = lo.k / tile_edge; tk <= hi.k / tile_edge; ++tk)
    for (int tj = lo.j / tile_edge; tj <= hi.j / tile_edge; ++tj)
      for (int ti = lo.i / tile_edge; ti <= hi.i / tile_edge; ++ti) {
        const Cell first{tile_edge * ti, tile_edge * tj, tile_edge * tk};
        const int number = tile_at_[tile_place(ti, tj, tk)];
        if (number < 0 || !tile_may_meet(region_W, first)) continue;
        const std::uint64_t cells = cells_between(lo.i, hi.i, first.i, 1) &
                                    cells_between(lo.j, hi.j, first.j, 4) &
                                    cells_between(lo.k, hi.k, first.k, 16);
        gather_tile(tiles_[at(number)], cells, region_W, offsets, chains);
      }
}

int VertexGrid::layer_of(int cell) const { return tiles_[at(cell / 64)].first.k + cell % 64 / 16; }

void VertexGrid::note_radius(int layer, const Vec3& x_W) {
  double& nearest = nearest_radius2_[at(layer)];
  nearest = std::min(nearest, x_W.head<2>().squaredNorm());
}

double VertexGrid::nearest_to_axis(double z_lo, double z_hi) const {
  const auto layer = [&](double z) { return nearest_radius2_.begin() + along(z, lo_.z(), nz_); };
  return std::sqrt(*std::min_element(layer(z_lo), layer(z_hi) + 1));
}

void VertexGrid::note_radii(const Tile& tile, std::uint64_t cells, int layer) {
  for (; cells != 0; cells &= cells - 1)
    for (int b = tile.head[at(std::countr_zero(cells))]; b >= 0; b = blocks_[at(b)].next) {
      const Block& block = blocks_[at(b)];
      for (std::size_t s = 0; s < static_cast<std::size_t>(block.count); ++s)
        note_radius(layer, short_of_rounding * Vec3(block.x[s], block.y[s], block.z[s]));
    }
}

void VertexGrid::refresh_one_layer() {
  const int k = next_layer_;
  next_layer_ = (next_layer_ + 1) % nz_;
  nearest_radius2_[at(k)] = INFINITY;
  for (std::size_t place = tile_place(0, 0, k / tile_edge);
       place < tile_place(0, 0, k / tile_edge + 1); ++place) {
    if (tile_at_[place] < 0) continue;
    const Tile& tile = tiles_[at(tile_at_[place])];
    note_radii(tile, tile.occupied & cells_between(k, k, tile.first.k, 16), k);
  }
}

int VertexGrid::open_cell(const Cell& c) {
  int& number = tile_at_[tile_place(c.i / tile_edge, c.j / tile_edge, c.k / tile_edge)];
  if (number < 0) {
    number = static_cast<int>(tiles_.size());
    Tile tile;
    tile.first = {c.i / tile_edge * tile_edge, c.j / tile_edge * tile_edge,
                  c.k / tile_edge * tile_edge};
    tile.head.fill(-1);
    tiles_.push_back(tile);
  }
  return 64 * number + number_in_tile(c.i, c.j, c.k);
}

int VertexGrid::new_block(int next) {
  int b = static_cast<int>(blocks_.size());
  if (free_blocks_.empty()) {
    blocks_.emplace_back();
  } else {
    b = free_blocks_.back();
    free_blocks_.pop_back();
  }
  blocks_[at(b)].count = 0;
  blocks_[at(b)].next = next;
  return b;
}

void VertexGrid::write(const Place& place, int v, const Vec3& x_W) {
  Block& b = blocks_[at(place.block)];
  const auto s = static_cast<std::size_t>(place.slot);
  b.x[s] = static_cast<Single>(x_W.x());
  b.y[s] = static_cast<Single>(x_W.y());
  b.z[s] = static_cast<Single>(x_W.z());
  b.v[s] = v;
  deepest_ = std::max(deepest_, x_W.z());
}

void VertexGrid::put(int v, const Vec3& x_W, int cell) {
  Tile& tile = tiles_[at(cell / 64)];
  int& head = tile.head[at(cell % 64)];
  tile.occupied |= bit_of(cell);
  if (head < 0 || blocks_[at(head)].count == block_size) head = new_block(head);
  Place& place = places_[at(v)];
  place = {cell, head, blocks_[at(head)].count++};
  write(place, v, x_W);
  note_radius(layer_of(cell), x_W);
}

void VertexGrid::insert(int v, const Vec3& x_W) {
  limit_journal(journal_);
  note_place(journal_.changes, v, x_W);
  if (static_cast<std::size_t>(v) >= places_.size())
    places_.resize(static_cast<std::size_t>(v) + 1);
  put(v, x_W, open_cell(cell_at(x_W)));
}

void VertexGrid::insert_all(const std::vector<Vec3>& positions_W, std::vector<int> vertices) {
  std::vector<std::pair<std::size_t, int>> placed;  // sorted by tile, then by cell
  placed.reserve(vertices.size());
  for (const int v : vertices) {
    const Cell c = cell_at(positions_W[at(v)]);
    const std::size_t tile = tile_place(c.i / tile_edge, c.j / tile_edge, c.k / tile_edge);
    placed.emplace_back(64 * tile + at(number_in_tile(c.i, c.j, c.k)), v);
  }
  std::ranges::sort(placed);
  std::ranges::transform(placed, vertices.begin(), [](const auto& p) { return p.second; });
  places_.resize(positions_W.size());
  skip_changes(journal_, static_cast<long>(vertices.size()));
  for (const int v : vertices) {
    const Vec3& x_W = positions_W[at(v)];
    put(v, x_W, open_cell(cell_at(x_W)));
  }
}

void VertexGrid::reinsert_chain(const std::vector<Block>& old, int cell,
                                const std::vector<int>& number) {
  int b = std::exchange(tiles_[at(cell / 64)].head[at(cell % 64)], -1);
  for (; b >= 0; b = old[at(b)].next) {
    const Block& block = old[at(b)];
    for (std::size_t s = 0; s < static_cast<std::size_t>(block.count); ++s)
      put(number[at(block.v[s])], Vec3(block.x[s], block.y[s], block.z[s]), cell);
  }
}

void VertexGrid::renumber(const std::vector<int>& number, int vertices, std::vector<Block>& room) {
  skip_changes(journal_, 1);
  room.reserve(blocks_.capacity());
  room.clear();
  blocks_.swap(room);
  free_blocks_.clear();
  places_.resize(at(vertices));
  for (const int tile : tile_at_) {
    if (tile < 0) continue;
    for (std::uint64_t cells = tiles_[at(tile)].occupied; cells != 0; cells &= cells - 1)
      reinsert_chain(room, 64 * tile + std::countr_zero(cells), number);
  }
}

void VertexGrid::remove(int v) {
  limit_journal(journal_);
  note_removal(journal_.changes, v);
  take_out(v);
}

void VertexGrid::take_out(int v) {
  const Place place = places_[at(v)];
  Tile& tile = tiles_[at(place.cell / 64)];
  int& head = tile.head[at(place.cell % 64)];
  Block& first = blocks_[at(head)];
  const auto last = static_cast<std::size_t>(--first.count);
  const int moved = first.v[last];
  write(place, moved, Vec3(first.x[last], first.y[last], first.z[last]));
  places_[at(moved)] = place;
  places_[at(v)] = {};
  if (first.count > 0) return;
  free_blocks_.push_back(head);
  head = first.next;
  if (head < 0) tile.occupied &= ~bit_of(place.cell);
}

void VertexGrid::move(int v, const Vec3& x_W, Notify notify) {
  if (notify == Notify::none) {
    skip_changes(journal_, 1);
  } else {
    limit_journal(journal_);
    note_place(journal_.changes, v, x_W);
  }
  const Place place = places_[at(v)];
  const int cell = open_cell(cell_at(x_W));
  if (cell == place.cell) {
    write(place, v, x_W);
    note_radius(layer_of(cell), x_W);
    return;
  }
  take_out(v);
  put(v, x_W, cell);
}

}  // namespace tdbd::rock
