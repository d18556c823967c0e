#include "rock/maintain/turned_over.hpp"

#include <algorithm>

#include "rock/maintain/ring_spokes.hpp"
#include "rock/maintain/star.hpp"

namespace tdbd::rock {
namespace {

using mesh::VertexStar;

constexpr std::uint8_t all_lean = 0xff;

/// The area vectors of the triangles over the sums of the squares of their spokes, and whether they
/// lean.
struct Areas {
  RingColumn x, y, z;
  RingFlags leans;
};

/// Repeats the first eight behind the n-th.
template <class Ring, class Wide>
void repeat(Ring& c, std::size_t n, const Wide& first) {
  static_assert(sizeof(Ring) == 2 * sizeof(Wide));  // n is at most eight
  TDBD_STORE(first, c.at);
  TDBD_STORE(first, c.at + n);
}

/// Rounding of a component of such an area is below 1e-6; an area of no size leans.
TDBD_WIDE void sift_leaning(const Spokes& d, std::size_t n, Single sine2, Areas& a,
                            unsigned& leaning) {
  WideSpokes w;
  load(d, w);
  const auto& [ex, ey, ez, fx, fy, fz] = w;
  constexpr Single far_from_rounding = 2e-5F, room = 1.2F, no_size = 1e-30F;
  const WideSingle per_size =
      Single{1} / (ex * ex + ey * ey + ez * ez + fx * fx + fy * fy + fz * fz + no_size);
  const WideSingle ax = (ey * fz - ez * fy) * per_size, ay = (ez * fx - ex * fz) * per_size,
                   az = (ex * fy - ey * fx) * per_size;
  const WideFlags upward =
      (az * az > room * sine2 * (ax * ax + ay * ay + az * az)) & (-az > far_from_rounding);
  const WideFlags leans = ~upward;
  repeat(a.x, n, ax);
  repeat(a.y, n, ay);
  repeat(a.z, n, az);
  repeat(a.leans, n, leans);
  leaning = bits_of(leans);
}

/// Bit i: triangle i and another one, one of which leans, may be turned by more than 90 degrees
/// against each other. Every pair is tested once or twice.
TDBD_WIDE void sift_pairs(const Areas& a, std::size_t n, unsigned& turned) {
  constexpr Single far_from_rounding = 1e-5F;
  WideSingle x, y, z;
  WideFlags leans, found = {};
  TDBD_LOAD(x, a.x.at);
  TDBD_LOAD(y, a.y.at);
  TDBD_LOAD(z, a.z.at);
  TDBD_LOAD(leans, a.leans.at);
  for (std::size_t k = 1; k <= n / 2; ++k) {
    WideSingle ox, oy, oz;
    WideFlags other_leans;
    TDBD_LOAD(ox, a.x.at + k);
    TDBD_LOAD(oy, a.y.at + k);
    TDBD_LOAD(oz, a.z.at + k);
    TDBD_LOAD(other_leans, a.leans.at + k);
    found |= ~(x * ox + y * oy + z * oz > far_from_rounding) & (leans | other_leans);
  }
  turned = bits_of(found);
}

/// An open ring and one of more than eight is not sifted.
RingTurns look_at(const mesh::Surface& s, int v, const TurnSieve& sieve) {
  const VertexStar& star = s.star(v);
  if (!has_spokes(star)) return {sieve.now, all_lean, true};
  Spokes spokes;
  find_spokes(s, star, spokes);
  Areas areas;
  unsigned leaning = 0, turned = 0;
  const unsigned all = (1U << star.size) - 1U;
  sift_leaning(spokes, star.size, sieve.sine2, areas, leaning);
  leaning &= all;
  if (leaning != 0) sift_pairs(areas, star.size, turned);
  return {sieve.now, static_cast<std::uint8_t>(leaning), (turned & all) != 0};
}

const RingTurns& turns_at(const mesh::Surface& s, int v, TurnSieve& sieve) {
  RingTurns& turns = sieve.rings[at(v)];
  if (turns.asked != sieve.now) turns = look_at(s, v, sieve);
  return turns;
}

/// Whether a triangle at v may be turned over: a triangle that leans at v, and at one of its corners
/// another one against which it is.
bool may_be_turned_over_at(const mesh::Surface& s, int v, TurnSieve& sieve) {
  const RingTurns turns = turns_at(s, v, sieve);
  if (turns.leaning == 0) return false;
  if (turns.may_fold) return true;
  const VertexStar& star = s.star(v);
  const unsigned first = turns.leaning;
  const unsigned ends = first | first << 1U | first >> (star.size - 1U);
  for (unsigned i = 0; i < star.size; ++i)
    if ((ends >> i & 1U) != 0 && turns_at(s, star.ring[i], sieve).may_fold) return true;
  return false;
}

}  // namespace

void start_asking(const mesh::Surface& s, const MaintenanceLimits& limits, TurnSieve& sieve) {
  sieve.rings.resize(s.stars.size());
  sieve.sine2 = static_cast<Single>(limits.steepest_overhang * limits.steepest_overhang);
  ++sieve.now;
}

void forget(const mesh::Surface& s, const std::vector<int>& vertices, TurnSieve& sieve) {
  sieve.rings.resize(s.stars.size());
  for (const int v : vertices) sieve.rings[at(v)].asked = 0;
}

bool is_turned_over(const mesh::Surface& s, const MaintenanceLimits& limits, int t,
                    TurnSieve& sieve) {
  return std::ranges::any_of(s.triangles[at(t)],
                             [&](int v) { return turns_at(s, v, sieve).may_fold; }) &&
         is_turned_over(s, limits, t);
}

bool is_turned_over_at(const mesh::Surface& s, const MaintenanceLimits& limits, int v,
                       TurnSieve& sieve) {
  if (!may_be_turned_over_at(s, v, sieve)) return false;
  bool found = false;
  mesh::visit_corners(s, v,
                      [&](int c) { found = found || is_turned_over(s, limits, c / 3, sieve); });
  return found;
}

void add_turned_over(const mesh::Surface& s, const MaintenanceLimits& limits, int v,
                     TurnSieve& sieve, std::vector<int>& triangles) {
  if (!may_be_turned_over_at(s, v, sieve)) return;
  mesh::visit_corners(s, v, [&](int c) {
    if (is_turned_over(s, limits, c / 3, sieve)) triangles.push_back(c / 3);
  });
}

}  // namespace tdbd::rock
