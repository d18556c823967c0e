#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/files/file_checks.hpp"
#include "core/config/config.hpp"
#include "core/config/field.hpp"
#include "mesh/files/length_unit.hpp"

namespace tdbd::bit {

/// Whether every part must have a density, as required for mass properties.
enum class Densities { as_given, required };

/// What a cutter table gives and meshes do not show, of a face in [[parts]] or [[solids.rules]].
/// The cutter of the face receives these values (add_cutters).
struct CutterLabels {
  std::optional<int> blade;
  std::optional<std::string> zone;
  std::optional<double> under_exposure, wear;

  void visit(FieldVisitor& v) {
    v(blade, {.name = "blade",
              .computed_default = "none",
              .hi = std::numeric_limits<int>::max(),
              .meaning = "of a face with its cutter's frame: the blade that carries the cutter"});
    v(zone, {.name = "zone",
             .computed_default = "none",
             .meaning = "of such a face: cone, nose, shoulder or gage, or another label"});
    v(under_exposure,
      {.name = "under_exposure",
       .unit = "m",
       .computed_default = "0",
       .range = bit_length_or_none,
       .meaning = "of such a face: distance of the tip from the profile into the bit"});
    v(wear, {.name = "wear",
             .unit = "m",
             .computed_default = "0",
             .range = bit_length_or_none,
             .meaning = "of such a face: height of the flat that the mesh already has"});
  }
};

/// The parts that a bit file names, and their data.
struct PartsFromFiles {
  std::vector<Part> parts;
  std::vector<std::uint8_t> has_direction;   ///< 0: part of a cutter without direction or frame
  std::vector<Cone> cones;                   ///< with which parts turn
  std::vector<std::string> without_density;  ///< names of parts without a density
  std::vector<std::optional<Pose>> frames;   ///< of each part's cutter; empty: not known
  std::vector<CutterLabels> labels;          ///< of each part
};

/// Reads the parts of a bit from mesh files: the [[parts]] of a bit file. Thesis: 3.1.
///   name, kind            letters, digits, - and _, in folders: "cutter-1/face"; as in kind_name
///   file, unit            STL, OBJ, PLY or OFF; length of the file's unit, default 1 mm
///   cutting               default: all but the bit body
///   density               kg/m3; 0: counted in another part; none: the mass is unknown
///   position, rotation_vector  part frame in the bit frame; default: the bit frame. For a cutter's
///                         part without update_direction: the cutter's frame (add_cutters)
///   group                 parts with the same number share frame and update direction
///   blade, zone, under_exposure, wear  of the cutter of a face (CutterLabels)
///   update_direction      (x, 0, z) at azimuth 0. Default: eq. 4.2 for the parts of a cutter, from
///                         its frame (position and rotation_vector) if that is given, otherwise
///                         from the exposure profile; outwards for a gage pad; down for all others
/// Records every mistake at its line: files that are missing or unreadable, meshes that are open,
/// flipped or not manifold, two parts of one name, groups that disagree, no part that cuts,
/// unusual sizes (file_checks.hpp; not with unit_check = "off") and, if densities are required,
/// those that are missing.
PartsFromFiles read_parts(Config& file, DirectionRule directions, InsideRule inside,
                          Densities densities = Densities::as_given);

/// Sets the direction of parts without one from the exposure profile of all parts. Parts of one
/// group get the same direction.
void set_profile_directions(PartsFromFiles& read, DirectionRule directions, InsideRule inside);

// The settings of a bit whose parts come from mesh files.

/// A mesh file and its unit, of [[parts]] and [solids].
struct MeshFile {
  std::string file;
  double unit = 1e-3;

  void visit(FieldVisitor& v) {
    v.path(file, {.name = "file",
                  .need = Need::required,
                  .meaning = "a closed mesh with outward normals (STL, OBJ, PLY or OFF)"});
    unit = mesh::unit_or(file, unit);
    v(unit, {.name = "unit",
             .unit = "m",
             .computed_default = "the unit that the file states, otherwise 1 mm",
             .range = Range::positive(),
             .meaning = "length of the mesh file's unit"});
  }
};

/// The direction in which rock leaves a part, of [[parts]] and [[solids.rules]].
struct PartDirection {
  Vec3 update_direction = Vec3::UnitZ();

