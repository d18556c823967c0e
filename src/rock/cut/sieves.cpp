#include "rock/cut/sieves.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace tdbd::rock {
namespace {

/// Eight places in the group's frame at both poses. Pass by reference: see core/wide.hpp.
struct WidePlaces {
  std::array<WideSingle, 3> start, end;
};

inline void transform(const Sieve& s, const WideSingle& x, const WideSingle& y, const WideSingle& z,
                      WidePlaces& q) {
  const auto &a = s.start.R, &b = s.end.R;
  for (std::size_t k = 0; k < 3; ++k) {
    q.start[k] = a[3 * k] * x + a[3 * k + 1] * y + a[3 * k + 2] * z + s.start.p[k];
    q.end[k] = b[3 * k] * x + b[3 * k + 1] * y + b[3 * k + 2] * z + s.end.p[k];
  }
}

/// Signed distances of eight places to plane l of the hull at both poses; positive outside.
inline void heights(const SingleSolid& h, std::size_t l, const WidePlaces& q, WideSingle& out0,
                    WideSingle& out1) {
  out0 = h.nx[l] * q.start[0] + h.ny[l] * q.start[1] + h.nz[l] * q.start[2] - h.b[l];
  out1 = h.nx[l] * q.end[0] + h.ny[l] * q.end[1] + h.nz[l] * q.end[2] - h.b[l];
}

}  // namespace

SingleBox single_box(const mesh::Box& box, double slack) {
  SingleBox b;
  for (int i = 0; i < 3; ++i) {
    b.lo[at(i)] = static_cast<Single>(box.lo[i] - slack);
    b.hi[at(i)] = static_cast<Single>(box.hi[i] + slack);
  }
  return b;
}

SingleFrame single_frame(const Pose& X_PW, const Vec3& origin_W) {
  SingleFrame f;
  const Vec3 p = X_PW * origin_W;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) f.R[at(3 * i + j)] = static_cast<Single>(X_PW.R(i, j));
    f.p[at(i)] = static_cast<Single>(p[i]);
  }
  return f;
}

Sieve make_sieve(const CuttingGroup& g, const GroupMotion& m, const NearList& list, double gap) {
  const double rounding = single_slack(list.region_W.box), swept = 2.0 * rounding,
               touched = gap + rounding;
  return {single_frame(m.X_PW0, list.origin_W),
          single_frame(m.X_PW1, list.origin_W),
          single_box(g.box_P, touched),
          single_box(g.box_P, std::max(swept, touched)),
          static_cast<Single>(swept),
          static_cast<Single>(touched),
          g.single_hull_P};
}

TDBD_WIDE unsigned balls_near(const Balls& balls, std::size_t i, const Sieve& s) {
  WideBalls b;
  load(balls, i, b);
  WidePlaces q;
  transform(s, b.x, b.y, b.z, q);
  WideFlags near = WideFlags{} - 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const WideSingle lo = s.either.lo[k] - b.radius, hi = s.either.hi[k] + b.radius;
    near &= ((q.start[k] <= hi) | (q.end[k] <= hi)) & ((q.start[k] >= lo) | (q.end[k] >= lo));
  }
  if (!any_of(near)) return 0;
  const WideSingle room = b.radius + std::max(s.swept_slack, s.touched_slack);
  for (std::size_t k = 0; k < s.hull_P.planes && any_of(near); k += SingleSolid::run)
    for (std::size_t l = k; l < k + SingleSolid::run; ++l) {
      WideSingle out0, out1;
      heights(s.hull_P, l, q, out0, out1);
      near &= (out0 < room) | (out1 < room);
    }
  return bits_of(near);
}

TDBD_WIDE unsigned put_into_frames(const NearList& list, std::size_t i, const Sieve& s,
                                   PlaceBatch& run) {
  WideSingle x, y, z;
  TDBD_LOAD(x, &list.x[i]);
  TDBD_LOAD(y, &list.y[i]);
  TDBD_LOAD(z, &list.z[i]);
  WidePlaces q;
  transform(s, x, y, z, q);
  WideFlags near = WideFlags{} - 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Single lo = s.either.lo[k], hi = s.either.hi[k];
    near &= ((q.start[k] <= hi) | (q.end[k] <= hi)) & ((q.start[k] >= lo) | (q.end[k] >= lo));
    TDBD_STORE(q.start[k], &run.start[k][run.count]);
    TDBD_STORE(q.end[k], &run.end[k][run.count]);
  }
  for (std::size_t l = 0; l < single_lanes; ++l) run.place[run.count + l] = static_cast<int>(i + l);
  return bits_of(near);
}

