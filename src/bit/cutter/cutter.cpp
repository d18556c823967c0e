#include "bit/cutter/cutter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bit/bit.hpp"
#include "core/types.hpp"
#include "mesh/measures.hpp"
#include "mesh/shape/convex.hpp"

namespace tdbd::bit {
namespace {

Vec3 radial_B(const Cutter& c) { return {std::cos(c.azimuth), std::sin(c.azimuth), 0.0}; }

}  // namespace

Vec3 direction_of_motion_B(const Cutter& c) {
  return {-std::sin(c.azimuth), std::cos(c.azimuth), 0.0};
}

double land_depth(const Cutter& c) { return c.land > 0.0 ? c.land / std::tan(c.land_angle) : 0.0; }

double chamfer_depth(const Cutter& c) {
  return c.chamfer / std::tan(c.chamfer_angle) + land_depth(c);
}

Vec3 tip_C(const Cutter& c) {
  return {c.chamfer > 0.0 ? -chamfer_depth(c) : 0.0, 0.0, -0.5 * c.diameter};
}

Vec3 tip_B(const Cutter& c) { return c.tip_radius * radial_B(c) - c.tip_height * Vec3::UnitZ(); }

Vec3 profile_normal_B(const Cutter& c) {
  return std::sin(c.profile_angle) * radial_B(c) + std::cos(c.profile_angle) * Vec3::UnitZ();
}

Pose cutter_pose(const Cutter& c) {
  const Vec3 t = direction_of_motion_B(c), n = profile_normal_B(c);
  const double cb = std::cos(c.back_rake), sb = std::sin(c.back_rake);
  const double cs = std::cos(c.side_rake), ss = std::sin(c.side_rake);
  const Vec3 x = cb * t + sb * n, z = sb * t - cb * n, y = z.cross(x);
  Pose X_BC;
  X_BC.R.col(0) = cs * x + ss * y;
  X_BC.R.col(1) = cs * y - ss * x;
  X_BC.R.col(2) = z;
  X_BC.p = tip_B(c) - X_BC.R * tip_C(c);
  return X_BC;
}

namespace {

double widest(const std::vector<std::vector<Vec3>>& outlines) {
  double r = 0.0;
  for (const auto& outline : outlines)
    for (const Vec3& p : outline) r = std::max(r, p.x());
  return r;
}

/// The deepest points of a closed outline at the columns' centres.
std::vector<RimReach> reaches(const std::vector<Vec3>& outline, std::size_t columns, double width) {
  std::vector<RimReach> deepest(columns);
  for (std::size_t k = 0; k < outline.size(); ++k) {
    Vec3 a = outline[k], b = outline[(k + 1) % outline.size()];
    if (a.x() > b.x()) std::swap(a, b);
    const auto first = static_cast<std::size_t>(std::ceil(std::max(0.0, a.x() / width - 0.5)));
    for (std::size_t i = first; i < columns; ++i) {
      const double r = (static_cast<double>(i) + 0.5) * width;
      if (r >= b.x()) break;
      const Vec3 p = a + (r - a.x()) / (b.x() - a.x()) * (b - a);
      if (p.z() > deepest[i].z) deepest[i] = {p.z(), p.y()};
    }
  }
  return deepest;
}

}  // namespace

std::vector<Vec3> turned_outline(const Cutter& c, int points) {
  const Vec3 tip = tip_C(c), n_B = profile_normal_B(c);
  std::vector<Vec3> outline;
  for (int k = 0; k < points; ++k) {
    const double a = full_turn * k / points;
    Vec3 x_B = c.X_BC * Vec3(tip.x(), tip.z() * std::sin(a), tip.z() * std::cos(a));
    const double beyond = n_B.dot(x_B - tip_B(c)) + c.wear;
    if (beyond > 0.0) x_B -= beyond * n_B;
    const double azimuth = std::remainder(std::atan2(x_B.y(), x_B.x()) - c.azimuth, full_turn);
    outline.emplace_back(std::hypot(x_B.x(), x_B.y()), c.azimuth + azimuth, x_B.z());
  }
  return outline;
}

RimReaches rim_reaches(const std::vector<Cutter>& cutters, double column_width) {
  std::vector<std::vector<Vec3>> outlines;
  outlines.reserve(cutters.size());
  for (const Cutter& c : cutters) outlines.push_back(turned_outline(c, rim_points));
  const double end = widest(outlines);
  const auto columns = static_cast<std::size_t>(std::ceil(end / column_width));
  RimReaches rims{{}, end / static_cast<double>(columns)};
  rims.of_cutter.reserve(outlines.size());
  for (const auto& outline : outlines)
    rims.of_cutter.push_back(reaches(outline, columns, rims.width));
  return rims;
}

namespace {

constexpr int fewest_segments = 8;
constexpr double radial_to_rim_edge = 1.2;  ///< depth of a ring of triangles over their base

int segments_for(double radius, double edge) {
  return std::max(fewest_segments, static_cast<int>(std::lround(full_turn * radius / edge)));
}

int rim_count(const Cutter& c, const CutterMeshing& m) {
  return m.grading == Grading::graded ? m.rim_segments
                                      : segments_for(0.5 * c.diameter, m.uniform_edge);
}

/// Rings of a disc from its rim to its centre. Their counts are halved as long as possible.
std::vector<Ring> graded_disc(const Ring& rim) {
  std::vector<Ring> rings{rim};
  for (Ring next = rim; next.count % 2 == 0 && next.count / 2 >= fewest_segments;) {
    next.radius *= 1.0 - radial_to_rim_edge * full_turn / next.count;
    next.count /= 2;
    rings.push_back(next);
  }
  rings.push_back({0.0, rim.x, 1});
  return rings;
}

/// Rings of a disc from its rim to its centre, about one edge length apart.
std::vector<Ring> uniform_disc(const Ring& rim, double edge) {
  std::vector<Ring> rings{rim};
  const int steps = std::max(1, static_cast<int>(std::lround(rim.radius / edge)));
  for (int k = steps - 1; k > 0; --k) {
    const double radius = rim.radius * k / steps;
    rings.push_back({radius, rim.x, std::min(rim.count, segments_for(radius, edge))});
  }
  rings.push_back({0.0, rim.x, 1});
  return rings;
}

std::vector<Ring> disc(const Ring& rim, const CutterMeshing& m) {
  return m.grading == Grading::graded ? graded_disc(rim) : uniform_disc(rim, m.uniform_edge);
}

/// Frustum (a cylinder if the radii are equal) between the rims `front` and `back`, front.x >
/// back.x.
mesh::TriangleMesh frustum(const Ring& front, const Ring& back, const CutterMeshing& m) {
  std::vector<Ring> rings = disc(front, m);
  std::reverse(rings.begin(), rings.end());
  const double slant = std::hypot(front.x - back.x, front.radius - back.radius);
  const int steps =
      m.grading == Grading::graded ? 1 : std::max(1, static_cast<int>(slant / m.uniform_edge));
  for (int k = 1; k < steps; ++k) {
    const double w = static_cast<double>(k) / steps;
    rings.push_back(
        {std::lerp(front.radius, back.radius, w), std::lerp(front.x, back.x, w), front.count});
  }
  const std::vector<Ring> back_disc = disc(back, m);
  rings.insert(rings.end(), back_disc.begin(), back_disc.end());
  return surface_of_revolution(rings);
}

Part cutter_part(const Cutter& c, const char* name, PartKind kind, double density,
                 mesh::TriangleMesh mesh_P) {
  Part part;
  part.name = fmt::format("cutter-{}/{}", c.id, name);
  part.kind = kind;
  part.X_BP = c.X_BC;
  part.mesh_P = std::move(mesh_P);
  part.density = density;
  return part;
}

/// Removes the material beyond the wear flat.
void wear_down(const Cutter& c, std::vector<Part>& parts) {
  const Vec3 n_C = c.X_BC.R.transpose() * profile_normal_B(c);
  const double limit = n_C.dot(tip_C(c)) - c.wear;
  for (Part& part : parts) part.mesh_P = mesh::clipped_convex(part.mesh_P, n_C, limit);
  std::erase_if(parts, [](const Part& part) { return part.mesh_P.triangles.empty(); });
}

}  // namespace

std::vector<Part> cutter_parts(const Cutter& c, const CutterMeshing& m) {
  const int n = rim_count(c, m);
  const bool chamfered = c.chamfer > 0.0;
  const double outer = 0.5 * c.diameter, middle = outer - c.chamfer, inner = middle - c.land;
  const double back_of_face = chamfered ? -chamfer_depth(c) : -c.table_thickness;
  std::vector<Part> parts;
  parts.push_back(cutter_part(c, "face", PartKind::face, chamfered ? 0.0 : table_density,
                              frustum({inner, 0.0, n}, {inner, back_of_face, n}, m)));
  const double back_of_land = -land_depth(c);
  if (c.land > 0.0)
    parts.push_back(cutter_part(c, "land", PartKind::chamfer, table_density,
                                frustum({inner, 0.0, n}, {middle, back_of_land, n}, m)));
  if (chamfered)
    parts.push_back(cutter_part(c, "chamfer", PartKind::chamfer, table_density,
                                frustum({middle, back_of_land, n}, {outer, back_of_face, n}, m)));
  parts.push_back(cutter_part(c, "body", PartKind::cutter_body, carbide_density,
                              frustum({outer, back_of_face, n}, {outer, -c.length, n}, m)));
  if (c.wear > 0.0) wear_down(c, parts);
  return parts;
}

namespace {

constexpr int most_turns = 1000;

Vec3 centre_B(const Cutter& c) { return c.X_BC * Vec3(-0.5 * c.length, 0.0, 0.0); }

double bounding_radius(const Cutter& c) { return 0.5 * std::hypot(c.length, c.diameter); }

/// The point of the cutter's cylinder that is nearest to x_B.
Vec3 nearest_B(const Cutter& c, const Vec3& x_B) {
  Vec3 x_C = c.X_BC.R.transpose() * (x_B - c.X_BC.p);
  x_C.x() = std::clamp(x_C.x(), -c.length, 0.0);
  const double radius = std::hypot(x_C.y(), x_C.z());
  if (radius > 0.5 * c.diameter) x_C.tail<2>() *= 0.5 * c.diameter / radius;
  return c.X_BC * x_C;
}

/// How far the cylinder extends along the unit vector d_B.
double reach_along(const Cutter& c, const Vec3& d_B) {
  const double along = c.X_BC.R.col(0).dot(d_B);
  const double across = std::sqrt(std::max(0.0, 1.0 - along * along));
  return d_B.dot(centre_B(c)) + 0.5 * c.length * std::abs(along) + 0.5 * c.diameter * across;
}

}  // namespace

bool closer_than(const Cutter& a, const Cutter& b, double clearance) {
  const double centres = (centre_B(a) - centre_B(b)).norm();
  if (centres >= bounding_radius(a) + bounding_radius(b) + clearance) return false;
  Vec3 in_a = centre_B(a);
  for (int turn = 0; turn < most_turns; ++turn) {
    const Vec3 in_b = nearest_B(b, in_a);
    in_a = nearest_B(a, in_b);
    const double distance = (in_a - in_b).norm();
    if (distance < clearance) return true;
    const Vec3 d = (in_b - in_a) / distance;
    if (-reach_along(b, -d) - reach_along(a, d) >= clearance) return false;
  }
  return true;
}

namespace {

constexpr double touching = 1e-6;     ///< m: cutters farther apart share no volume
constexpr double least_share = 1e-9;  ///< times a part's volume: less is rounding

/// A part of a cutter in the bit frame.
struct Piece {
  mesh::TriangleMesh surface;
  mesh::ConvexSolid solid;
};

std::vector<std::vector<Piece>> pieces_of(const Bit& bit) {
  std::vector<std::vector<Piece>> pieces(bit.cutters.size());
  for (const Part& part : bit.parts) {
    if (part.cutter < 0 || part.density <= 0.0) continue;
    mesh::TriangleMesh m = mesh_B(part);
    if (const auto solid = mesh::convex_solid(m))
      pieces[static_cast<std::size_t>(part.cutter)].push_back({std::move(m), *solid});
  }
  return pieces;
}

double common_volume(const Piece& a, const Piece& b) {
  if (!mesh::bounding_box(a.surface).overlaps(mesh::bounding_box(b.surface))) return 0.0;
  mesh::TriangleMesh m = a.surface;
  for (std::size_t i = 0; i < b.solid.planes && !m.triangles.empty(); ++i)
    m = mesh::clipped_convex(m, mesh::normal(b.solid, i), b.solid.b[i]);
  if (m.triangles.empty()) return 0.0;
  const double volume = mesh::enclosed_volume(m);
  return volume > least_share * mesh::enclosed_volume(a.surface) ? volume : 0.0;
}

}  // namespace

std::vector<CutterOverlap> cutter_overlaps(const Bit& bit) {
  const std::vector<std::vector<Piece>> pieces = pieces_of(bit);
  std::vector<CutterOverlap> overlaps;
  for (std::size_t a = 0; a < pieces.size(); ++a)
    for (std::size_t b = a + 1; b < pieces.size(); ++b) {
      if (!closer_than(bit.cutters[a], bit.cutters[b], touching)) continue;
      CutterOverlap o{static_cast<int>(a), static_cast<int>(b), 0.0};
      for (const Piece& of_a : pieces[a])
        for (const Piece& of_b : pieces[b]) o.volume += common_volume(of_a, of_b);
      if (o.volume > 0.0) overlaps.push_back(o);
    }
  return overlaps;
}

}  // namespace tdbd::bit
