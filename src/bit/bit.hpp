#pragma once

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/types.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::bit {

/// The kind of a part. It selects data (name, colour, force law), not a class. Thesis: 3.1.
enum class PartKind { face, chamfer, cse, cutter_body, gage_pad, bit_body, cone, tooth };

/// Every kind, in the order of the enumeration.
inline constexpr std::array part_kinds{
    PartKind::face,     PartKind::chamfer,  PartKind::cse,  PartKind::cutter_body,
    PartKind::gage_pad, PartKind::bit_body, PartKind::cone, PartKind::tooth};

/// The name of a kind in words, for messages: "face", "cutter body", "gage pad", ... The other two
/// spellings are derived from it.
std::string_view kind_words(PartKind kind);

/// A kind's name in results and bit files: "face", "cutter-body", "gage-pad", ...
std::string kind_name(PartKind kind);

/// A kind's key in a case: "face", "cutter_body", "gage_pad", ...
std::string kind_key(PartKind kind);

/// The names of all kinds (kind_name), and the kind with a given name; PartKind::face for an
/// unknown name.
std::vector<std::string_view> part_kind_names();
PartKind part_kind_named(std::string_view name);

/// Whether a part of this kind belongs to a cutter.
constexpr bool belongs_to_a_cutter(PartKind kind) {
  return kind == PartKind::face || kind == PartKind::chamfer || kind == PartKind::cse ||
         kind == PartKind::cutter_body;
}

/// Whether a part of this kind is a surface of a cutter other than its face and chamfer.
constexpr bool is_side_of_a_cutter(PartKind kind) {
  return kind == PartKind::cse || kind == PartKind::cutter_body;
}

/// Whether a part removes rock. Thesis: 3.1. A part that rubs moves no rock, so rock may be inside
/// it; the force law of its kind acts on the surface of that rock
/// (rock/section/rubbing_contact.hpp). For the clearance of a bit body from the rock that the
/// cutters leave, see body/rubbing.hpp.
enum class Cutting { cuts, rubs, never };

/// "yes", "rubs" or "no".
std::string cutting_name(Cutting cutting);

/// How a tooth is made. Milled teeth are cut from the cone's steel; inserts are pressed in.
enum class ToothKind { milled_chisel, hemispherical, conical, chisel };

/// The location of a row. The teeth of a gage row reach the gage radius during a turn of the cone.
enum class RowPlace { inner, gage };

/// One tooth, in its frame T: origin on the shell, Z out of the cone, X along the cone's meridian
/// towards the base. Every kind is mirror-symmetric in X and in Y. Lengths in m, angles in rad.
struct ToothShape {
  ToothKind kind = ToothKind::hemispherical;
  double diameter = 12e-3;     ///< of an insert's shank; of a milled tooth, length at the shell
  double width = 8e-3;         ///< milled teeth only: in circumferential direction, at the shell
  double protrusion = 6.5e-3;  ///< height of the tip above the shell
  double crest_length = 6e-3;  ///< chisels only: along X
  double crest_width = 2e-3;   ///< chisels only: along Y
  double tip_radius = 4e-3;    ///< conical inserts only
  double half_angle = 0.6;     ///< conical inserts only: of the cone
  double embedding = 4e-3;     ///< depth below the shell
  double density = 14.9e3;     ///< kg/m3
};

/// A ring of equal teeth around a cone.
struct ToothRow {
  double s = 0.0;              ///< m, position on the shell, as in ShellPoint
  double sink = 0.0;           ///< m, depth of the teeth's origins below the shell
  double lean = 0.0;           ///< rad, from the shell's normal towards the base
  std::vector<double> angles;  ///< rad about the cone's Z, one per tooth, ascending, in [0, 2 pi)
  RowPlace place = RowPlace::inner;
  ToothShape shape;
};

/// A point of a cone's meridian: s along the journal, outwards (against the cone's Z); r is the
/// distance from the journal's axis.
struct ShellPoint {
  double s = 0.0;  ///< m
  double r = 0.0;  ///< m
};

/// The layout of a cone: its journal, its shell (a stack of frustums) and its rows of teeth. For
/// the frames see cone_bit.hpp. Thesis: 1.2, 3.1, fig. 3.5.
struct ConeLayout {
  static constexpr double usual_density = 7850.0;  // kg/m3
  static constexpr int usual_segments = 96, usual_facets = 16;

  double journal_angle =
      0.0;  ///< rad, angle between the journal and the plane normal to the axis of the bit
  double offset = 0.0;            ///< m, of the journal, in the direction of the bit's rotation
  double skew = 0.0;              ///< rad, rotation of the journal's outer end, in that direction
  double azimuth = 0.0;           ///< rad, of the journal about the bit's +z
  double apex = 0.0;              ///< m, from the foot of the journal to the cone's origin, along Z
  double foot_height = 0.0;       ///< m, of the journal's foot above the bit's origin (against z)
  std::vector<ShellPoint> shell;  ///< in ascending s, from the nose to the base
  std::vector<ToothRow> rows;     ///< from the nose to the base
  Cutting body = Cutting::never;  ///< whether the shell crushes rock left between prints
  double density = usual_density;  ///< kg/m3
  int segments = usual_segments;   ///< of the shell's mesh
  int facets = usual_facets;       ///< of an insert's mesh, a multiple of 4
};

/// A cone of a bit: its layout, and its frame K in the bit frame B at the cone's angle 0.
struct Cone {
  std::string name;  ///< "cone-1"
  ConeLayout layout;
  Pose X_BK;
  /// Ratio of the speed of the rolling cone to that of the bit, for a cone of solids, which has no
  /// rows. 0: unknown.
  double rolling_ratio = 0.0;
};

/// The steel above the cones: a cylinder about the bit's axis that never cuts. In a bit without
/// legs it also represents them. Lengths in m.
struct Shank {
  double radius = 0.0;  ///< 0: none
  double length = 0.0;
  double height = 0.0;  ///< height of its lower end above the bit's origin
  double density = 7850.0;
};

/// The legs that carry the journals, one per cone (cone/legs.hpp), and the flush carbide inserts in
/// their outer sides. Lengths in m; heights above the bit's origin.
struct Legs {
  double width = 0.0;          ///< across the journal; 0: none
  double under_gage = 1.6e-3;  ///< distance of the outer side inside the gage radius
  double clearance = 2e-3;     ///< distance from the base of the cone's shell to the leg
  double tip_radius = 0.0;     ///< of the shirttail about the journal; 0: as the shell's base
  double shoulder = 0.0;       ///< height at which the outer side leaves the gage
  double top = 0.0;            ///< height at which it meets the shank's side
  double density = 7850.0;     ///< kg/m3
  Cutting cutting = Cutting::rubs;
  int inserts = 0;  ///< number on each leg, in a column
  double insert_diameter = 9.5e-3;
  double insert_length = 8e-3;
  double insert_protrusion = 0.5e-3;  ///< of the middle of an insert's flat face out of the leg
};

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
  std::string material = {};       ///< its name, if an area defines it (Material)
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
struct BladeDimensions {
  double exposure = 0.0;        ///< m
  double slot_depth = 0.0;      ///< m
  double junk_slot_area = 0.0;  ///< m2, across the gage
};

/// Source of the cutters' data: a table or a design, or the meshes of their parts.
enum class CutterSource { table, meshes };

/// A bit: parts in the bit frame B. The origin of B is the nose tip on the axis; z points down, in
/// the direction of drilling. For the centre of mass see mass_properties.
struct Bit {
  std::string name;
  std::vector<Part> parts;
  std::vector<Cutter> cutters;
  double gage_radius = 0.0;  ///< m, largest radius of a cutting part as its cone turns
  std::vector<Cone> cones;
  Shank shank;  ///< of a bit with cones
  std::optional<BladeDimensions> blades = std::nullopt;
  CutterSource cutter_source = CutterSource::table;
  Legs legs = {};  ///< of a bit with cones
};

/// What a part does to rock after its start.
inline Cutting final_cutting(const Part& part) {
  return part.start ? part.start->then : part.cutting;
}

/// A part's mesh in the bit frame (cones at angle 0), m.
mesh::TriangleMesh mesh_B(const Part& part);

/// Largest distance (m) from the bit's axis of a vertex of a cutting part, with the cones in their
/// present position. 0 if no part cuts.
double largest_radius(const std::vector<Part>& parts);

/// Mass, centre of mass and inertia tensor of a solid, in one frame. The tensor is about the centre
/// of mass, along the axes of that frame.
struct MassProperties {
  double mass = 0.0;            ///< kg
  Vec3 centre = Vec3::Zero();   ///< m
  Mat3 inertia = Mat3::Zero();  ///< kg m2
};

/// Computes the mass properties of the solid inside a closed mesh, in the mesh's frame, by exact
/// integration over signed tetrahedra. `density` in kg/m3. Requires outward normals and a nonzero
/// volume. Not in the thesis.
MassProperties mass_properties(const mesh::TriangleMesh& m, double density);

/// The same body in frame A.
MassProperties transformed(const MassProperties& body_P, const Pose& X_AP);

/// The mass properties of two bodies in one frame taken together, by the parallel-axis theorem. A
/// massless body has no effect.
MassProperties combined(const MassProperties& a, const MassProperties& b);

/// The mass properties of a bit, in the bit frame: the sum over its parts with density > 0.
/// Overlaps count twice.
MassProperties mass_properties(const Bit& bit);

/// Formats a length in m for messages: "12.5 mm".
inline std::string mm_text(double x) { return fmt::format("{:.6g} mm", 1e3 * x); }

/// Formats an angle in rad for messages: "20 deg".
inline std::string degree_text(double x) { return fmt::format("{:.6g} deg", x / degree); }

/// The direction e of eq. 4.2 for inside cutters. Straight down is the default (reconstructed). +X
/// and -X are the two readings of the thesis's formula: our copy of the text omits minus signs
/// elsewhere.
enum class InsideRule { down, plus_x, minus_x };

/// How update directions are chosen. `hybrid` is eq. 4.2; the others are the two extremes with
/// which figs. 4.7 to 4.9 of the thesis compare it.
enum class DirectionRule { hybrid, all_down, along_profile };

/// Returns the direction in which a cutter moves rock vertices, at azimuth 0: a unit vector in the
/// bit's X-Z plane; bit (8). With R the rotation about z that moves the cutter's origin to the
/// plane's +X side:
///   U~ = proj_XZ(-R Z)                                  (4.1)
///   U = U~/|U~| if U~.x > 0 (outside cutters), otherwise e  (4.2)
/// A cutter on the axis is treated as at azimuth 0. Throws InputError if the rule is along_profile
/// and -Z of the cutter points sideways (U~ = 0). Thesis: 4.1.2.1.
Vec3 update_direction(const Pose& X_BC, DirectionRule rule, InsideRule inside);

/// Applies eq. 4.2 to a given U~, which lies in the X-Z plane and may have any length.
Vec3 update_direction(const Vec3& u, DirectionRule rule, InsideRule inside);

/// A ring of points about the X axis. Point k of n is at the angle a = 2 pi k / n from -Z towards
/// +Y: (x, radius sin a, -radius cos a). A ring with one point lies on the axis.
struct Ring {
  double radius = 0.0;  ///< m
  double x = 0.0;       ///< m
  int count = 1;
};

/// Makes a closed mesh that connects each ring to the next. The rings follow the meridian from the
/// solid's +X end, on the axis, to its other end, on the axis, so that the normals point outwards.
/// Rings with different counts are connected by always advancing the smaller angle. The polygons
/// are inscribed, and every ring has a point at exactly -Z. Thesis: 3.3.
mesh::TriangleMesh surface_of_revolution(const std::vector<Ring>& rings);

}  // namespace tdbd::bit
