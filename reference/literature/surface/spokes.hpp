#pragma once

#include <vector>

#include "core/types.hpp"
#include "mesh/triangle_mesh.hpp"
#include "reference/literature/surface/sweep_tool.hpp"

namespace tdbd::reference {

/// The spoke-and-node rock surface of Langeveld (1992), the baseline that the triangulated rock
/// replaces. Thesis: 2.1, fig. 2.1. The spokes are half-planes through the hole's axis at equal
/// angles (SpokePlane). Each has nodes at equal radial distances with one depth each. Langeveld
/// used 120 spokes of 500 nodes.
///
/// Reconstructed: our excerpt describes the layout, not the update. One depth per node cannot
/// represent a wall steeper than the spacing of the nodes allows, nor overhanging rock; Hanson and
/// Hansen's surface (OutlineSpokes) can.
struct Spokes {
  double radius = 0.0;  ///< m, to which spokes reach
  int spokes = 0, nodes = 0;
  std::vector<double> depth;  ///< m, z down; [spoke * nodes + node]

  double node_spacing() const { return radius / nodes; }  ///< along a spoke, m
  double node_radius(int node) const { return (node + 0.5) * node_spacing(); }
  double azimuth(int spoke) const;  ///< rad
};

/// Distance between neighbouring spokes at a radius, m. It grows with the radius, which causes the
/// loss of resolution at the gage shown in figure 2.1.
double spoke_spacing(const Spokes& rock, double r);

/// Flat rock at depth z.
Spokes flat_spokes(double radius, double z, int spokes, int nodes);

/// Computes the spokes of a rock surface (its normal points up): the deepest of its points at each
/// node, or its smallest z where it has none.
Spokes spokes_of(const mesh::TriangleMesh& rock_W, double radius, int spokes, int nodes);

/// Lowers every node above facets that face down (as in SweepTool) to their depth. In the plane of
/// a spoke this is the two-dimensional problem to which the layout reduces cutting. Returns the
/// removed volume, m3: each node represents its share of ring and of sector.
double cut_sweep(Spokes& rock, const mesh::TriangleMesh& lower_B, const Pose& X_WB);

/// One step of all tools. X_WB: the bit at the step's end. Returns the removed volume, m3.
double cut_sweep(Spokes& rock, const std::vector<SweepTool>& tools, const Pose& X_WB);

/// Depth between nodes, m: linear along the spokes and in the angle between them. Constant from the
/// innermost node to the axis and beyond the outermost node.
double depth_at(const Spokes& rock, double x, double y);

}  // namespace tdbd::reference
