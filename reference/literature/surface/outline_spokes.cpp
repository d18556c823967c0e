#include "reference/literature/surface/outline_spokes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/literature/surface/mesh_section.hpp"
#include "reference/literature/surface/planar_boolean.hpp"

namespace tdbd::reference {
namespace {

constexpr double least_depth = 2.0 * planar_grid;

SpokeFrame rounded(const SpokeFrame& frame) {
  const Vec2 corner = on_grid(Vec2(frame.radius, frame.floor));
  return {corner.x(), corner.y()};
}

/// Whether the line from a to b enters the convex outline deeper than least_depth.
bool enters(const Outline& tool, const Vec2& a, const Vec2& b) {
  double from = 0.0, to = 1.0;  // fractions of the line
  for (std::size_t i = 0; i < tool.size(); ++i) {
    const Vec2 edge = (tool[(i + 1) % tool.size()] - tool[i]).normalized(),
               inwards(-edge.y(), edge.x());
    const double at_a = inwards.dot(a - tool[i]) - least_depth,
                 at_b = inwards.dot(b - tool[i]) - least_depth;
    if (at_a <= 0.0 && at_b <= 0.0) return false;
    if (at_a < 0.0) from = std::max(from, at_a / (at_a - at_b));
    if (at_b < 0.0) to = std::min(to, at_a / (at_a - at_b));
  }
  return from < to;
}

bool meets(const Outline& tool, const Outline& surface) {
  for (std::size_t i = 0; i < surface.size(); ++i)
    if (enters(tool, surface[i], surface[(i + 1) % surface.size()])) return true;
  return false;
}

/// Whether the convex outline contains rock. If no line of the rock enters it, one point is tested.
bool meets(const Outline& tool, const PlanarFace& rock) {
  const Vec2 middle = (tool[0] + tool[1] + tool[2]) / 3.0;
  return meets(tool, rock.border) || encloses(rock, middle) ||
         std::ranges::any_of(rock.cavities, [&](const Outline& c) { return meets(tool, c); });
}

/// The piece with the frame's outer lower corner, or null.
const PlanarFace* held(const PlanarRegion& pieces, const SpokeFrame& frame) {
  for (const PlanarFace& face : pieces)
    if (std::ranges::find(face.border, Vec2(frame.radius, frame.floor)) != face.border.end())
      return &face;
  return nullptr;
}

double sector(const OutlineSpokes& rock) { return 2.0 * std::numbers::pi / rock.spokes(); }

/// Subtracts from one spoke what the tools enclose.
OutlineCut take_away(const OutlineSpokes& rock, PlanarFace& face,
                     const std::vector<Outline>& tools) {
  const PlanarRegion left = without_all({face}, tools);
  const double before = moment({face});
  const PlanarFace* const piece = held(left, rock.frame);
  const double after = piece ? moment({*piece}) : 0.0;
  face = piece ? respaced(*piece, rock.frame, rock.spacing) : PlanarFace{};
  return {sector(rock) * (before - after), sector(rock) * (moment({face}) - after)};
}

/// The deepest place of the rock's surface at a radius: the last crossing before the floor.
double deepest(const PlanarFace& face, const SpokeFrame& frame, double r) {
  double z = -INFINITY;
  const auto look = [&](const Outline& outline) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
      if ((a.x() > r) == (b.x() > r) || (a.y() == frame.floor && b.y() == frame.floor)) continue;
      z = std::max(z, std::lerp(a.y(), b.y(), (r - a.x()) / (b.x() - a.x())));
    }
  };
  look(face.border);
  for (const Outline& cavity : face.cavities) look(cavity);
  return z;
}

}  // namespace

OutlineSpokes flat_outline_spokes(const SpokeFrame& frame, double top, int spokes, double spacing) {
  const SpokeFrame f = rounded(frame);
  const double z = on_grid(Vec2(0.0, top)).y();
  const PlanarFace flat{{{0, z}, {f.radius, z}, {f.radius, f.floor}, {0, f.floor}}, {}};
  return {f, spacing,
          std::vector<PlanarFace>(static_cast<std::size_t>(spokes), respaced(flat, f, spacing))};
}

OutlineSpokes outline_spokes_of(const mesh::TriangleMesh& rock_W, const SpokeFrame& frame,
                                int spokes, double spacing) {
  OutlineSpokes rock{rounded(frame), spacing, {}};
  rock.rock.reserve(static_cast<std::size_t>(spokes));
  for (int k = 0; k < spokes; ++k)
    rock.rock.push_back(respaced(rock_section(rock_W, spoke_plane(k, spokes), rock.frame).front(),
                                 rock.frame, spacing));
  return rock;
}

OutlineCut cut_spoke(OutlineSpokes& rock, int spoke, const Outline& tool) {
  PlanarFace& face = rock.rock[static_cast<std::size_t>(spoke)];
  if (tool.empty() || !meets(tool, face)) return {};
  return take_away(rock, face, {tool});
}

void add_sections(SpokeSections& sections, const OutlineSpokes& rock,
                  const std::vector<SweptBody>& bodies, const Pose& X_WB) {
  sections.resize(rock.rock.size());
  std::vector<Vec3> corners_W;
  for (const SweptBody& body : bodies) {
    const Vec3 middle_W = X_WB * body.middle_B;
    corners_W.clear();
    for (const Vec3& x_B : body.corners_B) corners_W.push_back(X_WB * x_B);
    for (std::size_t k = 0; k < rock.rock.size(); ++k) {
      const SpokePlane plane = spoke_plane(static_cast<int>(k), rock.spokes());
      if (std::abs(plane.beside(middle_W)) >= body.reach) continue;
      if (plane.foot(middle_W).x() <= -body.reach) continue;
      Outline tool = section(body, corners_W, plane);
      if (!tool.empty() && meets(tool, rock.rock[k])) sections[k].push_back(std::move(tool));
    }
  }
}

OutlineCut cut_sections(OutlineSpokes& rock, SpokeSections& sections) {
  OutlineCut sum;
  for (std::size_t k = 0; k < sections.size(); ++k) {
    if (sections[k].empty()) continue;
    const OutlineCut cut = take_away(rock, rock.rock[k], sections[k]);
    sum.removed += cut.removed;
    sum.respaced += cut.respaced;
    sections[k].clear();
  }
  return sum;
}

OutlineCut cut_sweep(OutlineSpokes& rock, const std::vector<SweptBody>& bodies, const Pose& X_WB) {
  SpokeSections sections;
  add_sections(sections, rock, bodies, X_WB);
  return cut_sections(rock, sections);
}

double volume(const OutlineSpokes& rock) { return sector(rock) * moment(rock.rock); }

long nodes_within(const OutlineSpokes& rock, double radius) {
  long count = 0;
  const auto is_node = [&](const Vec2& x) { return x.x() < radius && x.y() < rock.frame.floor; };
  for (const PlanarFace& face : rock.rock) {
    count += std::ranges::count_if(face.border, is_node);
    for (const Outline& cavity : face.cavities) count += std::ranges::count_if(cavity, is_node);
  }
  return count;
}

Spokes deepest(const OutlineSpokes& rock, double radius, int nodes) {
  Spokes seen = flat_spokes(radius, 0.0, rock.spokes(), nodes);
  for (int k = 0; k < seen.spokes; ++k)
    for (int j = 0; j < nodes; ++j)
      seen.depth[static_cast<std::size_t>(k) * nodes + j] =
          deepest(rock.rock[static_cast<std::size_t>(k)], rock.frame, seen.node_radius(j));
  return seen;
}

}  // namespace tdbd::reference
