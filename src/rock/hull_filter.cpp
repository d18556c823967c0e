#include "rock/hull_filter.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "rock/wide_planes.hpp"

namespace tdbd::rock {
namespace {

/// A plane of the hull with both points outside by `slack`; the number of columns if there is none.
TDBD_WIDE std::size_t separating_plane(const mesh::ConvexSolid& h, const Vec3& q0, const Vec3& q1,
                                       double slack) {
  for (std::size_t i = 0; i < h.b.size(); i += lanes) {
    WidePlanes planes;
    load(h, i, planes);
    const auto& [x, y, z, b] = planes;
    const Wide out0 = x * q0.x() + y * q0.y() + z * q0.z() - b;
    const Wide out1 = x * q1.x() + y * q1.y() + z * q1.z() - b;
    const Wide out = out0 < out1 ? out0 : out1;
    for (std::size_t l = 0; l < lanes; ++l)
      if (out[l] >= slack) return i + l;
  }
  return h.b.size();
}

/// From places about a list's origin to a frame, in single precision.
struct SingleFrame {
  std::array<Single, 9> R{};  ///< by rows
  std::array<Single, 3> p{};
};

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

/// A box in single precision, widened.
struct SingleBox {
  std::array<Single, 3> lo{}, hi{};
};

SingleBox widened(const mesh::Box& box, double slack) {
  SingleBox b;
  for (int i = 0; i < 3; ++i) {
    b.lo[static_cast<std::size_t>(i)] = static_cast<Single>(box.lo[i] - slack);
    b.hi[static_cast<std::size_t>(i)] = static_cast<Single>(box.hi[i] + slack);
  }
  return b;
}

/// What tells what a group may sweep on its way from one pose to the other, and what it may touch
/// at the end; nothing if that slack is negative. Swept: no side of the box and no plane of the hull has the vertex outside by its
/// slack at both poses. Touched: none has it outside by the other slack at the end.
struct Sieve {
  SingleFrame start, end;
  SingleBox swept, touched, either;
  Single swept_slack, touched_slack;
  const SingleSolid& hull_P;
};

/// Bits: those of eight places that are left.
struct Sieved {
  unsigned swept, touched;
};

/// Bit l: whether the ball l of eight may hold something of the group's box at either pose.
TDBD_WIDE unsigned balls_near(const Balls& balls, std::size_t i, const Sieve& s) {
  WideSingle x, y, z, r;
  TDBD_LOAD(x, &balls.x[i]);
  TDBD_LOAD(y, &balls.y[i]);
  TDBD_LOAD(z, &balls.z[i]);
  TDBD_LOAD(r, &balls.radius[i]);
  WideFlags near = WideFlags{} - 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto &a = s.start.R, &b = s.end.R;
    const WideSingle q0 = a[3 * k] * x + a[3 * k + 1] * y + a[3 * k + 2] * z + s.start.p[k];
    const WideSingle q1 = b[3 * k] * x + b[3 * k + 1] * y + b[3 * k + 2] * z + s.end.p[k];
    const WideSingle lo = s.either.lo[k] - r, hi = s.either.hi[k] + r;
    near &= ((q0 <= hi) | (q1 <= hi)) & ((q0 >= lo) | (q1 >= lo));
  }
  return bits_of(near);
}

/// Eight places, from that at i on.
TDBD_WIDE void sieve_pack(const NearList& list, std::size_t i, const Sieve& s, Sieved& sieved) {
  WideSingle x, y, z;
  TDBD_LOAD(x, &list.x[i]);
  TDBD_LOAD(y, &list.y[i]);
  TDBD_LOAD(z, &list.z[i]);
  WideSingle q0[3], q1[3];
  WideFlags swept = WideFlags{} - 1, touched = swept;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto &a = s.start.R, &b = s.end.R;
    q0[k] = a[3 * k] * x + a[3 * k + 1] * y + a[3 * k + 2] * z + s.start.p[k];
    q1[k] = b[3 * k] * x + b[3 * k + 1] * y + b[3 * k + 2] * z + s.end.p[k];
    swept &= ((q0[k] <= s.swept.hi[k]) | (q1[k] <= s.swept.hi[k])) &
             ((q0[k] >= s.swept.lo[k]) | (q1[k] >= s.swept.lo[k]));
    touched &= (q1[k] <= s.touched.hi[k]) & (q1[k] >= s.touched.lo[k]);
  }
  const SingleSolid& h = s.hull_P;
  for (std::size_t k = 0; k < h.planes && any_of(swept | touched); k += SingleSolid::run)
    for (std::size_t l = k; l < k + SingleSolid::run; ++l) {
      const WideSingle out0 = h.nx[l] * q0[0] + h.ny[l] * q0[1] + h.nz[l] * q0[2] - h.b[l];
      const WideSingle out1 = h.nx[l] * q1[0] + h.ny[l] * q1[1] + h.nz[l] * q1[2] - h.b[l];
      swept &= (out0 < s.swept_slack) | (out1 < s.swept_slack);
      touched &= out1 < s.touched_slack;
    }
  sieved = {bits_of(swept), bits_of(touched)};
}

