#include "rock/section.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "rock/face_strips.hpp"

namespace tdbd::rock {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A piece of the rock's outline in the plane of the face, rock on its left.
struct OutlineSegment {
  Vec2 from, to;
};

Vec2 crossing(const Vec3& ahead, const Vec3& behind) {
  const double w = ahead.x() / (ahead.x() - behind.x());
  return ahead.tail<2>() + w * (behind - ahead).tail<2>();
}

/// Where a triangle, in the face's frame, crosses the face's plane. Corners in the plane count as
/// ahead, and an edge gives its two triangles the same point.
std::optional<OutlineSegment> crossing_segment(const std::array<Vec3, 3>& q_F) {
  const auto ahead = [&](std::size_t i) { return q_F[i % 3].x() >= 0.0; };
  std::optional<Vec2> from, to;
  for (std::size_t i = 0; i < 3; ++i) {
    if (ahead(i) && !ahead(i + 1)) from = crossing(q_F[i], q_F[(i + 1) % 3]);
    if (!ahead(i) && ahead(i + 1)) to = crossing(q_F[(i + 1) % 3], q_F[i]);
  }
  if (!from || !to) return {};
  return OutlineSegment{*from, *to};
}

/// Whether anything of the strip can lie beside the segment.
bool is_beside(const OutlineSegment& s, const FaceStrip& strip) {
  return std::max(s.from.x(), s.to.x()) > strip.lo_F.x() &&
         std::min(s.from.x(), s.to.x()) < strip.hi_F.x() &&
         std::max(s.from.y(), s.to.y()) > strip.lo_F.y() && s.from.x() != s.to.x();
}

/// The half-planes beside a segment, on its -Z side; and the sign of what lies there.
struct Beside {
  std::array<HalfPlane, 3> bounds;
  double sign;
};

Beside beside(const OutlineSegment& s) {
  const bool rock_is_below = s.from.x() > s.to.x();
  const Vec2 &left = rock_is_below ? s.to : s.from, &right = rock_is_below ? s.from : s.to;
  const Vec2 above(left.y() - right.y(), right.x() - left.x());
  return {{HalfPlane{-Vec2::UnitX(), -left.x()}, HalfPlane{Vec2::UnitX(), right.x()},
           HalfPlane{above, above.dot(left)}},
          rock_is_below ? 1.0 : -1.0};
}

/// Length of the part of the edge p q in all of these half-planes.
double length_inside(const Vec2& p, const Vec2& q, const std::array<HalfPlane, 3>& bounds) {
  if (std::max(p.x(), q.x()) <= -bounds[0].b || std::min(p.x(), q.x()) >= bounds[1].b) return 0.0;
  double first = 0.0, last = 1.0;
  for (const HalfPlane& h : bounds) {
    const double out_p = h.n.dot(p) - h.b, out_q = h.n.dot(q) - h.b;
    if (out_p > 0.0 && out_q > 0.0) return 0.0;
    if (out_p > 0.0) first = std::max(first, out_p / (out_p - out_q));
    if (out_q > 0.0) last = std::min(last, out_p / (out_p - out_q));
  }
  return std::max(0.0, last - first) * (q - p).norm();
}

/// Sums over segments. Edges: those of the outline, not of the strips.
struct Sums {
  PolygonMoments rock;
  double engaged_edge = 0.0, attack = 0.0;  ///< m; m rad
};

/// One face with its room.
struct Work {
  const Rock& rock;
  const FaceOutline& face;
  const Twist& twist;
  std::vector<int> chains, triangles;
  ConvexPolygon half, strip, left;
};

double angle_of_attack(const Work& w, const Vec2& x_F) {
  const Vec3 v_B = velocity_B(w.twist, w.face.X_BF * Vec3(0.0, x_F.x(), x_F.y()));
  return std::asin(std::clamp(w.face.X_BF.R.col(0).dot(v_B) / v_B.norm(), -1.0, 1.0));
}

void add_area(Work& w, const FaceStrip& strip, const Beside& b, Sums& sums) {
  clip(strip.outline_F, b.bounds[0], w.half);
  clip(w.half, b.bounds[1], w.strip);
  clip(w.strip, b.bounds[2], w.left);
  const PolygonMoments m = moments(w.left);
  sums.rock.area += b.sign * m.area;
  sums.rock.moment += b.sign * m.moment;
}

void add_edges(const Work& w, const FaceStrip& strip, const Beside& b, Sums& sums) {
  for (const RimEdge& e : strip.rim_F) {
    const double length = b.sign * length_inside(e.from, e.to, b.bounds);
    if (length == 0.0) continue;
    sums.engaged_edge += length;
    sums.attack += length * angle_of_attack(w, 0.5 * (e.from + e.to));
  }
}

bool crosses(const mesh::Surface& rock, int t, const Vec3& n_W, double b) {
  return std::ranges::any_of(rock.triangles[at(t)],
                             [&](int v) { return n_W.dot(rock.position(v)) < b; });
}

/// The triangles that cross the strip's plane, all that do so within its outline, in the order of
/// their slots. Each has a vertex ahead of the plane.
void find_triangles(const FaceStrip& strip, const Pose& X_WF, double longest_edge, Work& w) {
  Region region{};
  const Vec3 n_W = X_WF.R.col(0);
  const double b = n_W.dot(X_WF.p), rounding = 1e-9 * longest_edge;
  region.slabs[0] = {n_W, b - rounding, b + longest_edge};
  for (const Vec2& x_F : strip.outline_F) region.box.add(X_WF * Vec3(0.0, x_F.x(), x_F.y()));
  region.box.lo.array() -= longest_edge;
  region.box.hi.array() += longest_edge;
  w.triangles.clear();
  w.rock.grid.visit(region, w.chains, [&](const VertexGrid::Block& block) {
    for (int s = 0; s < block.count; ++s) {
      const int v = block.v[at(s)];
      if (n_W.dot(w.rock.surface.position(v)) < b - rounding) continue;
      mesh::visit_corners(w.rock.surface, v, [&](int c) {
        if (crosses(w.rock.surface, c / 3, n_W, b + rounding)) w.triangles.push_back(c / 3);
      });
    }
  });
  std::ranges::sort(w.triangles);
  w.triangles.erase(std::ranges::unique(w.triangles).begin(), w.triangles.end());
}

void add_strip(const FaceStrip& strip, const Pose& X_WF, double longest_edge, Work& w, Sums& sums) {
  find_triangles(strip, X_WF, longest_edge, w);
  const Pose X_FW = inverse(X_WF);
  for (const int t : w.triangles) {
    const mesh::Triangle& corners = w.rock.surface.triangles[at(t)];
    const auto q_F = [&](std::size_t i) { return X_FW * w.rock.surface.position(corners[i]); };
    const auto segment = crossing_segment({q_F(0), q_F(1), q_F(2)});
    if (!segment || !is_beside(*segment, strip)) continue;
    const Beside b = beside(*segment);
    add_area(w, strip, b, sums);
    add_edges(w, strip, b, sums);
  }
}

}  // namespace

Section section(const Rock& rock, const FaceOutline& face, const Pose& X_WB, const Twist& twist,
                const SectionPlace& place) {
  Work w{rock, face, twist, {}, {}, {}, {}, {}};
  Sums sums;
  for (const FaceStrip& strip : face_strips(face, twist, place.lead, place.largest_turn))
    add_strip(strip, X_WB * carried(twist, strip.ahead) * face.X_BF, place.longest_edge, w, sums);
  Section s;
  s.area = sums.rock.area;
  s.engaged_edge = sums.engaged_edge;
  if (s.area > 0.0) {
    const Vec2 x_F = sums.rock.moment / s.area;
    s.centroid_B = face.X_BF * Vec3(0.0, x_F.x(), x_F.y());
    s.volume_rate = s.area * face.X_BF.R.col(0).dot(velocity_B(twist, s.centroid_B));
  }
  if (s.engaged_edge > 0.0) s.angle_of_attack = sums.attack / s.engaged_edge;
  return s;
}

}  // namespace tdbd::rock
