#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/body/blade_shape.hpp"
#include "bit/cutter/cutter.hpp"
#include "bit/cutter/cutter_table.hpp"
#include "bit/files/file_checks.hpp"
#include "bit/pdc/pdc_bit.hpp"
#include "bit/pdc/pdc_design.hpp"
#include "core/config/config.hpp"
#include "core/config/field.hpp"

namespace tdbd::bit {

// The settings of a bit file: its top level, and the tables of a bit with PDC cutters.

/// What a bit file has before its first table.
struct NameOfBit {
  std::string name;

  static constexpr TableKey table{"", "keys before the first table"};
  void visit(FieldVisitor& v) {
    v(name, {.name = "name", .need = Need::required, .meaning = "of the bit"});
  }
};

/// Of a bit with a cutter table, before the first table.
struct CutterTableFile {
  std::string table_file;

  void visit(FieldVisitor& v) {
    v.path(table_file, {.name = "table",
                        .need = Need::required,
                        .computed_default = "one of table, design, parts, solids, cones",
                        .meaning = "the cutter table (CSV)"});
  }
};

/// m; infinite: no limit, 0: required.
struct GageDiameter {
  double gage_diameter = 0.0;

  void visit(FieldVisitor& v) {
    v(gage_diameter, {.name = "gage_diameter",
                      .unit = "m",
                      .need = gage_diameter > 0.0 ? Need::defaulted : Need::required,
                      .computed_default = "no limit; required with a design",
                      .range = bit_length,
                      .meaning = "no cutter or tooth reaches outside it"});
  }
};

/// Of a bit with a cutter table.
struct TableCheck {
  bool table_check = true;

  void visit(FieldVisitor& v) {
    v(table_check,
      {.name = "table_check",
       .meaning = "table: whether to compare each cutter with its neighbours, and reject rows that "
                  "make no bit"});
  }
};

/// Of a bit of meshes.
struct UnitCheck {
  bool unit_check = true;

  void visit(FieldVisitor& v) {
    v(unit_check,
      {.name = "unit_check",
       .meaning = "parts or solids: whether to reject sizes that are unusual for a bit"});
  }
};

/// [cutters]: the shape of cutters whose row of the table does not give it.
struct CutterSettings {
  CutterDefaults cutters;

  static constexpr TableKey table{"cutters",
                                  "the shape of cutters whose row of the table does not give it"};
  void visit(FieldVisitor& v) {
    v(cutters.chamfer, {.name = "chamfer",
                        .unit = "m",
                        .range = bit_length_or_none,
                        .meaning = "width of the chamfer along the face; 0: sharp"});
    v(cutters.chamfer_angle, {.name = "chamfer_angle",
                              .unit = "rad",
                              .range = Range::within(0.05, 1.5),
                              .meaning = "of the chamfer, from the cutter's axis"});
    v(cutters.length, {.name = "length",
                       .unit = "m",
                       .range = bit_length,
                       .meaning = "of the cutter along its axis"});
    v(cutters.table_thickness, {.name = "table_thickness",
                                .unit = "m",
                                .range = bit_length,
                                .meaning = "of the diamond table"});
    v(cutters.land, {.name = "land",
                     .unit = "m",
                     .range = bit_length_or_none,
                     .meaning = "width of a second chamfer inside the first; 0: none"});
    v(cutters.land_angle, {.name = "land_angle",
                           .unit = "rad",
                           .range = Range::within(0.05, 1.5),
                           .meaning = "of that second chamfer, from the cutter's axis"});
  }
};

/// [mesh] of a bit with cutters.
struct CutterMeshSettings {
  CutterMeshing mesh;

  static constexpr TableKey table{"mesh", "the meshes of cutters"};
  void visit(FieldVisitor& v) {
    v(mesh.grading, {.name = "grading",
                     .values = {{{"graded", Grading::graded}, {"uniform", Grading::uniform}}},
                     .meaning = "fine along the rim, or of one edge length"});
    v(mesh.rim_segments,
      {.name = "rim_segments", .lo = 8, .hi = 4096, .meaning = "edges around a rim; graded"});
    v(mesh.uniform_edge, {.name = "uniform_edge",
                          .unit = "m",
                          .range = bit_length,
                          .meaning = "edge length; uniform"});
  }
};

/// [gage_pads].
struct PadSettings {
  GagePads pads;

  static constexpr TableKey table{"gage_pads", "pads on the gage, equally spaced"};
  void visit(FieldVisitor& v) {
    v(pads.count, {.name = "count", .hi = 64, .meaning = "of pads"});
    v(pads.length,
      {.name = "length", .unit = "m", .range = bit_length, .meaning = "along the bit's axis"});
    v(pads.width,
      {.name = "width", .unit = "m", .range = bit_length, .meaning = "along the circumference"});
    v(pads.under_gage, {.name = "under_gage",
                        .unit = "m",
                        .range = bit_length_or_none,
                        .meaning = "how far pads stay inside the gage radius"});
    v(pads.thickness,
      {.name = "thickness", .unit = "m", .range = bit_length, .meaning = "radial, in the middle"});
    pads.behind = 0.5 * pads.width;
    v(pads.behind,
      {.name = "behind",
       .unit = "m",
       .computed_default = "half of width: the first pad begins at the cutter",
       .range = bit_place,
       .meaning =
           "along the circumference, from the highest cutter back to the first pad's middle"});
  }
};

/// [blades]: a body with blades and junk slots.
struct BladeSettings {
  BladeOptions blades;

