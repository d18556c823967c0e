#include "rock/hull_filter.hpp"

#include <algorithm>

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

/// From places about a list's origin to a frame, and the group's box there, in single precision.
struct SingleFrame {
  std::array<Single, 9> R{};  ///< by rows
  std::array<Single, 3> p{}, lo{}, hi{};
};

SingleFrame frame_of(const Pose& X_PW, const Vec3& origin_W, const mesh::Box& box_P, double slack) {
  SingleFrame f;
  const Vec3 p = X_PW * origin_W;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    for (int j = 0; j < 3; ++j)
      f.R[3 * k + static_cast<std::size_t>(j)] = static_cast<Single>(X_PW.R(i, j));
    f.p[k] = static_cast<Single>(p[i]);
    f.lo[k] = static_cast<Single>(box_P.lo[i] - slack);
    f.hi[k] = static_cast<Single>(box_P.hi[i] + slack);
  }
  return f;
}

constexpr std::size_t run = 256;

/// Vertices of a run that a group's box may meet, in the group's frame at two poses.
struct Run {
  std::array<Single, run> x0, y0, z0, x1, y1, z1;
  std::array<int, run> place;  ///< in the list
  std::size_t count = 0;
};

using Pack = std::array<Single, single_lanes>;

/// Eight places of a list in the frame at two poses; which of them the box may meet.
struct Packed {
  Pack x0, y0, z0, x1, y1, z1;
  std::array<int, single_lanes> is_near;
};

/// A side of the box that is passed at both poses keeps a vertex outside. Returns whether any is
/// left; if not, the rest is not set.
TDBD_WIDE bool put_into_frames(const Single* px, const Single* py, const Single* pz,
                               const SingleFrame& a, const SingleFrame& b, Packed& packed) {
  WideSingle x, y, z;
  TDBD_LOAD(x, px);
  TDBD_LOAD(y, py);
  TDBD_LOAD(z, pz);
  const WideSingle x0 = a.R[0] * x + a.R[1] * y + a.R[2] * z + a.p[0];
  const WideSingle x1 = b.R[0] * x + b.R[1] * y + b.R[2] * z + b.p[0];
  WideFlags near = ((x0 <= a.hi[0]) | (x1 <= a.hi[0])) & ((x0 >= a.lo[0]) | (x1 >= a.lo[0]));
  if (!any_of(near)) return false;
  const WideSingle y0 = a.R[3] * x + a.R[4] * y + a.R[5] * z + a.p[1];
  const WideSingle y1 = b.R[3] * x + b.R[4] * y + b.R[5] * z + b.p[1];
  const WideSingle z0 = a.R[6] * x + a.R[7] * y + a.R[8] * z + a.p[2];
  const WideSingle z1 = b.R[6] * x + b.R[7] * y + b.R[8] * z + b.p[2];
  near &= ((y0 <= a.hi[1]) | (y1 <= a.hi[1])) & ((y0 >= a.lo[1]) | (y1 >= a.lo[1]));
  near &= ((z0 <= a.hi[2]) | (z1 <= a.hi[2])) & ((z0 >= a.lo[2]) | (z1 >= a.lo[2]));
  TDBD_STORE(x0, packed.x0.data());
  TDBD_STORE(y0, packed.y0.data());
  TDBD_STORE(z0, packed.z0.data());
  TDBD_STORE(x1, packed.x1.data());
  TDBD_STORE(y1, packed.y1.data());
  TDBD_STORE(z1, packed.z1.data());
  TDBD_STORE(near, packed.is_near.data());
  return true;
}

void append_near(const Packed& packed, std::size_t begin, Run& r) {
  for (std::size_t l = 0; l < single_lanes; ++l) {  // no branch: chance decides
    r.x0[r.count] = packed.x0[l], r.y0[r.count] = packed.y0[l], r.z0[r.count] = packed.z0[l];
    r.x1[r.count] = packed.x1[l], r.y1[r.count] = packed.y1[l], r.z1[r.count] = packed.z1[l];
    r.place[r.count] = static_cast<int>(begin + l);
    r.count -= static_cast<std::size_t>(packed.is_near[l] < 0 ? -1 : 0);
  }
}

/// Whether a plane of the hull has both points outside by `slack`.
TDBD_WIDE bool is_outside(const SingleSolid& h, const Run& r, std::size_t i, Single slack) {
  WideFlags outside{};
  for (std::size_t k = 0; k < SingleSolid::most; k += single_lanes) {
    WideSingle x, y, z, b;
    TDBD_LOAD(x, &h.nx[k]);
    TDBD_LOAD(y, &h.ny[k]);
    TDBD_LOAD(z, &h.nz[k]);
    TDBD_LOAD(b, &h.b[k]);
    const WideSingle out0 = x * r.x0[i] + y * r.y0[i] + z * r.z0[i] - b;
    const WideSingle out1 = x * r.x1[i] + y * r.y1[i] + z * r.z1[i] - b;
    outside |= (out0 >= slack) & (out1 >= slack);
  }
  return any_of(outside);
}

/// Calls visit(place in the list) for what no plane keeps outside of the hull by `slack` from one
/// pose to the other.
template <class Visit>
void visit_unclear(const CuttingGroup& g, const Pose& X_PW0, const Pose& X_PW1,
                   const NearList& list, double slack, Visit&& visit) {
  const SingleFrame a = frame_of(X_PW0, list.origin_W, g.box_P, slack),
                    b = frame_of(X_PW1, list.origin_W, g.box_P, slack);
  Run r;
  Packed packed;
  for (std::size_t begin = 0; begin < list.v.size();) {
    r.count = 0;
    for (; begin < list.v.size() && r.count + single_lanes < run; begin += single_lanes)
      if (put_into_frames(&list.x[begin], &list.y[begin], &list.z[begin], a, b, packed))
        append_near(packed, begin, r);
    for (std::size_t i = 0; i < r.count; ++i)
      if (!is_outside(g.single_hull_P, r, i, static_cast<Single>(slack)))
        visit(static_cast<std::size_t>(r.place[i]));
  }
}

}  // namespace

void find_candidates(const CuttingGroup& g, const GroupMotion& m,
                     const std::vector<Vec3>& positions_W, const NearList& list,
                     std::vector<int>& places) {
  // Twice the slack: what this turns away, keeps_outside would, so that the list has no say.
  visit_unclear(g, m.X_PW0, m.X_PW1, list, 2.0 * single_slack(list.region_W.box),
                [&](std::size_t i) {
                  if (!keeps_outside(g, m, positions_W[static_cast<std::size_t>(list.v[i])]))
                    places.push_back(static_cast<int>(i));
                });
}

void find_touching(const CuttingGroup& g, const GroupMotion& m, const NearList& list, double gap,
                   std::vector<int>& vertices) {
  visit_unclear(g, m.X_PW1, m.X_PW1, list, gap + single_slack(list.region_W.box),
                [&](std::size_t i) { vertices.push_back(list.v[i]); });
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
