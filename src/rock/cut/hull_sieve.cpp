#include "rock/cut/hull_sieve.hpp"

#include <algorithm>

namespace tdbd::rock {
namespace {

SingleFrame frame_of(const Pose& X_PW, const Vec3& origin_W) {
  SingleFrame f;
  const Vec3 p = X_PW * origin_W;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    for (int j = 0; j < 3; ++j)
      f.R[3 * k + static_cast<std::size_t>(j)] = static_cast<Single>(X_PW.R(i, j));
    f.p[k] = static_cast<Single>(p[i]);
  }
  return f;
}

SingleBox widened(const mesh::Box& box, double slack) {
  SingleBox b;
  for (int i = 0; i < 3; ++i) {
    b.lo[static_cast<std::size_t>(i)] = static_cast<Single>(box.lo[i] - slack);
    b.hi[static_cast<std::size_t>(i)] = static_cast<Single>(box.hi[i] + slack);
  }
  return b;
}

}  // namespace

Sieve make_sieve(const CuttingGroup& g, const GroupMotion& m, const NearList& list, double gap) {
  const double rounding = single_slack(list.region_W.box), swept = 2.0 * rounding,
               touched = gap + rounding;
  return {frame_of(m.X_PW0, list.origin_W),
          frame_of(m.X_PW1, list.origin_W),
          widened(g.box_P, touched),
          widened(g.box_P, std::max(swept, touched)),
          static_cast<Single>(swept),
          static_cast<Single>(touched),
          g.single_hull_P};
}

TDBD_WIDE unsigned balls_near(const Balls& balls, std::size_t i, const Sieve& s) {
  WideSingle x, y, z, r, q0[3], q1[3];
  TDBD_LOAD(x, &balls.x[i]);
  TDBD_LOAD(y, &balls.y[i]);
  TDBD_LOAD(z, &balls.z[i]);
  TDBD_LOAD(r, &balls.radius[i]);
  WideFlags near = WideFlags{} - 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto &a = s.start.R, &b = s.end.R;
    q0[k] = a[3 * k] * x + a[3 * k + 1] * y + a[3 * k + 2] * z + s.start.p[k];
    q1[k] = b[3 * k] * x + b[3 * k + 1] * y + b[3 * k + 2] * z + s.end.p[k];
    const WideSingle lo = s.either.lo[k] - r, hi = s.either.hi[k] + r;
    near &= ((q0[k] <= hi) | (q1[k] <= hi)) & ((q0[k] >= lo) | (q1[k] >= lo));
  }
  if (!any_of(near)) return 0;
  const SingleSolid& h = s.hull_P;
  const WideSingle room = r + std::max(s.swept_slack, s.touched_slack);
  for (std::size_t l = 0; l < SingleSolid::run; ++l) {
    const WideSingle out0 = h.nx[l] * q0[0] + h.ny[l] * q0[1] + h.nz[l] * q0[2] - h.b[l];
    const WideSingle out1 = h.nx[l] * q1[0] + h.ny[l] * q1[1] + h.nz[l] * q1[2] - h.b[l];
    near &= (out0 < room) | (out1 < room);
  }
  return bits_of(near);
}

TDBD_WIDE unsigned put_into_frames(const NearList& list, std::size_t i, const Sieve& s, Run& run) {
  WideSingle x, y, z;
  TDBD_LOAD(x, &list.x[i]);
  TDBD_LOAD(y, &list.y[i]);
  TDBD_LOAD(z, &list.z[i]);
  const auto &a = s.start.R, &b = s.end.R;
  const WideSingle x0 = a[0] * x + a[1] * y + a[2] * z + s.start.p[0];
  const WideSingle y0 = a[3] * x + a[4] * y + a[5] * z + s.start.p[1];
  const WideSingle z0 = a[6] * x + a[7] * y + a[8] * z + s.start.p[2];
  const WideSingle x1 = b[0] * x + b[1] * y + b[2] * z + s.end.p[0];
  const WideSingle y1 = b[3] * x + b[4] * y + b[5] * z + s.end.p[1];
  const WideSingle z1 = b[6] * x + b[7] * y + b[8] * z + s.end.p[2];
  const auto &lo = s.either.lo, &hi = s.either.hi;
  WideFlags near = ((x0 <= hi[0]) | (x1 <= hi[0])) & ((x0 >= lo[0]) | (x1 >= lo[0]));
  near &= ((y0 <= hi[1]) | (y1 <= hi[1])) & ((y0 >= lo[1]) | (y1 >= lo[1]));
  near &= ((z0 <= hi[2]) | (z1 <= hi[2])) & ((z0 >= lo[2]) | (z1 >= lo[2]));
  const std::size_t n = run.count;
  TDBD_STORE(x0, &run.x0[n]);
  TDBD_STORE(y0, &run.y0[n]);
  TDBD_STORE(z0, &run.z0[n]);
  TDBD_STORE(x1, &run.x1[n]);
  TDBD_STORE(y1, &run.y1[n]);
  TDBD_STORE(z1, &run.z1[n]);
  for (std::size_t l = 0; l < single_lanes; ++l) run.place[n + l] = static_cast<int>(i + l);
  return bits_of(near);
}

TDBD_WIDE void sieve_pack(const Run& r, std::size_t i, const Sieve& s, std::size_t planes,
                          Sieved& sieved) {
  WideSingle x0, y0, z0, x1, y1, z1;
  TDBD_LOAD(x0, &r.x0[i]);
  TDBD_LOAD(y0, &r.y0[i]);
  TDBD_LOAD(z0, &r.z0[i]);
  TDBD_LOAD(x1, &r.x1[i]);
  TDBD_LOAD(y1, &r.y1[i]);
  TDBD_LOAD(z1, &r.z1[i]);
  const auto &lo = s.touched.lo, &hi = s.touched.hi;
  WideFlags swept = WideFlags{} - 1, touched = (x1 <= hi[0]) & (x1 >= lo[0]) & (y1 <= hi[1]) &
                                               (y1 >= lo[1]) & (z1 <= hi[2]) & (z1 >= lo[2]);
  const SingleSolid& h = s.hull_P;
  for (std::size_t k = 0; k < planes && any_of(swept | touched); k += SingleSolid::run)
    for (std::size_t l = k; l < k + SingleSolid::run; ++l) {
      const WideSingle out0 = h.nx[l] * x0 + h.ny[l] * y0 + h.nz[l] * z0 - h.b[l];
      const WideSingle out1 = h.nx[l] * x1 + h.ny[l] * y1 + h.nz[l] * z1 - h.b[l];
      swept &= (out0 < s.swept_slack) | (out1 < s.swept_slack);
      touched &= out1 < s.touched_slack;
    }
  sieved = {bits_of(swept), bits_of(touched)};
}

}  // namespace tdbd::rock
