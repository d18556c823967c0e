#include "rock/section/underside.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include "rock/cut/sieves.hpp"

namespace tdbd::rock {
namespace {

constexpr double columns_across = 200.0;  ///< over the longer side of the part
constexpr double rings_over_column = 4.0;
constexpr double tile_cells = 4.0;
constexpr double room_over_cell = 0.25;
constexpr Single nothing = -std::numeric_limits<Single>::infinity();

/// A triangle projected on the plane z = 0, and its plane.
struct Flat {
  std::array<Vec3, 3> x;
  Vec3 normal;       ///< not a unit vector
  double low, high;  ///< m, smallest and largest z of its corners
};

Flat flat_of(const mesh::TriangleMesh& m, const mesh::Triangle& t) {
  Flat f{{m.positions[at(t[0])], m.positions[at(t[1])], m.positions[at(t[2])]}, {}, 0.0, 0.0};
  f.normal = (f.x[1] - f.x[0]).cross(f.x[2] - f.x[0]);
  const auto [low, high] = std::minmax({f.x[0].z(), f.x[1].z(), f.x[2].z()});
  f.low = low;
  f.high = high;
  return f;
}

/// Whether a square about (x, y) lies beyond one side of the triangle.
bool is_beside(const Flat& f, double x, double y, double half) {
  const double turn = f.normal.z() < 0.0 ? -1.0 : 1.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = f.x[k], &b = f.x[k == 2 ? 0 : k + 1];
    const double nx = turn * (b.y() - a.y()), ny = turn * (a.x() - b.x());  // outwards
    if (nx * (x - a.x()) + ny * (y - a.y()) > half * (std::abs(nx) + std::abs(ny))) return true;
  }
  return false;
}

/// Upper bound of the depth of the triangle over a square about (x, y), m.
double deepest_over(const Flat& f, double x, double y, double half) {
  const Vec3& n = f.normal;
  const double rise = half * (std::abs(n.x()) + std::abs(n.y()));
  const double across = n.x() * (x - f.x[0].x()) + n.y() * (y - f.x[0].y());
  if (std::abs(n.z()) * (f.high - f.low) < rise) return f.high;
  return std::min(f.high, f.x[0].z() - across / n.z() + rise / std::abs(n.z()));
}

void note(const Flat& f, double column, const Underside& u, std::vector<Single>& deepest) {
  const auto [x_lo, x_hi] = std::minmax({f.x[0].x(), f.x[1].x(), f.x[2].x()});
  const auto [y_lo, y_hi] = std::minmax({f.x[0].y(), f.x[1].y(), f.x[2].y()});
  const auto first = [&](double x, double lo) { return static_cast<int>((x - lo) / column); };
  const double half = 0.5 * column;
  for (int j = first(y_lo, u.y_lo); j <= first(y_hi, u.y_lo); ++j)
    for (int i = first(x_lo, u.x_lo); i <= first(x_hi, u.x_lo); ++i) {
      const double x = u.x_lo + (i + 0.5) * column, y = u.y_lo + (j + 0.5) * column;
      if (is_beside(f, x, y, half)) continue;
      Single& d = deepest[at(j * u.nx + i)];
      d = std::max(d, static_cast<Single>(deepest_over(f, x, y, half)));
    }
}

/// The maximum over each column and its eight neighbours, because a place in single precision may
/// be in a neighbouring column.
std::vector<Single> with_neighbours(const Underside& u, const std::vector<Single>& deepest) {
  std::vector<Single> wide(deepest.size(), nothing);
  for (int j = 0; j < u.ny; ++j)
    for (int i = 0; i < u.nx; ++i)
      for (int dj = std::max(0, j - 1); dj <= std::min(u.ny - 1, j + 1); ++dj)
        for (int di = std::max(0, i - 1); di <= std::min(u.nx - 1, i + 1); ++di) {
          Single& d = wide[at(j * u.nx + i)];
          d = std::max(d, deepest[at(dj * u.nx + di)]);
        }
  return wide;
}

/// Per ring of distance from the axis: the maximum over all columns that the ring crosses.
std::vector<Single> by_ring(const Underside& u, double column, double reach) {
  std::vector<Single> rings;
  const double half_diagonal = 0.5 * std::numbers::sqrt2 * column;
  const auto ring = [&](double r) {
    return at(static_cast<int>(std::max(0.0, r * u.rings_per_m)));
  };
  for (int j = 0; j < u.ny; ++j)
    for (int i = 0; i < u.nx; ++i) {
      const Single z = u.deepest[at(j * u.nx + i)];
      if (z == nothing) continue;
      const double r = std::hypot(u.x_lo + (i + 0.5) * column, u.y_lo + (j + 0.5) * column);
      const std::size_t first = ring(r - half_diagonal - reach),
                        last = ring(r + half_diagonal + reach);
      if (last >= rings.size()) rings.resize(last + 1, nothing);
      for (std::size_t k = first; k <= last; ++k) rings[k] = std::max(rings[k], z);
    }
  return rings;
}

}  // namespace

