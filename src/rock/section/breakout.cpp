#include "rock/section/breakout.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bit/cutter/cutter.hpp"
#include "rock/cut/plane_strip.hpp"

namespace tdbd::rock {
namespace {

/// Dimensions of a prism beside a face over the cutter's diameter: its length along the path, the
/// largest rise of a crack in the plane of the face, and the height of the prism.
constexpr double prism_length = 0.1, most_rise = 0.5, prism_height = 0.75;

double sign_of(FaceSide side) { return side == FaceSide::left ? -1.0 : 1.0; }

FaceSide side_of(BreakoutPlace place) {
  return place == BreakoutPlace::left ? FaceSide::left : FaceSide::right;
}

/// A polygon, counter-clockwise seen from the rock ahead, extruded by a vector. Frame F.
mesh::TriangleMesh extended(const ConvexPolygon& polygon_F, const Vec3& by_F) {
  const int n = static_cast<int>(polygon_F.size());
  mesh::TriangleMesh m;
  for (const double share : {0.0, 1.0})
    for (const Vec2& x_F : polygon_F)
      m.positions.push_back(Vec3(0.0, x_F.x(), x_F.y()) + share * by_F);
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    m.triangles.push_back({i, next, n + next});
    m.triangles.push_back({i, n + next, n + i});
    if (i == 0 || next == 0) continue;
    m.triangles.push_back({0, next, i});
    m.triangles.push_back({n, n + i, n + next});
  }
  if (by_F.x() < 0.0)
    for (mesh::Triangle& t : m.triangles) std::swap(t[1], t[2]);
  return m;
}

/// The corner is at the origin, the crack rises outwards, and the other sides are vertical.
mesh::TriangleMesh prism(FaceSide side, double slope, double diameter) {
  const double rise = most_rise * diameter, out = sign_of(side) * rise * slope,
               top = prism_height * diameter;
  ConvexPolygon corners{{0.0, 0.0}, {out, rise}, {out, top}, {0.0, top}};
  if (side == FaceSide::left) std::reverse(corners.begin() + 1, corners.end());
  return extended(corners, {-prism_length * diameter, 0.0, 0.0});
}

/// The plane that bounds a prism outwards.
std::size_t outer_plane(const mesh::ConvexSolid& solid, FaceSide side) {
  const Vec3 out(0.0, sign_of(side), 0.0);
  std::size_t outer = 0;
  for (std::size_t i = 0; i < solid.planes; ++i)
    if (mesh::normal(solid, i).dot(out) > mesh::normal(solid, outer).dot(out)) outer = i;
  return outer;
}

/// Largest distances from the bit's axis and origin, for any position of the body's origin on the
/// outline, or raised by the outline's height.
void reach_from(const FaceOutline& face, const mesh::TriangleMesh& body_F, CuttingGroup& g) {
  std::vector<Vec3> origins_F;
  double low = 0.0, high = 0.0;
  for (const Vec2& x_F : face.rim_F) {
    origins_F.emplace_back(0.0, x_F.x(), x_F.y());
    low = std::min(low, x_F.y());
    high = std::max(high, x_F.y());
  }
  origins_F.emplace_back(0.0, 0.0, high - low);
  for (const Vec3& x_F : body_F.positions)
    for (const Vec3& origin_F : origins_F) {
      const Vec3 x_B = face.X_BF * Vec3(x_F + origin_F);
      g.reach = std::max(g.reach, x_B.head<2>().norm());
      g.distance = std::max(g.distance, x_B.norm());
    }
}

int face_of(const bit::Bit& bit, int cutter) {
  for (std::size_t p = 0; p < bit.parts.size(); ++p)
    if (bit.parts[p].cutter == cutter && bit.parts[p].kind == bit::PartKind::face)
      return static_cast<int>(p);
  return -1;
}

/// Prepares a group by way of a bit with one part.
CuttingGroup body_group(const bit::Bit& bit, int part, const FaceOutline& face,
                        const mesh::TriangleMesh& body_F, const CuttingOptions& options) {
  bit::Part body;
  body.name = bit.parts[at(part)].name + " (break-out)";
  body.kind = bit::PartKind::face;
  body.X_BP = face.X_BF;
  body.mesh_P = body_F;
  body.update_direction_B = bit.parts[at(part)].update_direction_B;
  bit::Bit alone;
  alone.parts.push_back(std::move(body));
  CuttingGroup g = std::move(prepare_cutting_bit(alone, options).groups.front());
  for (CuttingPart& p : g.parts) p.part = part;
  g.presence = GroupActivity::away;
  g.kind = GroupKind::breakout;
  reach_from(face, body_F, g);
  return g;
}

}  // namespace

ConvexPolygon lower_edge(const ConvexPolygon& rim_F, FaceSide side) {
  const auto low = std::ranges::min_element(
      rim_F, {}, [&](const Vec2& x) { return std::pair(x.y(), -sign_of(side) * x.x()); });
  ConvexPolygon edge;
  const std::size_t n = rim_F.size(), first = static_cast<std::size_t>(low - rim_F.begin());
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = side == FaceSide::right ? (first + k) % n : (first + n - k) % n;
    if (!edge.empty() && sign_of(side) * (rim_F[i].x() - edge.back().x()) <= 0.0) break;
    edge.push_back(rim_F[i]);
  }
  return edge;
}

