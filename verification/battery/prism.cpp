#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/battery/shapes.hpp"

namespace tdbd::battery {
namespace {

using Point2 = Eigen::Vector2d;

double turn(const Point2& a, const Point2& b, const Point2& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

bool covers(const Point2& a, const Point2& b, const Point2& c, const Point2& x) {
  return turn(a, b, x) >= 0.0 && turn(b, c, x) >= 0.0 && turn(c, a, x) >= 0.0;
}

/// Is corner i of the polygon `left` convex, with no other corner in the triangle that it cuts off?
bool is_ear(const std::vector<Point2>& p, const std::vector<int>& left, std::size_t i) {
  const std::size_t n = left.size();
  const int a = left[(i + n - 1) % n], b = left[i], c = left[(i + 1) % n];
  if (turn(p[a], p[b], p[c]) <= 0.0) return false;
  return std::none_of(left.begin(), left.end(), [&](int v) {
    return v != a && v != b && v != c && covers(p[a], p[b], p[c], p[v]);
  });
}

/// A simple counter-clockwise polygon in triangles, by cutting off ears.
std::vector<mesh::Triangle> ears(const std::vector<Point2>& p) {
  std::vector<int> left;
  for (int i = 0; i < static_cast<int>(p.size()); ++i) left.push_back(i);
  std::vector<mesh::Triangle> triangles;
  while (left.size() > 2) {
    std::size_t i = 0;
    while (i + 1 < left.size() && !is_ear(p, left, i)) ++i;
    const std::size_t n = left.size();
    triangles.push_back({left[(i + n - 1) % n], left[i], left[(i + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return triangles;
}

}  // namespace

mesh::TriangleMesh prism(const std::vector<Point2>& outline, double lo, double hi) {
  mesh::TriangleMesh m;
  const int n = static_cast<int>(outline.size());
  for (const double z : {lo, hi})
    for (const Point2& p : outline) m.positions.push_back({p.x(), p.y(), z});
  for (const auto& [a, b, c] : ears(outline)) {
    m.triangles.push_back({a, c, b});
    m.triangles.push_back({n + a, n + b, n + c});
  }
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    m.triangles.push_back({i, j, n + j});
    m.triangles.push_back({i, n + j, n + i});
  }
  return m;
}

std::vector<Point2> l_outline(double size, double arm) {
  const double h = 0.5 * size;
  return {{-h, -h}, {h, -h}, {h, arm - h}, {arm - h, arm - h}, {arm - h, h}, {-h, h}};
}

std::vector<Point2> u_outline(double size, double arm) {
  const double h = 0.5 * size;
  return {{-h, -h},           {h, -h},      {h, h}, {h - arm, h}, {h - arm, arm - h},
          {arm - h, arm - h}, {arm - h, h}, {-h, h}};
}

std::vector<Point2> star_outline(double outer, double inner, int points) {
  std::vector<Point2> outline;
  for (int i = 0; i < 2 * points; ++i) {
    const double phi = std::numbers::pi * i / points, r = i % 2 == 0 ? outer : inner;
    outline.push_back({r * std::cos(phi), r * std::sin(phi)});
  }
  return outline;
}

}  // namespace tdbd::battery
