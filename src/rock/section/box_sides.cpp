#include "rock/section/box_sides.hpp"

#include <array>

#include "rock/cut/hull_sieve.hpp"
#include "rock/section/underside.hpp"

namespace tdbd::rock {
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
  const SingleBox wide_P = single_box(box_P, of_single_places);
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
