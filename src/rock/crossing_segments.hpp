#pragma once

#include "rock/column_sums.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// A face's plane in space and the part of it that is asked for.
struct FacePlane {
  Vec3 n_W, y_W, z_W;   ///< axes of F; n into the rock ahead
  double n0, y0, z0;    ///< m, of F's origin along them
  Vec2 lo_F, hi_F;      ///< m
  double longest_edge;  ///< m

  double ahead(const Vec3& x_W) const { return n_W.dot(x_W) - n0; }
  Vec2 in_plane(const Vec3& x_W) const { return {y_W.dot(x_W) - y0, z_W.dot(x_W) - z0}; }
};

FacePlane face_plane(const Pose& X_WF, const Vec2& lo_F, const Vec2& hi_F, double longest_edge);

/// Whether a vertex can have an edge that crosses the plane in the part asked for, and lies ahead.
inline bool is_near(const FacePlane& f, const Vec3& x_W) {
  const double d = f.ahead(x_W);
  if (!(d >= 0.0 && d <= f.longest_edge)) return false;
  const Vec2 x_F = f.in_plane(x_W);
  return x_F.x() >= f.lo_F.x() - f.longest_edge && x_F.x() <= f.hi_F.x() + f.longest_edge &&
         x_F.y() >= f.lo_F.y() - f.longest_edge && x_F.y() <= f.hi_F.y() + f.longest_edge;
}

/// Where to look for those vertices.
Region region_ahead(const FacePlane& f);

/// Where the edge between a vertex ahead and one behind crosses. An edge gives its two triangles
/// the same point.
inline Vec2 crossing(const FacePlane& f, const Vec3& ahead_W, double d_ahead, const Vec3& behind_W,
                     double d_behind) {
  const double w = d_ahead / (d_ahead - d_behind);
  return f.in_plane(ahead_W + w * (behind_W - ahead_W));
}

/// Calls visit(segment) once for every triangle that crosses the plane in the part asked for. Each
/// has one edge that leads from a vertex ahead to one behind; it is found around the former.
/// Corners in the plane count as ahead.
template <class Visit>
void visit_crossings(const Rock& rock, const FacePlane& f, std::vector<int>& chains,
                     Visit&& visit) {
  const mesh::Surface& s = rock.surface;
  rock.grid.visit(region_ahead(f), chains, [&](const VertexGrid::Block& block) {
    for (std::size_t e = 0; e < static_cast<std::size_t>(block.count); ++e) {
      const Vec3& x_W = block.entries[e].x_W;
      if (!is_near(f, x_W)) continue;
      const double d = f.ahead(x_W);
      mesh::visit_corners(s, block.entries[e].v, [&](int c) {
        const Vec3& next_W = s.position(s.vertex(mesh::next_corner(c)));
        const double d_next = f.ahead(next_W);
        if (d_next >= 0.0) return;
        const Vec3& last_W = s.position(s.vertex(mesh::previous_corner(c)));
        const double d_last = f.ahead(last_W);
        visit({crossing(f, x_W, d, next_W, d_next),
               d_last >= 0.0 ? crossing(f, last_W, d_last, next_W, d_next)
                             : crossing(f, x_W, d, last_W, d_last)});
      });
    }
  });
}

}  // namespace tdbd::rock
