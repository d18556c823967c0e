#include "rock/index/near_list.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/wide.hpp"
#include "rotation/screw.hpp"

namespace tdbd::rock {
namespace {

constexpr int most_steps = 8;

/// Half of how far a box with these axes reaches along n.
double spread(const Vec3& n, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& half) {
  return std::abs(n.dot(a)) * half.x() + std::abs(n.dot(b)) * half.y() +
         std::abs(n.dot(c)) * half.z();
}

void add(Slab& s, double middle, double half) {
  s.lo = std::min(s.lo, middle - half);
  s.hi = std::max(s.hi, middle + half);
}

void add_box(const mesh::Box& box_P, const Pose& X_WP, std::array<Slab, 3>& slabs) {
  const Vec3 centre_W = X_WP * Vec3(0.5 * (box_P.lo + box_P.hi)), half = 0.5 * box_P.size();
  for (Slab& s : slabs)
    add(s, s.n.dot(centre_W), spread(s.n, X_WP.R.col(0), X_WP.R.col(1), X_WP.R.col(2), half));
}

void add_region(const Region& region_W, std::array<Slab, 3>& slabs) {
  const SlabBox m = slab_box(region_W.slabs);
  for (Slab& s : slabs)
    add(s, s.n.dot(m.centre_W),
        spread(s.n, region_W.slabs[0].n, region_W.slabs[1].n, region_W.slabs[2].n, m.half));
}

/// The region of the group for the next `steps` steps and `margins.ahead` beyond, if its motion
/// continues as in this step; never for more than half a radian.
Region region_ahead(const GroupStep& step, const NearListMargins& margins, int steps) {
  constexpr double largest_turn = 0.5, sideways = 1e-3;  // rad; of the box
  const rotation::Twist twist = rotation::twist_from(step.X_WP0, step.X_WP1, 1.0);
  const double speed = rotation::velocity_B(twist, 0.5 * (step.box_P.lo + step.box_P.hi)).norm(),
               turn = twist.angular_B.norm();
  double end = steps;
  if (speed > 0.0) end += margins.ahead / speed;
  if (turn > 0.0) end = std::min(end, largest_turn / turn);
  const Pose middle = step.X_WP0 * rotation::carried(twist, 0.5 * end);
  Region r;
  for (std::size_t k = 0; k < r.slabs.size(); ++k)
    r.slabs[k] = {middle.R.col(static_cast<int>(k)), INFINITY, -INFINITY};
  for (const Pose& X_WP : {step.X_WP0, middle, Pose(step.X_WP0 * rotation::carried(twist, end))})
    add_box(step.box_P, X_WP, r.slabs);
  add_region(step.region_W, r.slabs);
  const double margin = margins.margin + sideways * step.box_P.size().norm();
  for (Slab& s : r.slabs) {
    s.lo -= margin;
    s.hi += margin;
  }
  r.box = box_around(r.slabs);
  return r;
}

constexpr Single nowhere = std::numeric_limits<Single>::quiet_NaN();

void clear(NearList& list) {
  for (auto* column :
       {&list.x, &list.y, &list.z, &list.balls.x, &list.balls.y, &list.balls.z, &list.balls.radius})
    column->clear();
  list.v.clear();
}

void write(NearList& list, std::size_t i, const Vec3& x_W) {
  list.x[i] = static_cast<Single>(x_W.x() - list.origin_W.x());
  list.y[i] = static_cast<Single>(x_W.y() - list.origin_W.y());
  list.z[i] = static_cast<Single>(x_W.z() - list.origin_W.z());
}

/// Makes room for one more pack and its ball.
void add_pack(NearList& list) {
  const std::size_t begin = list.x.size(), pack = begin / single_lanes;
  for (auto* column : {&list.x, &list.y, &list.z}) column->resize(begin + single_lanes, nowhere);
  Balls& balls = list.balls;
  if (pack == balls.x.size())
    for (auto* column : {&balls.x, &balls.y, &balls.z, &balls.radius})
      column->resize(pack + single_lanes, nowhere);
}

/// Of a place from the middle of its pack's ball, m2.
Single squared_distance(const NearList& list, std::size_t i) {
  const std::size_t pack = i / single_lanes;
  const Balls& b = list.balls;
  const Single dx = list.x[i] - b.x[pack], dy = list.y[i] - b.y[pack], dz = list.z[i] - b.z[pack];
  return dx * dx + dy * dy + dz * dz;
}

constexpr Single ball_rounding = 1.001F;  // of a radius

/// Widens the ball of the place's pack until it holds the place.
void widen_ball(NearList& list, std::size_t i) {
  Single& radius = list.balls.radius[i / single_lanes];
  radius = std::max(radius, ball_rounding * std::sqrt(squared_distance(list, i)));
}

/// Appends without updating the ball of the pack. Returns the place's number.
std::size_t append(NearList& list, int v, const Vec3& x_W) {
  const std::size_t i = list.v.size();
  list.v.push_back(v);
  if (i == list.x.size()) add_pack(list);
  write(list, i, x_W);
  return i;
}

/// The balls about the middles of the packs' boxes.
void make_balls(NearList& list) {
  Balls& b = list.balls;
  for (std::size_t begin = 0, pack = 0; begin < list.v.size(); begin += single_lanes, ++pack) {
    const std::size_t end = std::min(begin + single_lanes, list.v.size());
    const auto middle = [&](const std::vector<Single>& x) {
      Single lo = x[begin], hi = lo;
      for (std::size_t i = begin + 1; i < end; ++i)
        lo = std::min(lo, x[i]), hi = std::max(hi, x[i]);
      return Single{0.5F} * (lo + hi);
    };
    b.x[pack] = middle(list.x), b.y[pack] = middle(list.y), b.z[pack] = middle(list.z);
    Single farthest2 = 0;
    for (std::size_t i = begin; i < end; ++i)
      farthest2 = std::max(farthest2, squared_distance(list, i));
    b.radius[pack] = ball_rounding * std::sqrt(farthest2);
  }
}

/// Slabs in single precision, about a list's origin.
struct SingleSlabs {
  std::array<Single, 3> nx{}, ny{}, nz{}, lo{}, hi{};
};

SingleSlabs about(const Vec3& origin_W, const std::array<Slab, 3>& slabs, double slack) {
  SingleSlabs single;
  for (std::size_t k = 0; k < slabs.size(); ++k) {
    const Slab& s = slabs[k];
    single.nx[k] = static_cast<Single>(s.n.x());
    single.ny[k] = static_cast<Single>(s.n.y());
    single.nz[k] = static_cast<Single>(s.n.z());
    single.lo[k] = static_cast<Single>(s.lo - slack - s.n.dot(origin_W));
    single.hi[k] = static_cast<Single>(s.hi + slack - s.n.dot(origin_W));
  }
  return single;
}

/// Bit l: whether a point of ball l of eight may lie between all slabs.
TDBD_WIDE unsigned balls_between(const Balls& balls, std::size_t i, const SingleSlabs& s) {
  WideBalls b;
  load(balls, i, b);
  WideFlags in = WideFlags{} - 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const WideSingle along = s.nx[k] * b.x + s.ny[k] * b.y + s.nz[k] * b.z;
    in &= (along + b.radius >= s.lo[k]) & (along - b.radius <= s.hi[k]);
  }
  return bits_of(in);
}

/// Bit l: whether place l of eight lies between all slabs.
TDBD_WIDE unsigned between(const Single* px, const Single* py, const Single* pz,
                           const SingleSlabs& s) {
  WideSingle x, y, z;
  TDBD_LOAD(x, px);
  TDBD_LOAD(y, py);
  TDBD_LOAD(z, pz);
  WideFlags in = WideFlags{} - 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const WideSingle along = s.nx[k] * x + s.ny[k] * y + s.nz[k] * z;
    in &= (along >= s.lo[k]) & (along <= s.hi[k]);
  }
  return bits_of(in);
}

