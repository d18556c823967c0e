#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "mesh/files/solids.hpp"

namespace tdbd::mesh {

struct RepairOptions {
  double weld = 0.0;  ///< m; points this close become one. 0: equal points alone
};

/// One operation of a repair that changed something.
struct RepairStep {
  std::string what;       ///< "merged points at equal places", with sizes in mm
  std::size_t count = 0;  ///< how many points, facets, edges or holes
};

/// A repaired mesh, what was done to it in order, and why it was given up: then the mesh is as far
/// as the repair came. An empty refusal: check_solid finds nothing.
struct Repaired {
  TriangleMesh mesh;
  std::vector<RepairStep> steps;
  std::string refusal;
};

/// Makes the boundary of a solid of a mesh, if that can be told from the mesh, in this order:
///   merges points; drops duplicate facets, and pairs of them that face each other; removes facets
///   without area; drops sheets that stand out from the surface; parts facets at edges of four and
///   more into pairs that bound the same solid; turns facets as most of their neighbours; fills
///   holes with the triangulation of least area [CGAL]; turns pieces outwards, cavities inwards;
///   unites pieces that overlap and remeshes facets about intersections [CGAL].
/// A sound mesh comes back bit for bit, without steps. Refused: edges of an odd number of facets,
/// surfaces of one side (a Moebius strip), what is no solid after all of this. Reconstructed; the
/// thesis's meshes came from a mesher (3.3).
Repaired repair(TriangleMesh m, const RepairOptions& options = {});

/// The command line that writes a repaired file beside `path`.
std::string repair_command(const std::filesystem::path& path);

/// What is wrong with the solids of a file and what to do about it, one line each: "PATH: solid
/// NAME: hole: 3 times, first edge ...", and last the command that repairs the file or why nothing
/// can. Empty for sound solids.
std::vector<std::string> mesh_faults(const std::filesystem::path& path,
                                     const std::vector<Solid>& solids);

}  // namespace tdbd::mesh