  static constexpr TableKey table{"blades", "a body with blades and junk slots"};
  void visit(FieldVisitor& v) {
    bool rubs = true, cuts = false;
    v(blades.exposure, {.name = "exposure",
                        .unit = "m",
                        .need = Need::required,
                        .range = bit_length,
                        .meaning = "of a face cutter's tip over its blade"});
    v(blades.slot_depth, {.name = "slot_depth",
                          .unit = "m",
                          .need = Need::required,
                          .range = bit_length,
                          .meaning = "from a blade's top to the floor of the slot"});
    v(blades.width, {.name = "width",
                     .unit = "m",
                     .range = bit_length_or_none,
                     .meaning = "of a blade's top; 0: as its cutters require"});
    v(blades.wall, {.name = "wall",
                    .unit = "m",
                    .range = bit_length,
                    .meaning = "run of a slot's wall, from top to floor"});
    v(blades.gage_length, {.name = "gage_length",
                           .unit = "m",
                           .range = bit_length,
                           .meaning = "of the blades above the last face cutter"});
    v(blades.neck, {.name = "neck",
                    .unit = "m",
                    .range = bit_length,
                    .meaning = "height over which the gage becomes the shank"});
    v(blades.shank_radius, {.name = "shank_radius",
                            .range = Range::within(0.1, 0.9),
                            .meaning = "over the gage radius"});
    v(blades.shank_length, {.name = "shank_length",
                            .range = Range::within(0.1, 10.0),
                            .meaning = "over the gage radius"});
    v(blades.edge, {.name = "edge",
                    .unit = "m",
                    .range = Range::within(0.0002, 0.05),
                    .meaning = "largest edge of the mesh"});
    v(blades.density,
      {.name = "density", .unit = "kg/m3", .range = any_density, .meaning = "of the body"});
    v(rubs,
      {.name = "rubs",
       .meaning = "whether its clearance is measured, and the law of forces.bit_body acts on it"});
    v(cuts, {.name = "cuts", .meaning = "whether the body removes rock"});
    blades.cutting = cuts ? Cutting::cuts : rubs ? Cutting::rubs : Cutting::never;
  }
};

/// [adjust], [adjust.zone.NAME], [adjust.blade.N] and [adjust.cutter.N]: increments of a cutter's
/// values. N is a number or a range, 22-39.
struct Adjustment {
  double azimuth = 0.0, back_rake = 0.0, side_rake = 0.0;  ///< rad
  double along = 0.0;                                      ///< m

  static constexpr TableKey table{
      "adjust",
      "changes of a layout: of all cutters; of a zone, [adjust.zone.shoulder]; of "
      "[adjust.blade.2] or [adjust.blade.1-3]; of [adjust.cutter.7] or [adjust.cutter.22-39]"};
  void visit(FieldVisitor& v) {
    v(azimuth, {.name = "azimuth", .unit = "rad", .meaning = "turns cutters about the bit's axis"});
    v(back_rake, {.name = "back_rake",
                  .unit = "rad",
                  .meaning = "is added to the back rake",
                  .usual = Range::within(0.0, 1.0)});
    v(side_rake, {.name = "side_rake",
                  .unit = "rad",
                  .meaning = "is added to the side rake",
                  .usual = Range::within(0.0, 1.0)});
    v(along, {.name = "along",
              .unit = "m",
              .meaning = "moves a cutter outwards along its profile's tangent"});
  }
};

/// Makes the cutters that the [design] table of a bit file describes (pdc_generator.hpp). `c`: that
/// table. The gage radius (m) and the cutters' shape are given elsewhere in the file. Mistakes,
/// including those of an impossible design, are recorded in c at their keys; then the result is
/// empty.
std::vector<Cutter> read_design(Config c, double gage_radius, const CutterDefaults& shape);

/// Reads the table [blades] of a bit file, beside a table of cutters or a design. Returns nothing
/// if it is absent. Mistakes are recorded in `file`.
std::optional<BladeOptions> read_blades(Config& file);

/// A value that is legal and probably not intended.
struct BitDoubt {
  std::string place;  ///< "FILE:LINE: KEY"
  std::string key;    ///< or the column of a table
  std::string text;   ///< "found F, expected E"
};

/// Compares the cutters of a table with each other (cutter/table_doubts.hpp), unless table_check is
/// off. Returns what may be intended. If a value makes no bit, all doubts are recorded as mistakes.
std::vector<BitDoubt> check_table(Config& c, const std::string& table,
                                  const std::vector<Cutter>& cutters);

// The following checks depend on the whole table. If they fail, the doubts about its rows are
// recorded as mistakes before their own, because wrong rows are the likely cause.

/// Compares gage_diameter (as a radius, m) with the outermost tip of at least eight. A mistake if
/// the tip is within 80 % of it, or if several tips are outside; adds a doubt within 98 %. Does
/// nothing after other mistakes.
void check_gage(Config& c, const std::string& table, const std::vector<Cutter>& cutters,
                double gage_radius, std::vector<BitDoubt>& doubts);

/// Records, at their keys, the reasons why the pads are impossible for these cutters (pdc_bit.hpp).
/// The gage is that of the outermost tip.
void check_pads(Config& file, const std::vector<Cutter>& cutters, const GagePads& pads,
                std::vector<BitDoubt>& doubts);

/// Records, at their keys, the reasons why the blades are impossible for these cutters
/// (bit/body/blade_body.hpp).
void check_blades(Config& file, const std::vector<Cutter>& cutters, const BladeOptions& blades,
                  std::vector<BitDoubt>& doubts);

/// Reads [adjust] and changes the cutters; changes are added up. Records as mistakes zones, blades
/// and cutters that the bit does not have, and rakes or positions that no cutter can have.
void adjust_cutters(Config adjust, std::vector<Cutter>& cutters);

}  // namespace tdbd::bit
