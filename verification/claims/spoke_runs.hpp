#pragma once

#include <string>
#include <vector>

#include "reference/literature/surface/outline_spokes.hpp"
#include "reference/literature/surface/surface_error.hpp"
#include "simulation/step/simulation.hpp"

/// Figure 2.1 of the thesis in numbers: spokes with as many nodes as our mesh has points, beside
/// that mesh, all against a fine height field.
namespace tdbd::claims {

/// One revolution of the standard workload in steps of 2 ms under a wall of 20 mm, edges in m, with
/// settings KEY=VALUE.
simulation::Case spoke_plan(double edge_length, const std::vector<std::string>& settings);

/// Settings of a backward whirl: an orbit of 3 mm, 14 Hz.
std::vector<std::string> spoke_whirl();

/// The same drilling in all kinds of rock. Each starts from our surface at t = 0.
struct SpokeDrilling {
  simulation::Case plan;
  mesh::TriangleMesh mesh_W;
  double mesh_removed = 0.0;  ///< m3
  reference::ZMap fine;
  reference::Spokes langeveld;
  reference::OutlineSpokes hanson;
  reference::OutlineCut hanson_cut;
  long points = 0;  ///< of the mesh within the gage at t = 0
};

/// Drills the whole plan, with so many spokes of each kind; cells of the fine height field in m.
SpokeDrilling drill_spokes(const simulation::Case& plan, int spokes, double fine_cell);

/// Spokes of Hanson and Hansen under a sheet, to some way beyond the gage.
reference::OutlineSpokes hanson_of(const mesh::TriangleMesh& rock_W, const bit::Bit& bit,
                                   int spokes, double spacing);

/// Drills a plan's steps from `first` to before `last`, 20 at once, on them alone.
reference::OutlineCut drill_hanson(reference::OutlineSpokes& rock, const simulation::Case& plan,
                                   long first, long last);

/// Nodes within the gage.
long nodes_inside(const reference::OutlineSpokes& rock, const bit::Bit& bit);

/// Errors ring by ring; `radii` as for surface_errors, m.
struct SpokeErrors {
  std::vector<reference::SurfaceError> mesh, langeveld, hanson;
};
SpokeErrors spoke_errors(const SpokeDrilling& d, const std::vector<double>& radii);

/// Mean distance between neighbouring points of the mesh in a ring, as of equilateral triangles, m.
double mesh_spacing(const SpokeDrilling& d, double r_lo, double r_hi);

/// Points of the mesh at these radii.
long points_within(const mesh::TriangleMesh& m, double r_lo, double r_hi);

}  // namespace tdbd::claims
