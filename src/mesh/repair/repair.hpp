#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mesh/check/weld.hpp"
#include "mesh/measures.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// Statistics of a mesh, which may have defects. Its indices must be in range and its positions
/// finite.
struct Inspection {
  std::size_t vertices = 0;
  std::size_t facets = 0;
  std::size_t pieces = 0;                 ///< pieces connected by edges
  std::size_t equal_points = 0;           ///< vertices at the position of an earlier one
  std::size_t degenerate = 0;             ///< facets with zero area
  std::size_t duplicates = 0;             ///< facets with the corners of an earlier one
  std::size_t open_edges = 0;             ///< edges of one facet
  std::size_t flipped_edges = 0;          ///< edges that both facets traverse in the same direction
  std::size_t non_manifold_edges = 0;     ///< edges of more than two facets
  std::size_t non_manifold_vertices = 0;  ///< vertices shared by several fans of facets
  std::size_t intersecting_pairs = 0;     ///< see self_intersections
  double volume = 0.0;                    ///< m3, enclosed; meaningless for an open mesh
  double area = 0.0;                      ///< m2
  Box box;
  double shortest_edge = 0.0, mean_edge = 0.0, longest_edge = 0.0;  ///< m
  double worst_quality = 0.0;                                       ///< see triangle_quality

  bool is_closed() const { return open_edges == 0; }
  bool is_oriented() const { return flipped_edges == 0 && volume > 0.0; }
  bool is_manifold() const { return non_manifold_edges == 0 && non_manifold_vertices == 0; }
};

Inspection inspect(const TriangleMesh& m);

struct RepairOptions {
  double weld = 0.0;  ///< m; points at most this far apart are merged. 0: only equal points
};

/// One operation of a repair that changed the mesh.
struct RepairStep {
  std::string what;       ///< for example "merged points at equal places", with sizes in mm
  std::size_t count = 0;  ///< number of points, facets, edges or holes changed
};

/// A repaired mesh, the steps in order, and why the repair failed, if it did; the mesh is then the
/// state before the failed step. If `refusal` is empty, check_solid finds no defect.
struct Repaired {
  TriangleMesh mesh;
  std::vector<RepairStep> steps;
  std::string refusal;
};

/// The largest share of the volume, of the area, and of the size along x, y and z by which merging
/// points or remeshing may change a mesh.
inline constexpr double most_changed = 0.01;

/// Repairs a mesh so that it bounds a solid, if the mesh determines that solid. The steps are, in
/// this order:
/// - merge points;
/// - drop duplicate facets, and both facets of a pair that face each other;
/// - remove facets with zero area;
/// - insert corners into the open edges on which they lie (T-junctions);
/// - drop sheets that stick out of the surface;
/// - split edges of four or more facets into pairs that bound the same solid;
/// - orient facets like the majority of their piece;
/// - fill holes with the triangulation of least area [CGAL];
/// - orient pieces outwards, and drop bodies inside bodies (nested_pieces);
/// - unite overlapping pieces, or remesh around intersections [CGAL].
///
/// A sound mesh is returned bitwise unchanged, without steps. Refused are edges with an odd number
/// of facets, one-sided surfaces (a Moebius strip), meshes that do not bound a solid after the last
/// step, and steps that change the mesh too much, with the numbers: merging points or remeshing
/// beyond most_changed; a union that is smaller than one of its bodies, larger than their sum or of
/// another size; a hole that is not flat and whose patch exceeds most_filled. This repair is an
/// addition of TDBD [+]: the meshes of the thesis came from a mesh generator (3.3).
Repaired repair(TriangleMesh m, const RepairOptions& options = {});

/// The command line that writes a repaired copy next to `path`. `weld`: value of --weld, or empty.
std::string repair_command(const std::filesystem::path& path, const std::string& weld);

/// A weld distance that closes cracks of the solids (weld_hint). If most solids have open edges,
/// they are pieces of a mesh whose points differ slightly, and are welded together.
std::optional<WeldHint> crack_hint(const std::vector<Solid>& solids);

/// Describes the defects of the solids of a file, one per line ("PATH: solid NAME: hole: 3 times,
/// first edge ..."), at most twelve and the number of others. The last line is the command that
/// repairs the file, or the reason why it cannot be repaired. For cracks the command has a weld
/// distance. With more than 1000 open edges no repair is tried, so the command may fail. Empty for
/// sound solids.
std::vector<std::string> mesh_faults(const std::filesystem::path& path,
                                     const std::vector<Solid>& solids);

/// The union of solids, or why there is none.
struct United {
  TriangleMesh mesh;    ///< closed, oriented outwards, without intersections
  std::string refusal;  ///< empty on success
};

/// Computes the union of closed solids with exact arithmetic [CGAL] and rounds it to doubles. The
/// result is empty for no solids. Rounding makes facets without area where surfaces nearly
/// coincide. Therefore points within a distance of at most 1 um are merged, the smallest distance
/// for which check_solid finds no defect and `is_sound` is true. If there is none, or the union is
/// not a manifold, because solids touch in an edge or surfaces nearly coincide, all solids are
/// enlarged by at most 0.1 um, then by 1 um, so that solids that touch overlap. Refused are solids
/// with defects, and those that have no sound union nevertheless. The union is an addition of TDBD
/// [+].
United unite(const std::vector<Solid>& solids,
             const std::function<bool(const TriangleMesh&)>& is_sound);

/// @file
/// Open sheets: the surface of a rock. z points down, into the rock, and facets face up, out of the
/// rock. The outermost boundary of a sheet is its rim; every other boundary is a hole.

/// A boundary of a sheet.
struct Opening {
  std::vector<int> loop;       ///< vertices, see boundary_loops
  Vec3 centre = Vec3::Zero();  ///< m, mean of its corners
  double across = 0.0;         ///< m, diagonal of its bounding box
};

/// Returns the boundaries of a sheet, the rim first, then the holes by size.
std::vector<Opening> openings(const TriangleMesh& m);

/// "hole of 4 edges, 2.83 mm across, at (1.0000, 2.0000, 3.0000) mm"; `what`: "hole" or "rim".
std::string describe(const Opening& opening, const std::string& what);

/// Drops vertices of no triangle, then fills the holes of a sheet with the triangulations of least
/// area [CGAL]; the rim stays. Returns the number of holes; `refusal` names a hole that has no triangulation.
std::size_t fill_sheet_holes(TriangleMesh& m, std::string& refusal);

/// Reverses all facets, so that the sheet faces the other way. Positions are unchanged.
void flip(TriangleMesh& m);

/// Turns the mesh by half a turn about x: (x, y, z) becomes (x, -y, -z). A file whose z axis points
/// up then has z down, with facets on the same side of the surface.
void turn_about_x(TriangleMesh& m);

/// Whether the facets face down on average. Those of a rock face up, against z.
bool faces_down(const TriangleMesh& m);

/// What to do about a sheet that faces down, for messages.
inline constexpr const char* upside_down_question =
    "does z point down in the file? If z points up, tdbd mesh --sheet --z-up turns the sheet; if "
    "only the facets are reversed, tdbd mesh --sheet --flip flips them";

/// Why a mesh cannot be the rock of a case, one line per reason: it is not one open oriented
/// surface with one boundary (check_surface), faces down, or intersects itself. Empty if it can.
std::vector<std::string> sheet_faults(const TriangleMesh& m);

}  // namespace tdbd::mesh