Underside underside_of(const mesh::TriangleMesh& mesh_P, double cell) {
  const mesh::Box box = mesh::bounding_box(mesh_P);
  const double column = std::max(box.size().x(), box.size().y()) / columns_across;
  Underside u;
  u.columns_per_m = 1.0 / column;
  u.rings_per_m = rings_over_column / column;
  u.x_lo = box.lo.x() - 2.0 * column;
  u.y_lo = box.lo.y() - 2.0 * column;
  u.nx = static_cast<int>(std::ceil(box.size().x() / column)) + 4;
  u.ny = static_cast<int>(std::ceil(box.size().y() / column)) + 4;
  std::vector<Single> deepest(at(u.nx) * at(u.ny), nothing);
  for (const mesh::Triangle& t : mesh_P.triangles) note(flat_of(mesh_P, t), column, u, deepest);
  u.deepest = with_neighbours(u, deepest);
  const double half_diagonal = 0.5 * std::numbers::sqrt3 * cell;
  u.margin = room_over_cell * cell;
  const double beside = u.margin + single_place_margin;
  u.deepest_at = {by_ring(u, column, beside), by_ring(u, column, beside + half_diagonal),
                  by_ring(u, column, beside + tile_cells * half_diagonal)};
  return u;
}

namespace {

constexpr int is_known = 0x80;  // a bit above those of the sides

/// The sides of a block's vertices, with the bit is_known set.
TDBD_WIDE void find_sides(const VertexGrid::Block& block, const SingleFrame& X_PW,
                          const SingleBox& box, std::array<int, single_lanes>& sides) {
  WidePoints x_W, q;
  load(block, x_W);
  put_in_frame(x_W, X_PW, q);
  WideFlags s = WideFlags{} + is_known;
  s |= (q.x < box.lo[0]) & 1;
  s |= (q.x > box.hi[0]) & 2;
  s |= (q.y < box.lo[1]) & 4;
  s |= (q.y > box.hi[1]) & 8;
  s |= (q.z < box.lo[2]) & 16;
  s |= (q.z > box.hi[2]) & 32;
  TDBD_STORE(s, sides.data());
}

/// Whether a vertex and all its neighbours lie beyond the same side.
bool is_all_beyond(const Rock& rock, const mesh::Box& box_P, const Pose& X_PW, int v,
                   BoxSidesWork& w) {
  const mesh::VertexStar& star = rock.surface.star(v);
  const int* ring = rock.surface.ring(star);
  unsigned beyond = w.sides[at(v)] & ~unsigned{is_known};
  for (int i = 0; i < star.size && beyond != 0; ++i) {
    std::uint8_t& sides = w.sides[at(ring[i])];
    if (sides == 0) {
      sides = static_cast<std::uint8_t>(is_known |
                                        sides_beyond(box_P, X_PW * rock.surface.position(ring[i])));
      w.known.push_back(ring[i]);
    }
    beyond &= sides;
  }
  return beyond != 0;
}

}  // namespace

std::uint8_t sides_beyond(const mesh::Box& box, const Vec3& x) {
  unsigned sides = 0;
  for (int i = 0; i < 3; ++i)
    sides |= unsigned{x[i] < box.lo[i]} << (2 * i) | unsigned{x[i] > box.hi[i]} << (2 * i + 1);
  return static_cast<std::uint8_t>(sides);
}

void find_around_box(const Rock& rock, const Region& region_W, const mesh::Box& box_P,
                     const Pose& X_PW, BoxSidesWork& w, std::vector<int>& near) {
  const SingleFrame single_PW = single_frame(X_PW, Vec3::Zero());
  const SingleBox wide_P = single_box(box_P, single_place_margin);
  std::array<int, single_lanes> sides{};
  w.sides.resize(rock.surface.stars.size(), 0);
  w.known.clear();
  rock.grid.visit(region_W, w.chains, [&](const VertexGrid::Block& block) {
    find_sides(block, single_PW, wide_P, sides);
    for (std::size_t s = 0; s < at(block.count); ++s)
      w.sides[at(block.v[s])] = static_cast<std::uint8_t>(sides[s]);
    w.known.insert(w.known.end(), block.v.begin(), block.v.begin() + block.count);
  });
  const std::size_t count = w.known.size();
  for (std::size_t i = 0; i < count; ++i)
    if (const int v = w.known[i]; !is_all_beyond(rock, box_P, X_PW, v, w)) near.push_back(v);
  for (const int v : w.known) w.sides[at(v)] = 0;
}

}  // namespace tdbd::rock
