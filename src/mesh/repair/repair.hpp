#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

struct RepairOptions {
  double weld = 0.0;  ///< m; points this close are merged. 0: equal points only
};

/// One operation of a repair that changed something.
struct RepairStep {
  std::string what;       ///< "merged points at equal places", with sizes in mm
  std::size_t count = 0;  ///< how many points, facets, edges or holes
};

/// A repaired mesh, what was done in order, and why repair gave up, if it did: then the mesh is as far as repair got.
/// With an empty refusal check_solid finds nothing.
struct Repaired {
  TriangleMesh mesh;
  std::vector<RepairStep> steps;
  std::string refusal;
};

/// Turns a mesh into the boundary of a solid, if the mesh determines it, in this order:
///   merges points; drops duplicate facets, and both of a pair that face each other; removes facets without area; drops
///   sheets that stick out of the surface; splits edges of four or more facets into pairs that bound the same solid;
///   orients facets like the majority of their piece; fills holes with the triangulation of least area [CGAL]; orients
///   pieces outwards and cavities inwards; unites overlapping pieces and remeshes around intersections [CGAL].
/// A sound mesh comes back unchanged, bit for bit, without steps. Refused: edges with an odd number of facets,
/// one-sided surfaces (a Moebius strip), and whatever is not a solid in the end. Ours: the thesis's meshes came from a
/// mesh generator (3.3).
Repaired repair(TriangleMesh m, const RepairOptions& options = {});

/// The command line that writes a repaired file beside `path`.
std::string repair_command(const std::filesystem::path& path);

/// What is wrong with the solids of a file, one line each ("PATH: solid NAME: hole: 3 times, first edge ..."), and last
/// the command that repairs the file or the reason why it cannot be repaired; with more than 1000 open edges no repair is
/// tried, and the command may fail. Empty for sound solids.
std::vector<std::string> mesh_faults(const std::filesystem::path& path,
                                     const std::vector<Solid>& solids);

}  // namespace tdbd::mesh
