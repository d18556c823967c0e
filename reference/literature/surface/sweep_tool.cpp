#include "reference/literature/surface/sweep_tool.hpp"

#include <algorithm>
#include <cmath>

#include "reference/mesh/convex_hull.hpp"

namespace tdbd::reference {
namespace {

/// All corners of a cutter's cutting parts, bit frame.
std::vector<Vec3> corners_B(const bit::Bit& bit, int cutter) {
  std::vector<Vec3> corners;
  for (const bit::Part& part : bit.parts)
    if (part.cutter == cutter && part.cutting == bit::Cutting::cuts)
      for (const Vec3& x_P : part.mesh_P.positions) corners.push_back(part.X_BP * x_P);
  return corners;
}

/// Twice the area projected along z, positive if the triangle faces down.
double doubled_plan_area(const mesh::TriangleMesh& m, const mesh::Triangle& t) {
  const Vec3 &a = m.positions[t[0]], &b = m.positions[t[1]], &c = m.positions[t[2]];
  return (b - a).cross(c - a).z();
}

/// The cutter's Z of a point of its sweep: the smaller of those at both ends of the step.
struct Depth {
  Pose X_CB, X_CB0;  ///< from the frame of the step's end: for the pose at the end, at the start
  double operator()(const Vec3& x_B) const { return std::min((X_CB * x_B).z(), (X_CB0 * x_B).z()); }
};

}  // namespace

double top_of(const mesh::TriangleMesh& rock_W) {
  double top = INFINITY;
  for (const Vec3& x : rock_W.positions) top = std::min(top, x.z());
  return top;
}

std::vector<CutterHull> cutter_hulls(const bit::Bit& bit) {
  std::vector<CutterHull> hulls;
  for (std::size_t i = 0; i < bit.cutters.size(); ++i) {
    const std::vector<Vec3> points_B = corners_B(bit, static_cast<int>(i));
    if (points_B.empty()) continue;
    CutterHull h{static_cast<int>(i), bit.cutters[i].X_BC, 0.0, convex_hull(points_B)};
    const Pose X_CB = inverse(h.X_BC);
    for (const Vec3& x_B : h.hull_B.positions) h.tip = std::min(h.tip, (X_CB * x_B).z());
    hulls.push_back(std::move(h));
  }
  return hulls;
}

std::vector<SweepTool> ruled_tools(const std::vector<CutterHull>& cutters, const Pose& X_B1B0) {
  std::vector<SweepTool> tools;
  tools.reserve(cutters.size());
  for (const CutterHull& c : cutters) {
    SweepTool tool{c.cutter, c.hull_B};
    mesh::TriangleMesh& m = tool.lower_B;
    const int n = static_cast<int>(m.positions.size());
    for (int v = 0; v < n; ++v) m.positions.push_back(X_B1B0 * c.hull_B.positions[v]);
    for (const mesh::Triangle& t : c.hull_B.triangles)
      m.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
    std::erase_if(m.triangles,
                  [&](const mesh::Triangle& t) { return doubled_plan_area(m, t) <= 0.0; });
    for (const mesh::Triangle& t : c.hull_B.triangles)
      for (int i = 0; i < 3; ++i) {
        const int a = t[i], b = t[(i + 1) % 3];
        if (a > b) continue;  // its other triangle adds it
        m.triangles.push_back({a, b, b + n});
        m.triangles.push_back({a, b + n, a + n});
      }
    tools.push_back(std::move(tool));
  }
  return tools;
}

std::vector<SweepTool> sweep_tools(const std::vector<CutterHull>& cutters, const Pose& X_B1B0,
                                   double reach) {
  std::vector<SweepTool> tools;
  tools.reserve(cutters.size());
  for (const CutterHull& c : cutters) {
    const Pose X_CB = inverse(c.X_BC);
    const Depth depth{X_CB, X_CB * inverse(X_B1B0)};
    std::vector<Vec3> points = c.hull_B.positions;
    for (const Vec3& x_B : c.hull_B.positions) points.push_back(X_B1B0 * x_B);
    SweepTool tool{c.cutter, convex_hull(points)};
    const std::vector<Vec3>& x = tool.lower_B.positions;
    std::erase_if(tool.lower_B.triangles, [&](const mesh::Triangle& t) {
      return doubled_plan_area(tool.lower_B, t) <= 0.0 ||
             std::min({depth(x[t[0]]), depth(x[t[1]]), depth(x[t[2]])}) > c.tip + reach;
    });
    tools.push_back(std::move(tool));
  }
  return tools;
}

}  // namespace tdbd::reference
