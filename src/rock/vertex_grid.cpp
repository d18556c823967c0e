#include "rock/vertex_grid.hpp"

#include <bit>
#include <utility>

namespace tdbd::rock {
namespace {

/// Asks for all cache lines of a block.
template <class Block>
void prefetch(const Block& block) {
  const char* line = reinterpret_cast<const char*>(&block);
  for (std::size_t i = 0; i < sizeof(Block); i += 64) __builtin_prefetch(line + i);
}

}  // namespace

VertexGrid::VertexGrid(const mesh::Box& box_W, double cell)
    : lo_(box_W.lo), cell_(cell), inverse_cell_(1.0 / cell) {
  const Vec3 n = box_W.size() * inverse_cell_;
  nx_ = 1 + static_cast<int>(n.x());
  ny_ = 1 + static_cast<int>(n.y());
  nz_ = 1 + static_cast<int>(n.z());
  words_ = (nx_ + 63) / 64;
  occupied_.assign(static_cast<std::size_t>(words_) * static_cast<std::size_t>(ny_) *
                       static_cast<std::size_t>(nz_),
                   0);
  nearest_radius2_.assign(static_cast<std::size_t>(nz_), INFINITY);
  head_.assign(
      static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_) * static_cast<std::size_t>(nz_),
      -1);
}

VertexGrid::Row VertexGrid::clip(const Region& region_W, int first, int last, int j, int k) const {
  // Border cells hold what lies outside the grid, so nothing bounds their rows' y and z.
  if (j == 0 || j == ny_ - 1 || k == 0 || k == nz_ - 1) return {first, last};
  const double y = lo_.y() + (j + 0.5) * cell_, z = lo_.z() + (k + 0.5) * cell_;
  double lo = region_W.box.lo.x(), hi = region_W.box.hi.x();
  for (const Slab& s : region_W.slabs) {
    const double centre = s.n.y() * y + s.n.z() * z;
    const double spread = 0.5 * cell_ * (std::abs(s.n.y()) + std::abs(s.n.z()));
    const double a = s.lo - centre - spread, b = s.hi - centre + spread;  // a <= n.x x <= b
    if (std::abs(s.n.x()) < 1e-9) {
      const double slack = 1e-9 * (std::abs(lo) + std::abs(hi));
      if (a > slack || b < -slack) return {0, -1};
      continue;
    }
    lo = std::max(lo, (s.n.x() > 0.0 ? a : b) / s.n.x());
    hi = std::min(hi, (s.n.x() > 0.0 ? b : a) / s.n.x());
  }
  if (lo > hi) return {0, -1};
  return {std::max(first, along(lo, lo_.x(), nx_)), std::min(last, along(hi, lo_.x(), nx_))};
}

int VertexGrid::next_occupied(int i, int j, int k) const {
  const std::uint64_t* row = occupied_.data() + static_cast<std::ptrdiff_t>(k * ny_ + j) * words_;
  int word = i / 64;
  std::uint64_t bits = row[word] & (~std::uint64_t{0} << (i % 64));
  while (bits == 0 && ++word < words_) bits = row[word];
  return bits == 0 ? nx_ : 64 * word + std::countr_zero(bits);
}

void VertexGrid::mark(int cell, bool occupied) {
  const int in_row = cell % nx_;
  const int number = (cell / nx_) * words_ + in_row / 64;
  const auto word = static_cast<std::size_t>(number);
  const std::uint64_t bit = std::uint64_t{1} << (in_row % 64);
  if (occupied)
    occupied_[word] |= bit;
  else
    occupied_[word] &= ~bit;
}

void VertexGrid::gather(const Region& region_W, std::vector<int>& chains) const {
  const Cell lo = cell_at(region_W.box.lo), hi = cell_at(region_W.box.hi);
  chains.clear();
  for (int k = lo.k; k <= hi.k; ++k)
    for (int j = lo.j; j <= hi.j; ++j) {
      const int begin = next_occupied(lo.i, j, k);
      if (begin > hi.i) continue;
      const Row row = clip(region_W, begin, hi.i, j, k);
      for (int i = row.first; i <= row.last; ++i) {
        i = next_occupied(i, j, k);
        if (i > row.last) break;
        const int first = head_[static_cast<std::size_t>(index({i, j, k}))];
        prefetch(blocks_[static_cast<std::size_t>(first)]);
        chains.push_back(first);
      }
    }
}

