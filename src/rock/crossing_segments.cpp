#include "rock/crossing_segments.hpp"

namespace tdbd::rock {

FacePlane face_plane(const Pose& X_WF, const Vec2& lo_F, const Vec2& hi_F, double longest_edge) {
  const Vec3 n_W = X_WF.R.col(0), y_W = X_WF.R.col(1), z_W = X_WF.R.col(2);
  return {n_W,  y_W,  z_W,         n_W.dot(X_WF.p), y_W.dot(X_WF.p), z_W.dot(X_WF.p),
          lo_F, hi_F, longest_edge};
}

Region region_ahead(const FacePlane& f) {
  const double rounding = 1e-9 * f.longest_edge, edge = f.longest_edge + rounding;
  Region region{};
  region.slabs[0] = {f.n_W, f.n0 - rounding, f.n0 + edge};
  region.slabs[1] = {f.y_W, f.y0 + f.lo_F.x() - edge, f.y0 + f.hi_F.x() + edge};
  region.slabs[2] = {f.z_W, f.z0 + f.lo_F.y() - edge, f.z0 + f.hi_F.y() + edge};
  Vec3 middle = Vec3::Zero(), half = Vec3::Zero();
  for (const Slab& s : region.slabs) {
    middle += 0.5 * (s.lo + s.hi) * s.n;
    half += 0.5 * (s.hi - s.lo) * s.n.cwiseAbs();
  }
  region.box.lo = middle - half;
  region.box.hi = middle + half;
  return region;
}

}  // namespace tdbd::rock