double crack_slope(const Pose& X_BF, FaceSide side, const Vec3& along_B, const Vec3& normal_B,
                   double angle) {
  const Vec3 across_B = along_B.cross(normal_B);
  const Vec3 out_B = sign_of(side) * X_BF.R.col(1), up_B = X_BF.R.col(2);
  const double tangent = std::tan(angle), sideways = across_B.dot(out_B);
  const double flip = sideways < 0.0 ? -1.0 : 1.0;
  const double of_out = flip * sideways + tangent * normal_B.dot(out_B),
               of_up = -tangent * normal_B.dot(up_B) - flip * across_B.dot(up_B);
  return of_out > 0.0 ? of_up / of_out : -1.0;
}

std::vector<Breakout> add_breakouts(const bit::Bit& bit, const BreakoutFaces& faces,
                                    const CuttingOptions& options, CuttingBit& cutting) {
  std::erase_if(cutting.groups,
                [](const CuttingGroup& g) { return g.kind == GroupKind::breakout; });
  std::vector<Breakout> breakouts;
  for (std::size_t i = 0; i < faces.rules.size(); ++i) {
    const int cutter = static_cast<int>(i), part = face_of(bit, cutter);
    const FaceOutline& face = faces.outlines[i];
    if (!faces.rules[i] || part < 0 || face.rim_F.size() < 3 ||
        bit.parts[at(part)].cutting != bit::Cutting::cuts)
      continue;
    const BreakoutRule& rule = *faces.rules[i];
    const bit::Cutter& c = bit.cutters[i];
    const Vec3 along_B = bit::direction_of_motion_B(c);
    const auto add = [&](BreakoutPlace place, double slope, double share,
                         const mesh::TriangleMesh& body_F) {
      breakouts.push_back({cutter, place, cutting.groups.size(), face.X_BF,
                           lower_edge(face.rim_F, FaceSide::left),
                           lower_edge(face.rim_F, FaceSide::right), slope, share, c.diameter});
      cutting.groups.push_back(body_group(bit, part, face, body_F, options));
    };
    for (const BreakoutPlace place : {BreakoutPlace::left, BreakoutPlace::right}) {
      const FaceSide side = side_of(place);
      const double slope =
          crack_slope(face.X_BF, side, along_B, bit::profile_normal_B(c), rule.angle);
      if (rule.depth_share > 0.0 && slope > 0.0)
        add(place, slope, rule.depth_share, prism(side, slope, c.diameter));
    }
    if (rule.ahead_share > 0.0)
      add(BreakoutPlace::ahead, 0.0, rule.ahead_share,
          extended(face.rim_F, faces.ahead * (face.X_BF.R.transpose() * along_B)));
  }
  return breakouts;
}

std::optional<Vec2> crack_start(const Breakout& b, double end_z) {
  const FaceSide side = side_of(b.place);
  const ConvexPolygon& edge = side == FaceSide::left ? b.left_F : b.right_F;
  const double lowest = edge.front().y(), top = std::min(end_z, edge.back().y());
  const double start_z = top - b.share * (top - lowest);
  const auto reached = [&](const Vec2& x_F) { return sign_of(side) * x_F.x() - b.slope * x_F.y(); };
  std::optional<Vec2> start, end;
  const auto consider = [&](const Vec2& x_F) {
    if (!start || reached(x_F) > reached(*start)) start = x_F;
    end = x_F;
  };
  for (std::size_t i = 0; i < edge.size(); ++i) {
    if (edge[i].y() >= start_z && edge[i].y() <= top) consider(edge[i]);
    if (i + 1 == edge.size()) break;
    const Vec2 along = edge[i + 1] - edge[i];
    for (const double z : {start_z, top})
      if (edge[i].y() < z && z < edge[i + 1].y())
        consider(edge[i] + (z - edge[i].y()) / along.y() * along);
  }
  if (!start || !(reached(*start) > reached(*end))) return std::nullopt;
  return start;
}

namespace {

/// Ends a crack where it reaches the height of the free surface at the end of the engaged edge.
void end_crack(const Breakout& b, double rise, CuttingPart& prism) {
  const FaceSide side = side_of(b.place);
  const double most = most_rise * b.diameter;
  prism.solid_P.b[outer_plane(prism.solid_P, side)] = std::min(rise, most) * b.slope;
  prism.checksum = checksum(prism.solid_P);
}

}  // namespace

std::optional<double> raised_ahead(const Breakout& b, const EngagedEnds& ends) {
  if (!ends[0] && !ends[1]) return std::nullopt;
  const double lowest = b.left_F.front().y();
  const double top = std::max(ends[0].value_or(lowest), ends[1].value_or(lowest));
  return (1.0 - b.share) * (top - lowest);
}

void place_breakout(const Breakout& b, const EngagedEnds& ends, CuttingBit& cutting) {
  CuttingGroup& g = cutting.groups[b.group];
  std::optional<Vec2> origin_F;
  if (b.place == BreakoutPlace::ahead) {
    if (const auto raised = raised_ahead(b, ends)) origin_F = Vec2(0.0, *raised);
  } else if (const auto& end = ends[static_cast<std::size_t>(side_of(b.place))]) {
    origin_F = crack_start(b, *end);
    if (origin_F) end_crack(b, *end - origin_F->y(), g.parts.front());
  }
  g.presence = origin_F ? GroupActivity::there : GroupActivity::away;
  if (!origin_F) return;
  g.X_BP = b.X_BF * Pose{Mat3::Identity(), Vec3(0.0, origin_F->x(), origin_F->y())};
  g.X_BP1 = g.X_BP;
}

}  // namespace tdbd::rock