void VertexGrid::note_radius(int cell, const Vec3& x_W) {
  double& nearest = nearest_radius2_[static_cast<std::size_t>(cell / (nx_ * ny_))];
  nearest = std::min(nearest, x_W.head<2>().squaredNorm());
}

double VertexGrid::nearest_to_axis(double z_lo, double z_hi) const {
  const auto layer = [&](double z) { return nearest_radius2_.begin() + along(z, lo_.z(), nz_); };
  return std::sqrt(*std::min_element(layer(z_lo), layer(z_hi) + 1));
}

void VertexGrid::refresh_one_layer() {
  const int k = next_layer_;
  next_layer_ = (next_layer_ + 1) % nz_;
  nearest_radius2_[static_cast<std::size_t>(k)] = INFINITY;
  for (int j = 0; j < ny_; ++j)
    for (int i = next_occupied(0, j, k); i < nx_;
         i = i + 1 < nx_ ? next_occupied(i + 1, j, k) : nx_)
      for (int b = head_[static_cast<std::size_t>(index({i, j, k}))]; b >= 0;
           b = blocks_[static_cast<std::size_t>(b)].next) {
        const Block& block = blocks_[static_cast<std::size_t>(b)];
        for (int s = 0; s < block.count; ++s)
          note_radius(index({i, j, k}), block.entries[static_cast<std::size_t>(s)].x_W);
      }
}

int VertexGrid::new_block(int next) {
  int b = static_cast<int>(blocks_.size());
  if (free_blocks_.empty()) {
    blocks_.emplace_back();
  } else {
    b = free_blocks_.back();
    free_blocks_.pop_back();
  }
  blocks_[static_cast<std::size_t>(b)].count = 0;
  blocks_[static_cast<std::size_t>(b)].next = next;
  return b;
}

void VertexGrid::put(int v, const Vec3& x_W, int cell) {
  int& head = head_[static_cast<std::size_t>(cell)];
  if (head < 0) mark(cell, true);
  if (head < 0 || blocks_[static_cast<std::size_t>(head)].count == block_size)
    head = new_block(head);
  Block& b = blocks_[static_cast<std::size_t>(head)];
  b.entries[static_cast<std::size_t>(b.count)] = {x_W, v};
  places_[static_cast<std::size_t>(v)] = {cell, head, b.count++};
  note_radius(cell, x_W);
}

void VertexGrid::insert(int v, const Vec3& x_W) {
  if (static_cast<std::size_t>(v) >= places_.size())
    places_.resize(static_cast<std::size_t>(v) + 1);
  put(v, x_W, index(cell_at(x_W)));
}

void VertexGrid::insert_all(const std::vector<Vec3>& positions_W, std::vector<int> vertices) {
  const auto cell_of = [&](int v) {
    return index(cell_at(positions_W[static_cast<std::size_t>(v)]));
  };
  std::ranges::sort(vertices, {}, [&](int v) { return std::pair(cell_of(v), v); });
  places_.resize(positions_W.size());
  for (const int v : vertices) put(v, positions_W[static_cast<std::size_t>(v)], cell_of(v));
}

void VertexGrid::remove(int v) {
  const Place place = places_[static_cast<std::size_t>(v)];
  int& head = head_[static_cast<std::size_t>(place.cell)];
  Block& first = blocks_[static_cast<std::size_t>(head)];
  const Entry last = first.entries[static_cast<std::size_t>(--first.count)];
  blocks_[static_cast<std::size_t>(place.block)].entries[static_cast<std::size_t>(place.slot)] =
      last;
  places_[static_cast<std::size_t>(last.v)] = place;
  places_[static_cast<std::size_t>(v)] = {};
  if (first.count > 0) return;
  free_blocks_.push_back(head);
  head = first.next;
  if (head < 0) mark(place.cell, false);
}

void VertexGrid::move(int v, const Vec3& x_W) {
  const int cell = index(cell_at(x_W));
  const Place place = places_[static_cast<std::size_t>(v)];
  if (cell == place.cell) {
    blocks_[static_cast<std::size_t>(place.block)]
        .entries[static_cast<std::size_t>(place.slot)]
        .x_W = x_W;
    note_radius(cell, x_W);
    return;
  }
  remove(v);
  put(v, x_W, cell);
}

}  // namespace tdbd::rock
