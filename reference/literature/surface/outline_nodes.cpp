#include "reference/literature/surface/outline_nodes.hpp"

#include <cmath>

#include "reference/literature/surface/planar_boolean.hpp"

namespace tdbd::reference {
namespace {

bool on_one_side(const SpokeFrame& f, const Vec2& a, const Vec2& b) {
  return (a.x() == 0.0 && b.x() == 0.0) || (a.x() == f.radius && b.x() == f.radius) ||
         (a.y() == f.floor && b.y() == f.floor);
}

bool is_on(const SpokeFrame& f, const Vec2& a) { return on_one_side(f, a, a); }

/// The change of area due to the removal of a node, m2; infinite if it must stay.
double cost_of_dropping(const SpokeFrame& f, double spacing, const Vec2& before, const Vec2& node,
                        const Vec2& after) {
  if (on_one_side(f, before, node) && on_one_side(f, node, after) && on_one_side(f, before, after))
    return 0.0;
  if (is_on(f, node)) return INFINITY;
  if ((node - before).norm() + (after - node).norm() > widest_spacing * spacing) return INFINITY;
  const Vec2 a = node - before, b = after - node;
  return std::abs(a.x() * b.y() - a.y() * b.x()) / 2.0;
}

/// The node whose removal changes the area least; the number of nodes if none may be removed.
std::size_t cheapest(const Outline& outline, const SpokeFrame& f, double spacing) {
  const std::size_t n = outline.size();
  std::size_t best = n;
  double least = INFINITY;
  for (std::size_t i = 0; i < n; ++i) {
    const double cost =
        cost_of_dropping(f, spacing, outline[(i + n - 1) % n], outline[i], outline[(i + 1) % n]);
    if (cost < least) least = cost, best = i;
  }
  return best;
}

Outline respaced(Outline outline, const SpokeFrame& f, double spacing) {
  for (std::size_t i; (i = cheapest(outline, f, spacing)) < outline.size();)
    outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(i));
  Outline even;
  even.reserve(2 * outline.size());
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    even.push_back(a);
    if (on_one_side(f, a, b)) continue;
    const int parts = static_cast<int>(std::ceil((b - a).norm() / (widest_spacing * spacing)));
    for (int k = 1; k < parts; ++k) even.push_back(on_grid(a + (b - a) * k / parts));
  }
  return even;
}

}  // namespace

PlanarFace respaced(const PlanarFace& face, const SpokeFrame& frame, double spacing) {
  PlanarFace even{respaced(face.border, frame, spacing), {}};
  for (const Outline& cavity : face.cavities)
    if (Outline c = respaced(cavity, frame, spacing); c.size() >= 3) even.cavities.push_back(c);
  return even;
}

}  // namespace tdbd::reference