TDBD_WIDE void sieve_pack(const PlaceBatch& r, std::size_t i, const Sieve& s, std::size_t planes,
                          SievePass& sieved) {
  WidePlaces q;
  WideFlags swept = WideFlags{} - 1, touched = swept;
  for (std::size_t k = 0; k < 3; ++k) {
    TDBD_LOAD(q.start[k], &r.start[k][i]);
    TDBD_LOAD(q.end[k], &r.end[k][i]);
    touched &= (q.end[k] <= s.touched.hi[k]) & (q.end[k] >= s.touched.lo[k]);
  }
  for (std::size_t k = 0; k < planes && any_of(swept | touched); k += SingleSolid::run)
    for (std::size_t l = k; l < k + SingleSolid::run; ++l) {
      WideSingle out0, out1;
      heights(s.hull_P, l, q, out0, out1);
      swept &= (out0 < s.swept_slack) | (out1 < s.swept_slack);
      touched &= out1 < s.touched_slack;
    }
  sieved = {bits_of(swept), bits_of(touched)};
}

namespace {

/// Rounding bound of a coordinate in the group's frame, from the list's coordinates and the frame's
/// own.
double rounding_in_frame(const CuttingGroup& g, const NearList& list) {
  mesh::Box box = list.region_W.box;
  box.add(g.box_P.lo);
  box.add(g.box_P.hi);
  return single_slack(box);
}

/// The group's cylinder, lengthened at each end and widened. Empty if the radius becomes negative.
SingleCylinder cylinder(const CuttingGroup& g, double longer, double wider) {
  const double radius = g.radius + wider;
  return {static_cast<Single>(g.box_P.lo.x() - longer),
          static_cast<Single>(g.box_P.hi.x() + longer), static_cast<Single>(radius),
          static_cast<Single>(radius * std::abs(radius))};
}

/// Upper bound, along each axis of the group, of the way in the step of a vertex that comes within
/// `reach` of the cylinder. From the end back to the start it moves by D q1 + p: as much as the
/// box's middle, plus |D| times its distance from there, of which at most `beyond` is outside the
/// cylinder.
Vec3 longest_way(const CuttingGroup& g, const GroupMotion& m, double reach) {
  const Pose X_P0P1 = m.X_PW0 * m.X_WP1;
  const Mat3 D = X_P0P1.R - Mat3::Identity();
  const Vec3 middle = 0.5 * (g.box_P.lo + g.box_P.hi), there = X_P0P1 * middle - middle;
  const Vec3 room(0.5 * g.box_P.size().x() + reach, g.radius + reach + std::abs(middle.y()),
                  g.radius + reach + std::abs(middle.z()));
  const double turn = D.norm();
  if (turn > 0.5) return Vec3::Constant(INFINITY);
  const double beyond = (there.norm() + turn * room.norm()) / (1.0 - turn);
  return there.cwiseAbs() + D.cwiseAbs() * Vec3(room + Vec3::Constant(beyond));
}

/// The slabs of the region are normal to the group's axes at the end.
SingleBox region_at_end(const GroupMotion& m, double narrower) {
  SingleBox b;
  for (std::size_t k = 0; k < 3; ++k) {
    const Slab& s = m.region_W.slabs[k];
    const double origin = s.n.dot(m.X_WP1.p);
    b.lo[k] = static_cast<Single>(s.lo - origin + narrower);
    b.hi[k] = static_cast<Single>(s.hi - origin - narrower);
  }
  return b;
}

/// Eight places, as columns. Pass by reference: see core/wide.hpp.
struct EightPlaces {
  WideSingle x, y, z;
};

inline void put_into(const SingleFrame& f, const EightPlaces& p, EightPlaces& q) {
  q.x = f.R[0] * p.x + f.R[1] * p.y + f.R[2] * p.z + f.p[0];
  q.y = f.R[3] * p.x + f.R[4] * p.y + f.R[5] * p.z + f.p[1];
  q.z = f.R[6] * p.x + f.R[7] * p.y + f.R[8] * p.z + f.p[2];
}

/// Bit mask of the balls that may reach into the near cylinder.
inline unsigned near_balls(const RoundSieve& s, const Balls& balls, std::size_t i) {
  WideBalls b;
  load(balls, i, b);
  EightPlaces q;
  put_into(s.end, {b.x, b.y, b.z}, q);
  const WideSingle room = s.near.radius + b.radius;
  return bits_of((q.x + b.radius >= s.near.x_lo) & (q.x - b.radius <= s.near.x_hi) &
                 (q.y * q.y + q.z * q.z <= room * room));
}

/// The square of the smallest distance to the axis along the path.
inline void nearest_to_axis(const EightPlaces& q0, const EightPlaces& q1, WideSingle& distance2) {
  const WideSingle dy = q1.y - q0.y, dz = q1.z - q0.z, way2 = dy * dy + dz * dz;
  constexpr Single none = 1e-24F;  // m2: on a path this short any place will do
  WideSingle tau = -(q0.y * dy + q0.z * dz) / (way2 > none ? way2 : WideSingle{} + none);
  tau = tau > 0.0F ? tau : WideSingle{};
  tau = tau < 1.0F ? tau : WideSingle{} + 1.0F;
  const WideSingle y = q0.y + tau * dy, z = q0.z + tau * dz;
  distance2 = y * y + z * z;
}

inline void within(const SingleBox& b, const EightPlaces& q, WideFlags& in) {
  in = (q.x >= b.lo[0]) & (q.x <= b.hi[0]) & (q.y >= b.lo[1]) & (q.y <= b.hi[1]) &
       (q.z >= b.lo[2]) & (q.z <= b.hi[2]);
}

/// Whether the path passes between both ends of a cylinder within its radius of the axis.
inline void passes(const SingleCylinder& c, const WideSingle& x_least, const WideSingle& x_most,
                   const WideSingle& distance2, WideFlags& in) {
  in = (x_least <= c.x_hi) & (x_most >= c.x_lo) & (distance2 <= c.radius2);
}

/// Sieves places that are at q1 at the end.
inline void sieve_places(const RoundSieve& s, const EightPlaces& x, const EightPlaces& q1,
                         SievedPack& pack) {
  EightPlaces q0;
  put_into(s.start, x, q0);
  WideSingle distance2;
  nearest_to_axis(q0, q1, distance2);
  const WideSingle least = q0.x < q1.x ? q0.x : q1.x, most = q0.x < q1.x ? q1.x : q0.x;
  WideFlags swept, inner, region, touched;
  passes(s.swept, least, most, distance2, swept);
  passes(s.inner, least, most, distance2, inner);
  within(s.inner_end, q1, region);
  passes(s.touched, q1.x, q1.x, q1.y * q1.y + q1.z * q1.z, touched);
  pack.swept = pack.touched = pack.certain = 0;
  if (!any_of(swept | touched)) return;
  pack.swept = bits_of(swept);
  pack.certain = bits_of(inner & region);
  pack.touched = bits_of(touched);
}

/// Sieves one pack. Most packs have no place in the near cylinder.
inline void sieve_pack_of(const NearList& list, std::size_t begin, const RoundSieve& s,
                          SievedPack& pack) {
  EightPlaces x, q1;
  TDBD_LOAD(x.x, &list.x[begin]);
  TDBD_LOAD(x.y, &list.y[begin]);
  TDBD_LOAD(x.z, &list.z[begin]);
  put_into(s.end, x, q1);
  WideFlags near;
  passes(s.near, q1.x, q1.x, q1.y * q1.y + q1.z * q1.z, near);
  pack = {static_cast<int>(begin), 0, 0, 0};
  if (any_of(near)) sieve_places(s, x, q1, pack);
}

TDBD_WIDE std::size_t sieve_packs(const NearList& list, const RoundSieve& s, SievedPack* packs) {
  std::size_t count = 0;
  for (std::size_t first = 0; first * single_lanes < list.v.size(); first += single_lanes)
    for (unsigned balls = near_balls(s, list.balls, first); balls != 0; balls &= balls - 1U) {
      const auto pack = first + static_cast<std::size_t>(std::countr_zero(balls));
      sieve_pack_of(list, single_lanes * pack, s, packs[count]);
      count += (packs[count].swept | packs[count].touched) != 0 ? 1 : 0;
    }
  return count;
}

}  // namespace

