#include "rock/cut/hull_sieve.hpp"

#include <algorithm>

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

TDBD_WIDE unsigned put_into_frames(const NearList& list, std::size_t i, const Sieve& s, Run& run) {
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

TDBD_WIDE void sieve_pack(const Run& r, std::size_t i, const Sieve& s, std::size_t planes,
                          Sieved& sieved) {
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

}  // namespace tdbd::rock
