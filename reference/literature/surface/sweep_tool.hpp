#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::reference {

/// What one cutter sweeps in one step, for a height field or a spoke: those facets of the convex
/// hull of its cutting parts at both ends of the step that face down. In the bit's frame at
/// the step's end. In a steady motion every step is the same screw about the bit's axis, so the
/// hull is made once and only placed anew.
struct SweepTool {
  int cutter = -1;  ///< index into Bit::cutters
  mesh::TriangleMesh lower_B;
};

/// The least z of a surface's points, m.
double top_of(const mesh::TriangleMesh& rock_W);

/// A cutter prepared for its sweeps: the convex hull of its cutting parts.
struct CutterHull {
  int cutter = -1;
  Pose X_BC;
  double tip = 0.0;  ///< least Z of a corner in the cutter's frame, m
  mesh::TriangleMesh hull_B;
};
std::vector<CutterHull> cutter_hulls(const bit::Bit& bit);

/// Tools for motions whose steps differ, where a hull for each would take too long: the hull's
/// lower facets at both ends of the step and, for every edge, the two triangles between its places.
/// All lie in the convex hull of both ends; its lower side is theirs when the step is a
/// translation, and to second order in the step's turn otherwise.
std::vector<SweepTool> ruled_tools(const std::vector<CutterHull>& cutters, const Pose& X_B1B0);

/// One tool for every cutter. X_B1B0: the bit at the step's start in its frame at the step's end.
/// Of a facet some corner must be nearer than `reach` (m) to the cutter's tip, along the cutter's Z
/// (its tip is at the least Z): facets farther up cut nothing while no cut is deeper than that, and
/// would only slow a rival down. For upright motions: facets that face down keep doing so.
std::vector<SweepTool> sweep_tools(const std::vector<CutterHull>& cutters, const Pose& X_B1B0,
                                   double reach);

}  // namespace tdbd::reference
