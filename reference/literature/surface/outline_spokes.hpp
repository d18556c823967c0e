#pragma once

#include "reference/literature/surface/outline_nodes.hpp"
#include "reference/literature/surface/spokes.hpp"
#include "reference/literature/surface/swept_section.hpp"

namespace tdbd::reference {

/// The spoke-and-node rock surface of Hanson and Hansen (1995), the baseline that the triangulated
/// rock replaces. Thesis: 2.1, fig. 2.1: any number of spokes, any number of nodes on each, and in
/// the plane of a spoke a surface of general shape, with several z for one radius. So it can
/// represent vertical walls and overhanging rock, which Langeveld's spokes (Spokes) cannot.
///
/// Reconstructed: our excerpt states what the surface can represent, but neither how it is cut nor
/// where its nodes are. Here each spoke stores the outline of the rock in its plane. A step
/// subtracts, by a regularised boolean (planar_boolean), the outline of each cutter's swept body in
/// that plane (section), and redistributes the nodes (respaced).
struct OutlineSpokes {
  SpokeFrame frame;
  double spacing = 0.0;          ///< of nodes along the surface, m
  std::vector<PlanarFace> rock;  ///< of each spoke, r >= 0, z down

  int spokes() const { return static_cast<int>(rock.size()); }
};

/// Volumes, m3. Each spoke represents its sector of rock.
struct OutlineCut {
  double removed = 0.0;   ///< by the tools, and by chips that came loose
  double respaced = 0.0;  ///< change of the rock's volume due to redistributed nodes
};

/// Makes flat rock at z = top. Radius and depths are rounded to planar_grid.
OutlineSpokes flat_outline_spokes(const SpokeFrame& frame, double top, int spokes, double spacing);

/// Makes the rock below a sheet, by rock_section.
OutlineSpokes outline_spokes_of(const mesh::TriangleMesh& rock_W, const SpokeFrame& frame,
                                int spokes, double spacing);

/// Subtracts an outline from one spoke. Pieces without the frame's outer lower corner are removed
/// as loose, because a spoke has no information about their support in other planes. A tool that
/// reaches less than two grid lengths into the rock cuts nothing.
OutlineCut cut_spoke(OutlineSpokes& rock, int spoke, const Outline& tool);

/// Sections of tools in the plane of each spoke that have not been subtracted from the rock yet.
using SpokeSections = std::vector<std::vector<Outline>>;

/// Adds those sections of one step's bodies that meet rock. X_WB: the bit at the step's end.
void add_sections(SpokeSections& sections, const OutlineSpokes& rock,
                  const std::vector<SweptBody>& bodies, const Pose& X_WB);

/// Subtracts all of them and clears the list. The remaining rock does not depend on the order,
/// except for the places of nodes. Many steps at once take less time than one by one.
OutlineCut cut_sections(OutlineSpokes& rock, SpokeSections& sections);

/// Makes one step of all bodies. X_WB: the bit at the step's end.
OutlineCut cut_sweep(OutlineSpokes& rock, const std::vector<SweptBody>& bodies, const Pose& X_WB);

/// Volume of all sectors, m3.
double volume(const OutlineSpokes& rock);

/// The number of nodes within a radius, without those on the bottom of the rock.
long nodes_within(const OutlineSpokes& rock, double radius);

/// The deepest surface at each of `nodes` nodes of each spoke, as in a height field.
Spokes deepest(const OutlineSpokes& rock, double radius, int nodes);

}  // namespace tdbd::reference
