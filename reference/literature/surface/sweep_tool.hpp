#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::reference {

/// What one cutter sweeps in one step, for a height field or a spoke: the downward facets of the
/// convex hull of its cutting parts at both ends of the step. In the bit's frame at the step's end.
/// In a steady motion every step is the same screw about the bit's axis, so the hull is computed
/// once and only moved.
struct SweepTool {
  int cutter = -1;  ///< index into Bit::cutters
  mesh::TriangleMesh lower_B;
};

/// The smallest z of a surface's points, m.
double top_of(const mesh::TriangleMesh& rock_W);

/// A cutter prepared for its sweeps: the convex hull of its cutting parts.
struct CutterHull {
  int cutter = -1;
  Pose X_BC;
  double tip = 0.0;  ///< m, smallest Z of a corner in the cutter's frame
  mesh::TriangleMesh hull_B;
};
std::vector<CutterHull> cutter_hulls(const bit::Bit& bit);

/// Tools for motions whose steps differ, where a hull per step would take too long: the hull's
/// lower facets at both ends of the step and, for every edge, the two triangles between its
/// positions. All lie in the convex hull of both ends. They form its lower side if the step is a
/// translation, otherwise to second order in the step's rotation.
std::vector<SweepTool> ruled_tools(const std::vector<CutterHull>& cutters, const Pose& X_B1B0);

/// One tool per cutter. X_B1B0: the bit at the step's start in its frame at the step's end. Facets
/// are omitted if no corner is within `reach` (m) of the cutter's tip along the cutter's Z (the tip
/// has the smallest Z). They cut nothing as long as no cut is deeper than `reach`, and would only
/// slow down a method in comparisons. For upright motions, in which facets that face down continue
/// to do so.
std::vector<SweepTool> sweep_tools(const std::vector<CutterHull>& cutters, const Pose& X_B1B0,
                                   double reach);

}  // namespace tdbd::reference