/// Calls visit_swept(place in the list) and visit_touched for what the sieve lets through.
template <class Swept, class Touched>
void sift(const NearList& list, const Sieve& sieve, Swept&& visit_swept, Touched&& visit_touched) {
  for (std::size_t first = 0; first * single_lanes < list.v.size(); first += single_lanes)
    for (unsigned packs = balls_near(list.balls, first, sieve); packs != 0; packs &= packs - 1U) {
      const std::size_t begin =
          single_lanes * (first + static_cast<std::size_t>(std::countr_zero(packs)));
      Sieved in;
      sieve_pack(list, begin, sieve, in);
      for (; in.swept != 0; in.swept &= in.swept - 1U)
        visit_swept(begin + static_cast<std::size_t>(std::countr_zero(in.swept)));
      for (; in.touched != 0; in.touched &= in.touched - 1U)
        visit_touched(begin + static_cast<std::size_t>(std::countr_zero(in.touched)));
    }
}

/// Twice the slack of rounding for what is swept: what this turns away, keeps_outside would, so
/// that the list has no say.
Sieve sieve_of(const CuttingGroup& g, const GroupMotion& m, const NearList& list, double gap) {
  const double rounding = single_slack(list.region_W.box), swept = 2.0 * rounding,
               touched = gap + rounding;
  return {frame_of(m.X_PW0, list.origin_W),
          frame_of(m.X_PW1, list.origin_W),
          widened(g.box_P, swept),
          widened(g.box_P, touched),
          widened(g.box_P, std::max(swept, touched)),
          static_cast<Single>(swept),
          static_cast<Single>(touched),
          g.single_hull_P};
}

}  // namespace

void find_candidates(const CuttingGroup& g, const GroupMotion& m,
                     const std::vector<Vec3>& positions_W, const NearList& list, double gap,
                     NearGroup& near) {
  near.places.clear();
  near.touching.clear();
  sift(
      list, sieve_of(g, m, list, gap),
      [&](std::size_t i) {
        if (!keeps_outside(g, m, positions_W[static_cast<std::size_t>(list.v[i])]))
          near.places.push_back(static_cast<int>(i));
      },
      [&](std::size_t i) { near.touching.push_back(list.v[i]); });
}

bool keeps_outside(const CuttingGroup& g, const GroupMotion& m, const Vec3& x_W) {
  if (!is_between(m.region_W.slabs, x_W)) return true;
  const Vec3 q0 = m.X_PW0 * x_W, q1 = m.X_PW1 * x_W;
  for (int k = 0; k < 3; ++k)
    if (std::min(q0[k], q1[k]) > g.box_P.hi[k] || std::max(q0[k], q1[k]) < g.box_P.lo[k])
      return true;
  return separating_plane(g.hull_P, q0, q1, single_slack(m.region_W.box)) < g.hull_P.b.size();
}

bool is_far_from(const CuttingGroup& g, const Vec3& x_P, double gap) {
  return separating_plane(g.hull_P, x_P, x_P, gap) < g.hull_P.b.size();
}

}  // namespace tdbd::rock
