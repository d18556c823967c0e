#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bit/cone.hpp"
#include "bit/part_kind.hpp"
#include "core/pose.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::bit {

/// A straight segment between two points.
struct Segment {
  Vec3 from, to;  ///< m
};

/// The event that makes a waiting part begin to cut or to rub. Thesis: 3.1 (parts decide when they
/// cut). `wear`: the wear flat of a cutter reaches a height; the cutters are those with a part
/// whose name matches a pattern.
enum class StartEvent { depth, time, wear };

/// A part that waits: its Part::cutting is `never` until the event, and `then` afterwards.
struct LateStart {
  StartEvent event = StartEvent::time;
  /// m that the bit has moved down since its motion began, or s since then, or m of Cutter::wear.
  double from = 0.0;
  Cutting then = Cutting::cuts;
  std::string worn_names = {};  ///< pattern of part names (core/wildcard.hpp), for `wear`
  std::string place = {};       ///< place of the area that defines the start, for messages
};

/// One rigid part of the bit: a closed, consistently oriented mesh in its own frame P. The parts of
/// one cutter share that cutter's frame. Thesis: 3.1.
struct Part {
  std::string name;  ///< "cutter-12/face", "gage-pad-3", "bit-body"
  PartKind kind = PartKind::bit_body;
  Cutting cutting = Cutting::cuts;
  /// In (0, 1]: the share of the depth of rock in its way that the part removes in one pass
  /// (rock/cut/left_rock.hpp).
  double share = 1.0;
  Pose X_BP;                  ///< part frame in the bit frame
  mesh::TriangleMesh mesh_P;  ///< m, part frame
  /// Touching convex solids whose union the mesh encloses. Empty if not known.
  std::vector<mesh::TriangleMesh> pieces_P;
  /// Unit direction in which the part moves rock, in the bit's X-Z plane (azimuth 0); bit (8).
  Vec3 update_direction_B = Vec3(0, 0, 1);
  int group = -1;        ///< parts with the same group share X_BP and are processed together
  int cutter = -1;       ///< index into Bit::cutters, or -1
  double density = 0.0;  ///< kg/m3; 0: the part's volume is counted in another part
  /// If set, rock moves along the normal about this segment instead (rock::mapped_direction_W).
  std::optional<Segment> core_P;
  int cone = -1;  ///< index into Bit::cones, or -1; X_BP is valid at the cone's angle 0
  int row = -1;   ///< of a tooth: index into its cone's rows
  std::optional<LateStart> start;  ///< empty: `cutting` is valid from the beginning
  std::string material = {};       ///< its name, if an area defines it (bit_area_keys::material)
  /// Names of the areas of the bit file that define density or material, cutting, share and start.
  /// Empty if no area does.
  std::string density_area, cutting_area, share_area, start_area;
};

/// One row of the cutter table, SI. Thesis: 3.2.2, app. A.
struct Cutter {
  int id = 0;  ///< number in the table, as in "cutter-12"
  int blade = 0;
  std::string zone;            ///< cone, nose, shoulder, gage (a label)
  double diameter = 0.0;       ///< m
  double tip_radius = 0.0;     ///< m, from the bit's axis
  double azimuth = 0.0;        ///< rad, about +z
  double tip_height = 0.0;     ///< m, above the nose tip (against +z)
  double profile_angle = 0.0;  ///< rad; the normal into the rock is n = (sin, cos) in (r, z)
  double back_rake = 0.0;      ///< rad
  double side_rake = 0.0;      ///< rad
  double chamfer = 0.0;        ///< m, width along the face, 0 for a sharp edge
  double chamfer_angle = 0.0;  ///< rad, from the cutter's axis; usually 45 deg
  double land = 0.0;           ///< m, width of a second, flatter chamfer inside the first; 0: none
  double land_angle = 0.0;     ///< rad, from the cutter's axis
  double length = 0.0;         ///< m, of the whole cutter
  double table_thickness = 0.0;  ///< m, of the diamond table
  double wear = 0.0;             ///< m, height of the wear flat along the profile's normal
  double under_exposure = 0.0;   ///< m, from the profile into the bit; the tip includes it
  int line = 0;                  ///< line in the file of the table, for messages
  Pose X_BC;                     ///< cutter frame in the bit frame, bit (1)
};

/// Design values of a body with blades (blade_body.hpp).
struct BladeFigures {
  double exposure = 0.0;        ///< m
  double slot_depth = 0.0;      ///< m
  double junk_slot_area = 0.0;  ///< m2, across the gage
};

/// Source of the cutters' data: a table or a design, or the meshes of their parts.
enum class CuttersFrom { table, meshes };

/// A bit: parts in the bit frame B. The origin of B is the nose tip on the axis; z points down, in
/// the direction of drilling. For the centre of mass see mass_properties.
struct Bit {
  std::string name;
  std::vector<Part> parts;
  std::vector<Cutter> cutters;
  double gage_radius = 0.0;  ///< m, largest radius of a cutting part as its cone turns
  std::vector<Cone> cones;
  Shank shank;  ///< of a bit with cones
  std::optional<BladeFigures> blades = std::nullopt;
  CuttersFrom cutters_from = CuttersFrom::table;
  Legs legs = {};  ///< of a bit with cones
};

/// What a part does to rock after its start.
inline Cutting cutting_in_the_end(const Part& part) {
  return part.start ? part.start->then : part.cutting;
}

/// A part's mesh in the bit frame (cones at angle 0), m.
mesh::TriangleMesh mesh_B(const Part& part);

/// Largest distance (m) from the bit's axis of a vertex of a cutting part, with the cones in their
/// present position. 0 if no part cuts.
double largest_radius(const std::vector<Part>& parts);

}  // namespace tdbd::bit