void gather(const VertexGrid& grid, NearList& list) {
  clear(list);
  const double slack = single_slack(list.region_W.box);
  list.origin_W = slab_box(list.region_W.slabs).centre_W;
  const SingleSlabs slabs = about(Vec3::Zero(), list.region_W.slabs, slack);
  grid.visit(list.region_W, list.chains, [&](const VertexGrid::Block& block) {
    std::array<Single, single_lanes> x{}, y{}, z{};
    std::ranges::copy(block.x, x.begin());
    std::ranges::copy(block.y, y.begin());
    std::ranges::copy(block.z, z.begin());
    const unsigned filled = (1U << block.count) - 1U;
    for (unsigned in = filled & between(x.data(), y.data(), z.data(), slabs); in != 0;
         in &= in - 1U) {
      const auto s = static_cast<std::size_t>(std::countr_zero(in));
      append(list, block.v[s], Vec3(x[s], y[s], z[s]));
    }
  });
  make_balls(list);
}

}  // namespace

bool covers(const NearList& list, const VertexGrid& grid, const Region& region_W) {
  if (list.changes != grid.changes()) return false;
  const SlabBox m = slab_box(region_W.slabs);
  return std::ranges::all_of(list.region_W.slabs, [&](const Slab& s) {
    const double at = s.n.dot(m.centre_W);
    const double half =
        spread(s.n, region_W.slabs[0].n, region_W.slabs[1].n, region_W.slabs[2].n, m.half);
    return at - half >= s.lo && at + half <= s.hi;
  });
}

void bring_up_to_date(const VertexGrid& grid, const GroupStep& step, const NearListMargins& margins,
                      NearList& list) {
  const bool has_changed = list.changes != grid.changes();
  if (has_changed || !covers(list, grid, step.region_W)) {
    list.window = std::clamp(has_changed ? list.since_change : list.window + 1, 1, most_steps);
    list.region_W = region_ahead(step, margins, list.window);
    gather(grid, list);
    list.changes = grid.changes();
  }
  list.since_change = has_changed ? 1 : list.since_change + 1;
}

void set_place(NearList& list, std::size_t i, const Vec3& x_W) {
  write(list, i, x_W);
  widen_ball(list, i);
}

void note_moved(NearList& list, int v, const Vec3& x_W) {
  const auto found = std::ranges::find(list.v, v);
  if (found != list.v.end())
    return set_place(list, static_cast<std::size_t>(found - list.v.begin()), x_W);
  const std::size_t i = append(list, v, x_W), pack = i / single_lanes;
  if (i % single_lanes != 0) return widen_ball(list, i);
  Balls& b = list.balls;
  b.x[pack] = list.x[i], b.y[pack] = list.y[i], b.z[pack] = list.z[i], b.radius[pack] = 0;
}

void add_vertices_between(const NearList& list, const Region& region_W, double slack,
                          std::vector<int>& vertices) {
  const SingleSlabs slabs = about(list.origin_W, region_W.slabs, slack);
  for (std::size_t first = 0; first * single_lanes < list.v.size(); first += single_lanes)
    for (unsigned packs = balls_between(list.balls, first, slabs); packs != 0;
         packs &= packs - 1U) {
      const std::size_t begin =
          single_lanes * (first + static_cast<std::size_t>(std::countr_zero(packs)));
      for (unsigned in = between(&list.x[begin], &list.y[begin], &list.z[begin], slabs); in != 0;
           in &= in - 1U)
        vertices.push_back(list.v[begin + static_cast<std::size_t>(std::countr_zero(in))]);
    }
}

}  // namespace tdbd::rock
