#include "reference/literature/surface/planar_boolean.hpp"

#include <boost/polygon/polygon.hpp>
#include <cmath>
#include <stdexcept>

namespace tdbd::reference {
namespace {

namespace bp = boost::polygon;
using Point = bp::point_data<int>;
using Set = bp::polygon_set_data<int>;
using Face = bp::polygon_with_holes_data<int>;

constexpr double per_metre = 1.0 / planar_grid, farthest = 2.0;  // 1/m, m

int grid_number(double x) {
  if (!(std::abs(x) < farthest))
    throw std::invalid_argument("planar boolean: a coordinate is 2 m or farther from the origin");
  return static_cast<int>(std::lround(x * per_metre));
}

Vec2 metres(const Point& p) { return {p.x() / per_metre, p.y() / per_metre}; }

bp::polygon_data<int> on_integers(const Outline& outline) {
  std::vector<Point> points;
  points.reserve(outline.size());
  for (const Vec2& x : outline) points.emplace_back(grid_number(x.x()), grid_number(x.y()));
  bp::polygon_data<int> polygon;
  polygon.set(points.begin(), points.end());
  return polygon;
}

Set set_of(const PlanarRegion& region) {
  Set set;
  for (const PlanarFace& face : region) {
    set.insert(on_integers(face.border));
    for (const Outline& cavity : face.cavities) set.insert(on_integers(cavity), true);
  }
  return set;
}

template <class Polygon>
Outline outline_of(const Polygon& polygon) {
  Outline outline;
  for (auto p = polygon.begin(); p != polygon.end(); ++p)
    if (const Vec2 x = metres(*p); outline.empty() || x != outline.back()) outline.push_back(x);
  if (outline.size() > 1 && outline.front() == outline.back()) outline.pop_back();
  return outline;
}

PlanarRegion region_of(const Set& set) {
  std::vector<Face> faces;
  set.get(faces);
  PlanarRegion region;
  region.reserve(faces.size());
  for (const Face& f : faces) {
    PlanarFace face{outline_of(f), {}};
    for (auto hole = f.begin_holes(); hole != f.end_holes(); ++hole)
      face.cavities.push_back(outline_of(*hole));
    region.push_back(std::move(face));
  }
  return region;
}

}  // namespace

Vec2 on_grid(const Vec2& x) { return metres({grid_number(x.x()), grid_number(x.y())}); }

PlanarRegion without(const PlanarRegion& region, const Outline& tool) {
  return without_all(region, {tool});
}

PlanarRegion without_all(const PlanarRegion& region, const std::vector<Outline>& tools) {
  using namespace bp::operators;
  Set taken;
  for (const Outline& tool : tools) taken.insert(on_integers(tool));
  return region_of(set_of(region) - taken);
}

PlanarRegion within(const PlanarRegion& region, const Outline& window) {
  using namespace bp::operators;
  return region_of(set_of(region) & set_of({{window, {}}}));
}

}  // namespace tdbd::reference
