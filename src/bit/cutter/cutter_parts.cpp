#include "bit/cutter/cutter_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bit/cutter/cutter_frame.hpp"
#include "bit/surface_of_revolution.hpp"
#include "core/angles.hpp"
#include "mesh/shape/clip_convex.hpp"

namespace tdbd::bit {
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

}  // namespace tdbd::bit
