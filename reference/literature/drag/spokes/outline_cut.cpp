#include "reference/literature/drag/spokes/outline_cut.hpp"

#include <algorithm>
#include <cmath>

#include "reference/literature/surface/planar_boolean.hpp"

namespace tdbd::reference {
namespace {

constexpr double grazing = 2.0 * planar_grid;  // m

struct PlanarBox {
  Vec2 lo, hi;
};

PlanarBox box_of(const Outline& outline) {
  PlanarBox b{outline.front(), outline.front()};
  for (const Vec2& x : outline) {
    b.lo = b.lo.cwiseMin(x);
    b.hi = b.hi.cwiseMax(x);
  }
  return b;
}

bool apart(const PlanarBox& box, const Vec2& a, const Vec2& b) {
  return std::max(a.x(), b.x()) < box.lo.x() || std::min(a.x(), b.x()) > box.hi.x() ||
         std::max(a.y(), b.y()) < box.lo.y() || std::min(a.y(), b.y()) > box.hi.y();
}

/// Where an edge of the rock's border enters or leaves the tool, and the tool's edge there.
struct BorderCrossing {
  std::size_t border_edge = 0, tool_edge = 0;
  Vec2 x = Vec2::Zero();
};

/// The part of an edge inside the tool: fractions of the edge, and the tool's edges at both ends.
struct EdgeInTool {
  double from = 0.0, to = 1.0;
  std::size_t by_from = 0, by_to = 0;
  bool enters = false, leaves = false;
};

EdgeInTool in_tool(const Outline& tool, const Vec2& a, const Vec2& b) {
  EdgeInTool part;
  for (std::size_t i = 0, n = tool.size(); i < n; ++i) {
    const Vec2 edge = tool[i + 1 < n ? i + 1 : 0] - tool[i];
    const double margin = grazing * edge.norm();
    const auto inside = [&](const Vec2& x) {
      return edge.x() * (x.y() - tool[i].y()) - edge.y() * (x.x() - tool[i].x()) - margin;
    };
    const double at_a = inside(a), at_b = inside(b);
    if (at_a < 0.0 && at_b < 0.0) return {1.0, 0.0};
    if (at_a < 0.0) {
      part.enters = true;
      if (const double s = at_a / (at_a - at_b); s > part.from) part.from = s, part.by_from = i;
    } else if (at_b < 0.0) {
      part.leaves = true;
      if (const double s = at_a / (at_a - at_b); s < part.to) part.to = s, part.by_to = i;
    }
  }
  return part;
}

/// All places where the border enters and leaves. Stops counting after more than one of each.
struct Crossings {
  BorderCrossing in, out;
  int entries = 0, exits = 0;
};

Crossings border_crossings(const Outline& border, const Outline& tool, const PlanarBox& box) {
  Crossings found;
  for (std::size_t i = 0, n = border.size(); i < n; ++i) {
    const Vec2 &a = border[i], &b = border[i + 1 < n ? i + 1 : 0];
    if (apart(box, a, b)) continue;
    const EdgeInTool part = in_tool(tool, a, b);
    if (part.from >= part.to) continue;
    if (part.enters && ++found.entries == 1)
      found.in = {i, part.by_from, on_grid(a + part.from * (b - a))};
    if (part.leaves && ++found.exits == 1)
      found.out = {i, part.by_to, on_grid(a + part.to * (b - a))};
  }
  return found;
}

/// The tool's corners from where the border enters to where it leaves, against the tool's
/// direction.
void add_arc(Outline& border, const Outline& tool, const Crossings& c) {
  const std::size_t n = tool.size();
  const Vec2& corner = tool[c.in.tool_edge];
  const bool direct = c.in.tool_edge == c.out.tool_edge &&
                      (c.out.x - corner).squaredNorm() < (c.in.x - corner).squaredNorm();
  if (direct) return;
  for (std::size_t i = c.in.tool_edge;; i = (i + n - 1) % n) {
    border.push_back(tool[i]);
    if (i == (c.out.tool_edge + 1) % n) return;
  }
}

void add_apart(Outline& border, const Vec2& x) {
  if (border.empty() || border.back() != x) border.push_back(x);
}

}  // namespace

bool cut_between_two_crossings(PlanarFace& rock, const Outline& tool) {
  const PlanarBox box = box_of(tool);
  for (const Outline& cavity : rock.cavities) {
    const PlanarBox hole = box_of(cavity);
    if (!apart(box, hole.lo, hole.hi)) return false;
  }
  const Crossings c = border_crossings(rock.border, tool, box);
  if (c.entries != 1 || c.exits != 1 || c.in.x == c.out.x) return false;
  thread_local Outline border;
  border.clear();
  border.push_back(c.out.x);
  const std::size_t n = rock.border.size();
  for (std::size_t i = (c.out.border_edge + 1) % n;; i = (i + 1) % n) {
    add_apart(border, rock.border[i]);
    if (i == c.in.border_edge) break;
  }
  add_apart(border, c.in.x);
  add_arc(border, tool, c);
  if (border.back() == border.front()) border.pop_back();
  if (!(signed_area(border) > 0.0)) return false;
  std::swap(rock.border, border);
  return true;
}

void cut_convex(OutlineSpokes& rock, int spoke, const Outline& tool) {
  PlanarFace& face = rock.rock[at(spoke)];
  if (cut_between_two_crossings(face, tool)) {
    face = respaced(face, rock.frame, rock.spacing);
    return;
  }
  cut_spoke(rock, spoke, tool);
  if (signed_area(face.border) < 0.0) std::ranges::reverse(face.border);
}

}  // namespace tdbd::reference
