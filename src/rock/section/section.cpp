#include "rock/section/section.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/types.hpp"

namespace tdbd::rock {
namespace {

double angle_of_attack(const Pose& X_BF, const rotation::Twist& twist, const Vec2& x_F) {
  const Vec3 v_B = rotation::velocity_B(twist, X_BF * Vec3(0.0, x_F.x(), x_F.y()));
  return std::asin(std::clamp(X_BF.R.col(0).dot(v_B) / v_B.norm(), -1.0, 1.0));
}

SpeedRange speed_range(const ConvexPolygon& outline_F, const ForwardSpeed& v) {
  SpeedRange range{INFINITY, -INFINITY};
  for (const Vec2& x_F : outline_F) {
    const double speed = v(x_F);
    range = {std::min(range.slowest, speed), std::max(range.fastest, speed)};
  }
  return range;
}

/// A face that plunges moves mostly along its own plane. Carried ahead by the whole lead, it would
/// be deep below the rock that it cuts. So it is carried ahead by 0.7 of the lead if X . v < 0.5
/// |v| at its middle, by the whole lead from 0.8 |v| on, and by a cubic blend in between.
double lead_of(const FaceColumns& columns, const Pose& X_BF, const ForwardSpeed& v,
               const rotation::Twist& twist, double lead) {
  constexpr double plunging = 0.5, cutting = 0.8, nearest = 0.7;
  const Vec2 middle_F = 0.5 * (columns.lo_F + columns.hi_F);
  const double speed =
      rotation::velocity_B(twist, X_BF * Vec3(0.0, middle_F.x(), middle_F.y())).norm();
  if (!(speed > 0.0)) return lead;
  const double s = std::clamp((v(middle_F) / speed - plunging) / (cutting - plunging), 0.0, 1.0);
  return lead * (nearest + (1.0 - nearest) * s * s * (3.0 - 2.0 * s));
}

/// The columns of the part that moves forwards; null if no part does. Uses the work's buffer if
/// that is not the whole face.
const FaceColumns* forward_columns(const SectionFace& face, const ForwardSpeed& v,
                                   const SpeedRange& range, SectionWork& w) {
  if (!(range.fastest > 0.0)) return nullptr;
  if (range.slowest >= 0.0) return &face.columns;
  const HalfPlane forwards{-v.gradient, v.at_origin};
  clip(face.outline.rim_F, forwards, w.forward_F);
  make_columns(w.forward_F, &forwards, w.forward);
  return w.forward.columns.empty() ? nullptr : &w.forward;
}

/// Whether the outline continues above the searched zone.
bool continues_above_zone(const OutlineSegment& s, const FacePlane& f) {
  const double top = f.face.hi_F.y() + 0.25 * f.reach;
  const auto is_over = [&](const Vec2& x_F) {
    return x_F.y() > top && x_F.x() > f.left && x_F.x() < f.right;
  };
  return is_over(s.from) || is_over(s.to);
}

/// Whether part of the columns may lie beside the segment, or below it.
bool concerns(const OutlineSegment& s, const FacePlane& f) {
  return std::max(s.from.y(), s.to.y()) > f.face.lo_F.y() &&
         std::max(s.from.x(), s.to.x()) > f.left && std::min(s.from.x(), s.to.x()) < f.right;
}

OutlineSegment segment(const OutlineWork& w, std::size_t k) {
  return {{w.y[k], w.z[k]}, {w.y[k + 1], w.z[k + 1]}};
}

bool is_seen(const FacePlane& plane, const OutlineWork& w) {
  if (std::ranges::find(w.place, PointPlace::inside, &PlacedPoint::place) != w.place.end())
    return true;
  return std::ranges::any_of(w.runs, [&](const OutlineRun& run) {
    for (std::size_t k = run.first; k + 1 < run.end; ++k)
      if (concerns(segment(w, k), plane)) return true;
    return false;
  });
}

/// Rock usually meets a face at its lower half, so that is searched first. If nothing is found
/// there, the search is repeated all around the face with twice the reach.
bool find_outline_around(const Rock& rock, FacePlane& plane, OutlineWork& outline) {
  find_outline(rock, plane, outline);
  if (is_seen(plane, outline)) return true;
  plane.reach *= 2.0;
  plane.top = plane.face.hi_F.y() + plane.reach;
  find_outline(rock, plane, outline);
  return is_seen(plane, outline);
}

/// A face of a moving bit.
struct FacePlace {
  const Pose &X_WB, &X_BF;
  const rotation::Twist& twist;
};

/// The number of consecutive points of a run, from index k on, that are inside the face.
std::size_t points_inside(const OutlineWork& w, std::size_t k, std::size_t end) {
  const std::size_t begin = k;
  while (k < end && w.place[k].place == PointPlace::inside) ++k;
  return k - begin;
}

void add_run(const FaceStrip& strip, const FacePlane& plane, const OutlineRun& run,
             SectionWork& w) {
  const OutlineWork& o = w.outline;
  for (std::size_t k = run.first; k + 1 < run.end;) {
    if (const std::size_t inside = points_inside(o, k, run.end); inside > 1) {
      add_inside(plane.face, std::span(o.y).subspan(k, inside), std::span(o.z).subspan(k, inside),
                 w.sums);
      k += inside - 1;
      continue;
    }
    const OutlineSegment s = segment(o, k);
    const bool adds = !is_beneath(o, k) && concerns(s, plane);
    ++k;
    if (!adds) continue;
    if (continues_above_zone(s, plane)) w.sight = OutlineStatus::over_the_top;
    add_segment(plane.face, strip.first, strip.end, s, w.sums);
  }
}

void add_strip(const Rock& rock, const FaceStrip& strip, FacePlane plane, SectionWork& w) {
  if (!find_outline_around(rock, plane, w.outline)) return;
  if (w.sight == OutlineStatus::none) w.sight = OutlineStatus::clear;
  for (const OutlineRun& run : w.outline.runs) add_run(strip, plane, run, w);
}

/// The engaged part of an edge of the outline: its middle and length.
struct EngagedEdge {
  Vec2 middle_F;
  double length;
};

EngagedEdge engaged_edge(const FaceColumns& face, std::size_t i, const ColumnSums& sums) {
  const std::size_t count = face.columns.size();
  const double length = static_cast<double>(sums.engaged[i]) / sums.per_length;
  const double along =
      static_cast<double>(sums.engaged_moment[i]) / sums.per_length_moment / length;
  const FaceColumn& c = face.columns[i < 2 * count ? i % count : i == 2 * count ? 0 : count - 1];
  // clamped because of rounding for short edges
  const double width = c.y1 - c.y0, dy = std::clamp(along, 0.0, width);
  if (i < count) return {{c.y0 + dy, c.lower + dy * c.lower_slope}, length};
  if (i < 2 * count) return {{c.y0 + dy, c.upper + dy * c.upper_slope}, length};
  const double y = i == 2 * count ? 0.0 : width;
  return {{c.y0 + y, c.lower + y * c.lower_slope + std::max(along, 0.0)}, length};
}

/// Adds the flat behind the engaged part of a lower edge, which is assumed to be one piece around
/// its middle.
void add_flat(const FlatBehind& flat, const FaceColumn& c, const EngagedEdge& e, FlatPiece& sum) {
  if (!(e.length > 0.0)) return;
  const double y = e.middle_F.x(), half = 0.5 * e.length / c.lower_length;
  const FlatPiece piece = flat_between(flat, std::max(c.y0, y - half), std::min(c.y1, y + half));
  sum.area += piece.area;
  sum.moment_F += piece.moment_F;
}

void measure_flat(const FaceColumns& face, const FlatBehind& flat, const Pose& X_BF,
                  const ColumnSums& sums, Section& s) {
  FlatPiece sum;
  for (std::size_t i = 0; i < face.columns.size(); ++i)
    if (sums.engaged[i] != 0) add_flat(flat, face.columns[i], engaged_edge(face, i, sums), sum);
  s.flat_area = sum.area;
  if (sum.area > 0.0) s.flat_centroid_B = X_BF * (sum.moment_F / sum.area);
}

void measure_edge(const FaceColumns& face, const Pose& X_BF, const rotation::Twist& twist,
                  const ColumnSums& sums, Section& s) {
  double attack = 0.0;
  Vec2 middle_F = Vec2::Zero();
  for (std::size_t i = 0; i < sums.engaged.size(); ++i) {
    if (sums.engaged[i] == 0) continue;
    const EngagedEdge e = engaged_edge(face, i, sums);
    s.engaged_edge += e.length;
    middle_F += e.length * e.middle_F;
    attack += e.length * angle_of_attack(X_BF, twist, e.middle_F);
  }
  if (!(s.engaged_edge > 0.0)) return;
  s.angle_of_attack = attack / s.engaged_edge;
  s.edge_centroid_B =
      X_BF * Vec3(0.0, middle_F.x() / s.engaged_edge, middle_F.y() / s.engaged_edge);
}

void measure_area(const Pose& X_BF, const rotation::Twist& twist, const ColumnSums& sums,
                  Section& s) {
  s.area = static_cast<double>(sums.area) / sums.per_area;
  if (!(s.area > 0.0)) return;
  const double per_area = sums.per_moment * s.area;
  s.centroid_B = X_BF * Vec3(0.0, static_cast<double>(sums.moment_y) / per_area,
                             static_cast<double>(sums.moment_z) / per_area);
  s.volume_rate = s.area * X_BF.R.col(0).dot(rotation::velocity_B(twist, s.centroid_B));
}

/// The section of the face, carried ahead by `times` the time of each of the work's strips.
Section section_ahead(const Rock& rock, const FaceColumns& columns, const FacePlace& face,
                      const FlatBehind& flat, const SectionPlace& place, double times,
                      SectionWork& work) {
  begin_sums(columns, work.sums);
  work.sight = OutlineStatus::none;
  const double middle = 0.5 * (columns.lo_F.y() + columns.hi_F.y());
  for (const FaceStrip& strip : work.strips)
    add_strip(rock, strip,
              face_plane(face.X_WB * rotation::carried(face.twist, times * strip.ahead) * face.X_BF,
                         columns, strip.first, strip.end, place.reach, middle, place.near_list),
              work);
  Section s;
  s.sight = work.sight;
  measure_area(face.X_BF, face.twist, work.sums, s);
  measure_edge(columns, face.X_BF, face.twist, work.sums, s);
  if (!flat.columns.columns.empty()) measure_flat(columns, flat, face.X_BF, work.sums, s);
  return s;
}

/// Extrapolates linearly from the values at one and at two leads to the face.
Section at_the_face(const Section& one, const Section& two) {
  Section s = one;
  s.area = 2.0 * one.area - two.area;
  s.flat_area = std::max(0.0, 2.0 * one.flat_area - two.flat_area);
  s.engaged_edge = 2.0 * one.engaged_edge - two.engaged_edge;
  if (!(s.area > 0.0) || !(s.engaged_edge > 0.0)) return {};
  s.volume_rate = std::max(0.0, 2.0 * one.volume_rate - two.volume_rate);
  s.centroid_B = 2.0 * one.centroid_B - two.centroid_B;
  s.edge_centroid_B = 2.0 * one.edge_centroid_B - two.edge_centroid_B;
  s.angle_of_attack =
      std::clamp(2.0 * one.angle_of_attack - two.angle_of_attack, -right_angle, right_angle);
  return s;
}

}  // namespace

SectionFace section_face(FaceOutline outline) {
  SectionFace face{std::move(outline), {}, {}};
  make_columns(face.outline.rim_F, nullptr, face.columns);
  return face;
}

Section section(const Rock& rock, const SectionFace& face, const Pose& X_WB,
                const rotation::Twist& twist, const SectionPlace& place, SectionWork& work) {
  const Pose& X_BF = face.outline.X_BF;
  const ForwardSpeed v = forward_speed(X_BF, twist);
  const SpeedRange range = speed_range(face.outline.rim_F, v);
  const FaceColumns* columns = forward_columns(face, v, range, work);
  work.measured = columns;
  if (columns == nullptr) {
    Section s;
    s.sight = OutlineStatus::none;
    return s;
  }
  face_strips(*columns, v, range, lead_of(*columns, X_BF, v, twist, place.lead),
              time_of_turn(twist, place.largest_turn), work.strips);
  const FacePlace moving{X_WB, X_BF, twist};
  const Section one = section_ahead(rock, *columns, moving, face.flat, place, 1.0, work);
  if (place.at_face == SectionAtFace::as_ahead || one.sight != OutlineStatus::clear ||
      !(one.area > 0.0))
    return one;
  const Section two = section_ahead(rock, *columns, moving, face.flat, place, 2.0, work);
  return two.sight == OutlineStatus::clear ? at_the_face(one, two) : one;
}

}  // namespace tdbd::rock
