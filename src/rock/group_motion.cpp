#include "rock/group_motion.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "core/wide.hpp"

namespace tdbd::rock {
namespace {

template <class Visit>
void visit_box_corners(const mesh::Box& box, Visit&& visit) {
  for (int k = 0; k < 8; ++k)
    visit(Vec3(k & 1 ? box.hi.x() : box.lo.x(), k & 2 ? box.hi.y() : box.lo.y(),
               k & 4 ? box.hi.z() : box.lo.z()));
}

/// The box at both poses between axis-aligned planes and between planes normal to its own axes at
/// pose 1.
Region moving_box(const mesh::Box& box_P, const Pose& X_WP0, const Pose& X_WP1) {
  Region r;
  for (std::size_t i = 0; i < 3; ++i)
    r.slabs[i] = {X_WP1.R.col(static_cast<int>(i)), INFINITY, -INFINITY};
  for (const Pose* X_WP : {&X_WP0, &X_WP1})
    visit_box_corners(box_P, [&](const Vec3& x_P) {
      const Vec3 x_W = *X_WP * x_P;
      r.box.add(x_W);
      for (Slab& s : r.slabs) {
        s.lo = std::min(s.lo, s.n.dot(x_W));
        s.hi = std::max(s.hi, s.n.dot(x_W));
      }
    });
  return r;
}

/// A plane of the hull with both points outside by `slack`; the number of columns if there is none.
TDBD_WIDE std::size_t separating_plane(const mesh::ConvexSolid& h, const Vec3& q0, const Vec3& q1,
                                       double slack) {
  for (std::size_t i = 0; i < h.b.size(); i += lanes) {
    Wide x, y, z, b;
    TDBD_LOAD(x, &h.nx[i]);
    TDBD_LOAD(y, &h.ny[i]);
    TDBD_LOAD(z, &h.nz[i]);
    TDBD_LOAD(b, &h.b[i]);
    const Wide out0 = x * q0.x() + y * q0.y() + z * q0.z() - b;
    const Wide out1 = x * q1.x() + y * q1.y() + z * q1.z() - b;
    const Wide out = out0 < out1 ? out0 : out1;
    for (std::size_t l = 0; l < lanes; ++l)
      if (out[l] >= slack) return i + l;
  }
  return h.b.size();
}

/// The chord of a turn comes nearer to the axis than its ends, by the cosine of half the turn; a
/// tilted axis leans at most by the tilt times the distance, counted for the part and for the rock
/// beside it.
double reach(const CuttingGroup& g, const Pose& X_WB0, const Pose& X_WB1) {
  const double cosine = 0.5 * ((X_WB0.R.transpose() * X_WB1.R).trace() - 1.0);
  const double half_turn = std::sqrt(std::max(0.0, 0.5 * (1.0 + cosine)));
  double off_axis = 0.0;
  for (const Pose* X_WB : {&X_WB0, &X_WB1}) {
    const double tilt = (X_WB->R.col(2) - Vec3::UnitZ()).norm();
    off_axis = std::max(off_axis, X_WB->p.head<2>().norm() + 4.0 * tilt * g.distance);
  }
  return half_turn > 0.5 ? g.reach / half_turn + off_axis : INFINITY;
}

Pose direction_frame(const CuttingGroup& g, const Pose& X_WB) {
  const bool leans = X_WB.R.col(2) != Vec3::UnitZ();
  return leans && g.directions == DirectionFrame::upright ? Pose{Mat3::Identity(), X_WB.p} : X_WB;
}

}  // namespace

GroupMotion group_motion(const CuttingGroup& g, const Pose& X_WB0, const Pose& X_WB1) {
  const Pose X_WP0 = X_WB0 * g.X_BP, X_WP1 = X_WB1 * g.X_BP1, X_WD1 = direction_frame(g, X_WB1);
  const bool is_bit = X_WD1.R == X_WB1.R;
  return {inverse(X_WP0),
          inverse(X_WP1),
          inverse(X_WD1),
          X_WD1.R,
          is_bit ? Mat3(Mat3::Identity()) : Mat3(X_WD1.R.transpose() * X_WB1.R),
          reach(g, X_WB0, X_WB1),
          moving_box(g.box_P, X_WP0, X_WP1)};
}

HullFilter::HullFilter(const CuttingGroup& g, const GroupMotion& m)
    : hull_P_(g.hull_P), motion_(m) {
  slack_ = single_slack(m.region_W.box);
  last_ = before_ = in_space(0);
}

HullFilter::SpacePlane HullFilter::in_space(std::size_t i) const {
  const Vec3 n_P = mesh::normal(hull_P_, i);
  const Vec3 n0_W = motion_.X_PW0.R.transpose() * n_P, n1_W = motion_.X_PW1.R.transpose() * n_P;
  SpacePlane plane;
  for (std::size_t k = 0; k < 3; ++k) {
    plane.n0[k] = static_cast<Single>(n0_W[static_cast<int>(k)]);
    plane.n1[k] = static_cast<Single>(n1_W[static_cast<int>(k)]);
  }
  // Twice the slack: what this turns away, find_plane would. So the answer does not hang on which
  // plane is asked first.
  const double b = hull_P_.b[i] + 2.0 * slack_;
  plane.b0 = static_cast<Single>(b - n_P.dot(motion_.X_PW0.p));
  plane.b1 = static_cast<Single>(b - n_P.dot(motion_.X_PW1.p));
  return plane;
}

bool HullFilter::find_plane(const Vec3& x_W) {
  const std::size_t i = separating_plane(hull_P_, motion_.X_PW0 * x_W, motion_.X_PW1 * x_W, slack_);
  if (i == hull_P_.b.size()) return false;
  before_ = last_;
  last_ = in_space(i);
  return true;
}

TDBD_WIDE unsigned HullFilter::outside_of(const VertexGrid::Block& block, const SpacePlane& p) {
  unsigned outside = 0;
  std::array<int, VertexGrid::block_size> both{};
  for (std::size_t s = 0; s < both.size(); ++s) {
    const Single x = block.x[s], y = block.y[s], z = block.z[s];
    both[s] = static_cast<int>(p.n0[0] * x + p.n0[1] * y + p.n0[2] * z >= p.b0) &
              static_cast<int>(p.n1[0] * x + p.n1[1] * y + p.n1[2] * z >= p.b1);
  }
  for (std::size_t s = 0; s < both.size(); ++s) outside |= static_cast<unsigned>(both[s]) << s;
  return outside;
}

void HullFilter::add_unclear(const VertexGrid::Block& block, std::vector<int>& candidates) {
  unsigned unclear = ((1U << block.count) - 1U) & ~outside_of(block, last_);
  if (unclear == 0) return;
  std::swap(last_, before_);
  unclear &= ~outside_of(block, last_);
  for (; unclear != 0; unclear &= unclear - 1U) {
    const auto s = static_cast<std::size_t>(std::countr_zero(unclear));
    if (find_plane(Vec3(block.x[s], block.y[s], block.z[s])))
      unclear &= ~outside_of(block, last_) | (1U << s);
    else
      candidates.push_back(block.v[s]);
  }
}

void find_candidates(const VertexGrid& grid, const CuttingGroup& g, const GroupMotion& m,
                     std::vector<int>& chains, std::vector<int>& candidates) {
  const mesh::Box& box_W = m.region_W.box;
  if (grid.nearest_to_axis(box_W.lo.z(), box_W.hi.z()) > m.reach_W) return;
  HullFilter filter(g, m);
  grid.visit(m.region_W, chains,
             [&](const VertexGrid::Block& block) { filter.add_unclear(block, candidates); });
}

}  // namespace tdbd::rock