  void visit(FieldVisitor& v) {
    v(update_direction, {.name = "update_direction",
                         .computed_default = "by kind, frame and profile",
                         .meaning = "at azimuth 0, (x, 0, z)"});
  }
};

/// [body_design] of a bit whose parts are meshes: the design values that reports state (BladeDimensions).
struct BodyDesign {
  BladeDimensions blades;

  static constexpr TableKey table{"body_design",
                                  "design values of the mesh of a body with blades, for reports"};
  void visit(FieldVisitor& v) {
    v(blades.exposure, {.name = "exposure",
                        .unit = "m",
                        .need = Need::required,
                        .range = Range::positive(),
                        .meaning = "of the cutters' tips above the blades"});
    v(blades.slot_depth, {.name = "slot_depth",
                          .unit = "m",
                          .need = Need::required,
                          .range = Range::positive(),
                          .meaning = "of the junk slots below the cutters' tips"});
    v(blades.junk_slot_area, {.name = "junk_slot_area",
                              .unit = "m2",
                              .need = Need::required,
                              .range = Range::non_negative(),
                              .meaning = "between the blades, across the gage"});
  }
};

/// [[parts]], beside MeshFile, PartDirection and CutterLabels.
struct PartSettings {
  std::string name, kind;
  bool cutting = true, rubs = false;
  double density = 0.0;
  int group = -1;
  Vec3 position = Vec3::Zero(), rotation_vector = Vec3::Zero();

  static constexpr TableKey table{"parts", "a part of the bit from a mesh file", Repeats::yes};
  void visit(FieldVisitor& v) {
    v(name, {.name = "name",
             .need = Need::required,
             .meaning = "letters, digits, - and _, with / between"});
    v.name(kind, {.name = "kind",
                  .names = &part_kind_names,
                  .need = Need::required,
                  .meaning = "what the part is"});
    cutting = part_kind_named(kind) != PartKind::bit_body;
    v(cutting, {.name = "cutting",
                .computed_default = "on, except kind bit-body",
                .meaning = "whether it removes rock"});
    v(rubs,
      {.name = "rubs", .meaning = "not cutting: whether it bears on rock, by the law of its kind"});
    v(density, {.name = "density",
                .unit = "kg/m3",
                .range = any_density,
                .meaning = "all parts or none have one"});
    v(group, {.name = "group",
              .lo = -1,
              .hi = std::numeric_limits<int>::max(),
              .meaning = "parts with one frame and update direction have one group; -1: none"});
    v(position, {.name = "position", .unit = "m", .meaning = "of the part's frame in the bit's"});
    v(rotation_vector,
      {.name = "rotation_vector", .unit = "rad", .meaning = "of the part's frame in the bit's"});
  }
};

/// [solids].
struct SolidSettings : MeshFile {
  static constexpr TableKey table{"solids", "a whole bit in one mesh file, solids by name"};
};

/// [[solids.rules]], besides PartDirection and CutterLabels. Properties that a rule does not give remain open.
struct SolidRuleSettings {
  std::string match;
  std::optional<std::string> name, kind;
  std::optional<bool> cutting, rubs;
  std::optional<double> density;
  std::optional<int> group;
  Vec3 cutter_position = Vec3::Zero(), cutter_rotation_vector = Vec3::Zero();

