#include <algorithm>
#include <bit>
#include <cmath>

#include "rock/index/near_list.hpp"

namespace tdbd::rock {
namespace {

constexpr Single ball_rounding = 1.001F;  // factor on a radius, against rounding

void write(NearList& list, std::size_t i, const Vec3& x_W) {
  list.x[i] = static_cast<Single>(x_W.x() - list.origin_W.x());
  list.y[i] = static_cast<Single>(x_W.y() - list.origin_W.y());
  list.z[i] = static_cast<Single>(x_W.z() - list.origin_W.z());
}

/// Minimum and maximum of eight values, in every lane.
inline void spread_extremes(WideSingle& lo, WideSingle& hi) {
  const auto take = [&](const WideSingle& a, const WideSingle& b) {
    lo = a < lo ? a : lo;
    hi = b > hi ? b : hi;
  };
  take(__builtin_shufflevector(lo, lo, 4, 5, 6, 7, 0, 1, 2, 3),
       __builtin_shufflevector(hi, hi, 4, 5, 6, 7, 0, 1, 2, 3));
  take(__builtin_shufflevector(lo, lo, 2, 3, 0, 1, 6, 7, 4, 5),
       __builtin_shufflevector(hi, hi, 2, 3, 0, 1, 6, 7, 4, 5));
  take(__builtin_shufflevector(lo, lo, 1, 0, 3, 2, 5, 4, 7, 6),
       __builtin_shufflevector(hi, hi, 1, 0, 3, 2, 5, 4, 7, 6));
}

/// Replaces a column by its offsets from the middle of its range.
inline void put_about_middle(WideSingle& x, Single& middle) {
  WideSingle lo = x, hi = x;
  spread_extremes(lo, hi);
  const WideSingle m = Single{0.5F} * (lo + hi);
  middle = m[0];
  x -= m;
}

/// Computes the balls of whole packs.
TDBD_WIDE void make_balls(const NearList& list, std::size_t packs, Balls& b) {
  for (std::size_t pack = 0; pack < packs; ++pack) {
    WideSingle x, y, z;
    TDBD_LOAD(x, &list.x[pack * single_lanes]);
    TDBD_LOAD(y, &list.y[pack * single_lanes]);
    TDBD_LOAD(z, &list.z[pack * single_lanes]);
    put_about_middle(x, b.x[pack]);
    put_about_middle(y, b.y[pack]);
    put_about_middle(z, b.z[pack]);
    WideSingle farthest2 = x * x + y * y + z * z, nearest2 = farthest2;
    spread_extremes(nearest2, farthest2);
    b.radius[pack] = ball_rounding * std::sqrt(farthest2[0]);
  }
}

/// Squared distance of a place from the centre of its pack's ball, m2.
Single squared_distance(const NearList& list, std::size_t i) {
  const std::size_t pack = i / single_lanes;
  const Balls& b = list.balls;
  const Single dx = list.x[i] - b.x[pack], dy = list.y[i] - b.y[pack], dz = list.z[i] - b.z[pack];
  return dx * dx + dy * dy + dz * dz;
}

/// Widens the ball of the place's pack until it contains the place.
void widen_ball(NearList& list, std::size_t i) {
  Single& radius = list.balls.radius[i / single_lanes];
  const Single distance2 = squared_distance(list, i);
  if (distance2 > radius * radius) radius = std::max(radius, ball_rounding * std::sqrt(distance2));
}

/// Adds one pack and its ball.
void add_pack(NearList& list) {
  const std::size_t begin = list.x.size(), pack = begin / single_lanes;
  for (auto* column : {&list.x, &list.y, &list.z}) column->resize(begin + single_lanes, nowhere);
  Balls& balls = list.balls;
  if (pack == balls.x.size())
    for (auto* column : {&balls.x, &balls.y, &balls.z, &balls.radius})
      column->resize(pack + single_lanes, nowhere);
}

/// The slot at which the search for vertex v begins.
std::size_t first_slot(const std::vector<int>& slots, int v) {
  const auto spread = 0x9E3779B97F4A7C15U * static_cast<std::uint64_t>(v);
  return spread >> (64 - std::countr_zero(slots.size()));
}

void enter(NearList& list, std::size_t i) {
  std::vector<int>& slots = list.slots;
  std::size_t s = first_slot(slots, list.v[i]);
  while (slots[s] >= 0) s = (s + 1) & (slots.size() - 1);
  slots[s] = static_cast<int>(i);
}

/// Fills a table with room for twice as many vertices.
void fill_table(NearList& list) {
  constexpr std::size_t least = 16;
  list.slots.assign(std::bit_ceil(std::max(least, 4 * list.v.size())), -1);
  for (std::size_t i = 0; i < list.v.size(); ++i)
    if (list.v[i] != no_vertex) enter(list, i);
}

}  // namespace

void make_room(NearList& list, std::size_t places) {
  const std::size_t room = places + single_lanes;
  if (list.v.size() >= room) return;
  list.v.resize(2 * room);
  for (auto* column : {&list.x, &list.y, &list.z}) column->resize(2 * room);
}

void close(NearList& list, std::size_t places) {
  const std::size_t packs = (places + single_lanes - 1) / single_lanes,
                    groups = (packs + single_lanes - 1) / single_lanes;
  list.v.resize(places);
  Balls& b = list.balls;
  for (auto* column : {&b.x, &b.y, &b.z, &b.radius}) column->assign(groups * single_lanes, nowhere);
  for (auto* column : {&list.x, &list.y, &list.z}) {
    column->resize(packs * single_lanes);
    if (places > 0)
      std::fill(column->begin() + static_cast<std::ptrdiff_t>(places), column->end(),
                (*column)[places - 1]);  // a valid place, so that the last ball is finite
  }
  make_balls(list, packs, b);
  for (auto* column : {&list.x, &list.y, &list.z})
    std::fill(column->begin() + static_cast<std::ptrdiff_t>(places), column->end(), nowhere);
  list.slots.clear();
}

std::size_t place_of(NearList& list, int v) {
  if (list.slots.empty()) fill_table(list);
  const std::vector<int>& slots = list.slots;
  for (std::size_t s = first_slot(slots, v); slots[s] >= 0; s = (s + 1) & (slots.size() - 1))
    if (list.v[at(slots[s])] == v) return at(slots[s]);
  return no_place;
}

void set_place(NearList& list, std::size_t i, const Vec3& x_W) {
  write(list, i, x_W);
  widen_ball(list, i);
}

void append(NearList& list, int v, const Vec3& x_W) {
  const std::size_t i = list.v.size(), pack = i / single_lanes;
  list.v.push_back(v);
  if (i == list.x.size()) add_pack(list);
  write(list, i, x_W);
  if (!list.slots.empty()) {
    if (2 * list.v.size() > list.slots.size())
      fill_table(list);
    else
      enter(list, i);
  }
  if (i % single_lanes != 0) return widen_ball(list, i);
  Balls& b = list.balls;
  b.x[pack] = list.x[i], b.y[pack] = list.y[i], b.z[pack] = list.z[i], b.radius[pack] = 0;
}

void take_out(NearList& list, std::size_t i) {
  list.v[i] = no_vertex;
  list.x[i] = list.y[i] = list.z[i] = nowhere;
}

}  // namespace tdbd::rock