RoundSieve make_round_sieve(const CuttingGroup& g, const GroupMotion& m, const NearList& list,
                            double gap) {
  const double slack = single_slack(m.region_W.box), rounding = 2.0 * rounding_in_frame(g, list);
  const double touched = gap < 0.0 ? -INFINITY : gap + rounding;
  const double reach = std::max(slack + rounding, touched);
  const Vec3 way = longest_way(g, m, reach);
  return {single_frame(m.X_PW0, list.origin_W),
          single_frame(m.X_PW1, list.origin_W),
          cylinder(g, reach + way.x(), reach + way.tail<2>().norm()),
          cylinder(g, rounding, slack + rounding),
          cylinder(g, -rounding, slack - rounding),
          region_at_end(m, rounding),
          cylinder(g, touched, touched)};
}

std::size_t sieve_round(const NearList& list, const RoundSieve& s, std::vector<SievedPack>& packs) {
  const std::size_t most = list.v.size() / single_lanes + 2;  // the last one is not kept
  if (packs.size() < most) packs.resize(most);
  return sieve_packs(list, s, packs.data());
}

bool misses_cylinder(const CuttingGroup& g, const Vec3& q0_P, const Vec3& q1_P, double slack) {
  if (std::min(q0_P.x(), q1_P.x()) > g.box_P.hi.x() ||
      std::max(q0_P.x(), q1_P.x()) < g.box_P.lo.x())
    return true;
  const Eigen::Vector2d q0 = q0_P.tail<2>(), way = q1_P.tail<2>() - q0;
  const double way2 = way.squaredNorm();
  const double tau = way2 > 0.0 ? std::clamp(-q0.dot(way) / way2, 0.0, 1.0) : 0.0;
  const double reach = g.radius + slack;
  return (q0 + tau * way).squaredNorm() > reach * reach;
}

}  // namespace tdbd::rock