  static constexpr TableKey table{
      "solids.rules",
      "properties of the solids that match a pattern; later rules override earlier ones",
      Repeats::yes};
  void visit(FieldVisitor& v) {
    v(match, {.name = "match",
              .need = Need::required,
              .meaning = "a name; * stands for any text, ? for any character"});
    v(name,
      {.name = "name", .computed_default = "that of the solid", .meaning = "in place of its own"});
    std::string kind_name;
    v.name(kind_name, {.name = "kind",
                       .names = &part_kind_names,
                       .need = Need::optional,
                       .computed_default = "by its name",
                       .meaning = "what the part is"});
    if (!kind_name.empty()) kind = kind_name;
    v(cutting, {.name = "cutting",
                .computed_default = "on, except bodies and cones",
                .meaning = "whether it removes rock"});
    v(rubs, {.name = "rubs",
             .computed_default = "false",
             .meaning = "not cutting: whether it bears on rock, by the law of its kind"});
    v(density, {.name = "density",
                .unit = "kg/m3",
                .computed_default = "none",
                .range = any_density,
                .meaning = "of the solid"});
    v(group, {.name = "group",
              .computed_default = "by cutter",
              .lo = -1,
              .hi = std::numeric_limits<int>::max(),
              .meaning = "as of parts"});
    // One of the two requires the other.
    const Need need = v.gives("cutter_position") || v.gives("cutter_rotation_vector")
                          ? Need::required
                          : Need::optional;
    v(cutter_position,
      {.name = "cutter_position",
       .unit = "m",
       .need = need,
       .computed_default = "none",
       .meaning = "centre of the face of the solid's cutter; with it a face carries forces"});
    v(cutter_rotation_vector,
      {.name = "cutter_rotation_vector",
       .unit = "rad",
       .need = need,
       .computed_default = "none",
       .meaning = "of the cutter's frame: X out of the face, -Z towards the rock"});
  }
};

/// [[solids.cones]]: a journal, with the cone of all solids named NAME/...
struct SolidConeSettings {
  Cone cone;

  static constexpr TableKey table{
      "solids.cones", "a journal, with the cone of all solids named NAME/...", Repeats::yes};
  void visit(FieldVisitor& v) {
    ConeLayout& c = cone.layout;
    v(cone.name, {.name = "name", .need = Need::required, .meaning = "of the cone: cone-1"});
    v(c.azimuth, {.name = "azimuth",
                  .unit = "rad",
                  .need = Need::required,
                  .meaning = "of the journal about the bit's axis"});
    v(c.journal_angle, {.name = "journal_angle",
                        .unit = "rad",
                        .need = Need::required,
                        .range = Range::within(-1.5, 1.5),
                        .meaning = "of the journal below the horizontal, if the bit is upright"});
    v(c.offset, {.name = "offset",
                 .unit = "m",
                 .range = bit_place,
                 .meaning = "of the journal's axis, in the sense of the bit's rotation"});
    v(c.skew,
      {.name = "skew", .unit = "rad", .meaning = "of the journal's outer end, in the same sense"});
    v(c.apex, {.name = "apex",
               .unit = "m",
               .range = bit_place,
               .meaning = "from the journal's foot to the cone's origin"});
    v(c.foot_height, {.name = "foot_height",
                      .unit = "m",
                      .range = bit_place,
                      .meaning = "of the journal's foot above the bit's origin"});
    v(cone.rolling_ratio, {.name = "rolling_ratio",
                           .range = Range::within(0.0, 10.0),
                           .meaning = "speed of a rolling cone over the bit's; 0: computed from "
                                      "the tooth whose tip is farthest from the bit's axis"});
  }
};

/// Computes the table values of a cutter whose parts are meshes. Its place follows from its frame (the
/// inverse of cutter_pose), its diameter and chamfer from the vertices of face and chamfer. The frame
/// is first moved along X to the front of the face. Returns nothing if the parts have no flat rim
/// normal to X, or if the face does not point forwards.
std::optional<Cutter> cutter_from_meshes(Pose X_BC, const std::vector<Part>& parts);

/// Makes cutters of the faces in bit.parts. A face becomes a cutter if its frame is given
/// (PartsFromFiles::frames), if it is the only face of its group, and if cutter_from_meshes returns
/// one; all parts of the group then belong to the cutter (Part::cutter). Other faces are left without
/// a cutter. Cutters are numbered by the names of their parts ("cutter-12/face") if all these numbers
/// differ, otherwise 1, 2, ... Blade, zone, under-exposure and wear are those of PartsFromFiles::labels.
void add_cutters(const PartsFromFiles& read, Bit& bit);

}  // namespace tdbd::bit
