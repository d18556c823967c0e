#pragma once

#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bit/bit.hpp"
#include "bit/files/file_checks.hpp"
#include "core/config/config.hpp"
#include "core/config/field.hpp"

namespace tdbd::bit {

// The settings of a roller cone bit.

/// Whether cones may overlap one another and legs.
enum class Interference { refuse, report };

/// Before the first table.
struct InterferenceSetting {
  Interference interference = Interference::refuse;

  void visit(FieldVisitor& v) {
    v(interference,
      {.name = "interference",
       .values = {{{"refuse", Interference::refuse}, {"report", Interference::report}}},
       .meaning = "whether cones may overlap one another and legs"});
  }
};

/// [journal]: the journals of all cones; a cone may have its own values, of which it names the
/// journal's angle differently.
struct JournalSettings {
  ConeLayout cone;

  static constexpr TableKey table{"journal",
                                  "the journals of all cones; a cone may have its own values"};
  void visit(FieldVisitor& v) { visit_as(v, "angle", ""); }
  void visit_as(FieldVisitor& v, std::string_view name_of_angle,
                std::string_view computed_default) {
    v(cone.journal_angle,
      {.name = name_of_angle,
       .unit = "rad",
       .computed_default = computed_default,
       .range = Range::within(0.0, 0.5 * std::numbers::pi),
       .meaning = "of the journal below the horizontal, if the bit is upright"});
    v(cone.offset, {.name = "offset",
                    .unit = "m",
                    .range = bit_place,
                    .meaning = "of the journal's axis, in the sense of the bit's rotation"});
    v(cone.skew, {.name = "skew",
                  .unit = "rad",
                  .range = Range::within(-0.5 * std::numbers::pi, 0.5 * std::numbers::pi),
                  .meaning = "of the journal's outer end, in the same sense"});
    v(cone.apex, {.name = "apex",
                  .unit = "m",
                  .range = bit_place,
                  .meaning = "from the journal's foot to the cone's origin"});
    v(cone.foot_height, {.name = "foot_height",
                         .unit = "m",
                         .range = bit_place,
                         .meaning = "of the journal's foot above the bit's origin"});
  }
};

/// [teeth], and any of its keys in [[cones.rows]].
struct ToothSettings {
  ToothShape shape;

  static constexpr std::array<ChoiceKey<ToothKind>::Named, 8> kinds{
      {{"milled-chisel", ToothKind::milled_chisel},
       {"hemispherical", ToothKind::hemispherical},
       {"conical", ToothKind::conical},
       {"chisel", ToothKind::chisel}}};

  static constexpr TableKey table{"teeth", "the teeth of all rows; a row may have its own values"};
  void visit(FieldVisitor& v) {
    v(shape.kind, {.name = "kind", .values = kinds, .meaning = "the form of the teeth"});
    v(shape.diameter, {.name = "diameter",
                       .unit = "m",
                       .range = bit_length,
                       .meaning = "of an insert's shank; a milled tooth's length at the shell"});
    v(shape.width, {.name = "width",
                    .unit = "m",
                    .range = bit_length,
                    .meaning = "milled: along the circumference, at the shell"});
    v(shape.protrusion, {.name = "protrusion",
                         .unit = "m",
                         .range = bit_length,
                         .meaning = "of the tip above the shell"});
    v(shape.crest_length, {.name = "crest_length",
                           .unit = "m",
                           .range = bit_length,
                           .meaning = "chisels: of the crest"});
    v(shape.crest_width, {.name = "crest_width",
                          .unit = "m",
                          .range = bit_length,
                          .meaning = "chisels: of the crest"});
    v(shape.tip_radius,
      {.name = "tip_radius", .unit = "m", .range = bit_length, .meaning = "conical: of the tip"});
    v(shape.embedding, {.name = "embedding",
                        .unit = "m",
                        .range = bit_length,
                        .meaning = "depth of the tooth below the shell"});
    v(shape.half_angle, {.name = "half_angle",
                         .unit = "rad",
                         .range = Range::within(0.05, 1.5),
                         .meaning = "conical: of the cone"});
    v(shape.density,
      {.name = "density", .unit = "kg/m3", .range = any_density, .meaning = "of the teeth"});
  }
};

/// [mesh] of a bit with cones.
struct ConeMeshSettings {
  int segments = ConeLayout::usual_segments, facets = ConeLayout::usual_facets;

  static constexpr TableKey table{"mesh", "the meshes of cones and teeth"};
  void visit(FieldVisitor& v) {
    v(segments, {.name = "segments", .lo = 8, .hi = 4096, .meaning = "around the shell's mesh"});
    v(facets, {.name = "facets",
               .lo = 8,
               .hi = 128,
               .meaning = "around an insert's mesh, a multiple of 4"});
  }
};

/// [[cones]], beside their journals.
struct ConeSettings {
  double azimuth = 0.0, density = ConeLayout::usual_density;
  bool body_cuts = false;
  std::vector<std::pair<double, double>> shell;

  static constexpr TableKey table{"cones", "a cone with its rows of teeth", Repeats::yes};
  void visit(FieldVisitor& v) {
    v(azimuth, {.name = "azimuth",
                .unit = "rad",
                .need = Need::required,
                .meaning = "of the journal about the bit's axis"});
    v(density,
      {.name = "density", .unit = "kg/m3", .range = any_density, .meaning = "of the shell"});
    v(body_cuts,
      {.name = "body_cuts",
       .meaning = "whether the shell crushes rock that remains between the prints of teeth"});
    v(shell, {.name = "shell",
              .unit = "m",
              .need = Need::required,
              .meaning = "[[s, radius], ...] from the nose to the base"});
  }
};

/// The journal of one cone, in [[cones]].
struct ConeJournal {
  JournalSettings journal;

  void visit(FieldVisitor& v) { journal.visit_as(v, "journal_angle", "that of [journal]"); }
};

/// [[cones.rows]], beside the keys of [teeth].
struct ToothRowSettings {
  ToothRow row;
  long teeth = 0;
  double first_angle = 0.0;
  std::vector<double> spacing;

  static constexpr TableKey table{"cones.rows", "a row of equal teeth; also any key of [teeth]",
                                  Repeats::yes};
  void visit(FieldVisitor& v) {
    bool gage = false;
    v(row.s, {.name = "s",
              .unit = "m",
              .need = Need::required,
              .range = bit_place,
              .meaning = "place of the row on the shell"});
    v(row.sink, {.name = "sink",
                 .unit = "m",
                 .range = bit_place,
                 .meaning = "how far the teeth's origins lie below the shell"});
    v(row.lean, {.name = "lean",
                 .unit = "rad",
                 .range = Range::within(-0.5 * std::numbers::pi, 0.5 * std::numbers::pi),
                 .meaning = "of the teeth from the shell's normal"});
    v(gage, {.name = "gage", .meaning = "whether it is a gage row"});
    row.place = gage ? RowPlace::gage : RowPlace::inner;
    const bool by_angles = v.gives("angles");
    if (v.when(by_angles)) {
      v(row.angles, {.name = "angles",
                     .unit = "rad",
                     .computed_default = "in place of teeth",
                     .meaning = "of the teeth about the journal"});
    }
    if (v.when(!by_angles)) {
      v(teeth, {.name = "teeth",
                .need = Need::required,
                .computed_default = "required without angles",
                .lo = 1,
                .hi = 1000,
                .meaning = "how many"});
      v(first_angle, {.name = "first_angle", .unit = "rad", .meaning = "of the first tooth"});
      v(spacing, {.name = "spacing",
                  .computed_default = "equal spaces",
                  .meaning = "ratios of the spaces between teeth, repeated"});
    }
  }
};

/// [shank]: the steel above the cones.
struct ShankSettings {
  Shank shank{.length = 0.1, .height = 0.1};

  static constexpr TableKey table{"shank", "the steel above the cones, a cylinder that never cuts"};
  void visit(FieldVisitor& v) {
    v(shank.radius,
      {.name = "radius", .unit = "m", .range = bit_length_or_none, .meaning = "0: none"});
    v(shank.length,
      {.name = "length", .unit = "m", .range = bit_length, .meaning = "along the axis"});
    v(shank.height, {.name = "height",
                     .unit = "m",
                     .range = bit_place,
                     .meaning = "of its lower end above the bit's origin"});
    v(shank.density,
      {.name = "density", .unit = "kg/m3", .range = any_density, .meaning = "of the steel"});
  }
};

/// [legs].
struct LegSettings {
  Legs legs;

  static constexpr TableKey table{"legs", "the legs that carry the journals, one for each cone"};
  void visit(FieldVisitor& v) {
    bool rubs = true;
    v(legs.width, {.name = "width",
                   .unit = "m",
                   .need = Need::required,
                   .range = bit_length,
                   .meaning = "of a leg, across its journal"});
    v(legs.under_gage, {.name = "under_gage",
                        .unit = "m",
                        .range = bit_length_or_none,
                        .meaning = "how far the outer side is inside the gage"});
    v(legs.clearance, {.name = "clearance",
                       .unit = "m",
                       .range = bit_length,
                       .meaning = "from the base of the shell to the leg"});
    v(legs.tip_radius, {.name = "tip_radius",
                        .unit = "m",
                        .computed_default = "that of the shell's base",
                        .range = bit_length,
                        .meaning = "of the shirttail, about the journal"});
    v(legs.shoulder,
      {.name = "shoulder",
       .unit = "m",
       .computed_default = "shank.height",
       .range = bit_length,
       .meaning = "height above the bit's origin at which the outer side leaves the gage"});
    v(legs.top,
      {.name = "top",
       .unit = "m",
       .computed_default = "the middle of the shank",
       .range = bit_length,
       .meaning = "height above the bit's origin at which the outer side meets the shank"});
    v(legs.density,
      {.name = "density", .unit = "kg/m3", .range = any_density, .meaning = "of the steel"});
    v(rubs, {.name = "rubs",
             .meaning = "whether legs and their inserts press on rock by the laws of "
                        "forces.bit_body and forces.gage_pad"});
    v(legs.inserts,
      {.name = "inserts", .hi = 64, .meaning = "in the outer side of each leg, in a column"});
    v(legs.insert_diameter,
      {.name = "insert_diameter", .unit = "m", .range = bit_length, .meaning = "of an insert"});
    v(legs.insert_length,
      {.name = "insert_length", .unit = "m", .range = bit_length, .meaning = "of an insert"});
    v(legs.insert_protrusion,
      {.name = "insert_protrusion",
       .unit = "m",
       .range = bit_length_or_none,
       .meaning = "of the flat face of an insert out of the leg, in its middle"});
    legs.cutting = rubs ? Cutting::rubs : Cutting::never;
  }
};

/// Builds a roller cone bit from the [[cones]] of a bit file. Thesis: 1.2, 3.1, fig. 3.5. Lengths
/// and angles are quantities. Those of [journal] and [teeth] are defaults for every cone and every
/// row.
///   gage_diameter           cones with a gage row are placed so that it reaches this; optional
///   interference            "refuse" (default) or "report" overlaps of cones with cones and legs
///   [journal]  angle, offset, skew, apex, foot_height      as in ConeLayout
///   [teeth]    kind, diameter, width, protrusion, crest_length, crest_width, tip_radius,
///              half_angle, embedding, density              as in ToothShape
///   [mesh]     segments, facets
///   [shank]    radius, length, height, density             no shank without a radius
///   [legs]     width, under_gage, clearance, tip_radius, shoulder, top, density, rubs, inserts,
///              insert_diameter, insert_length, insert_protrusion    as in Legs; requires a shank
///   [[cones]]  azimuth, journal_angle, offset, skew, apex, foot_height, density, body_cuts
///              (default false; true: the body crushes the rock left between prints), and
///              shell = [[s, r], ...] from the nose to the base, s outwards along the journal
///   [[cones.rows]]  s, sink, lean, gage; angles = [...], or teeth, first_angle and
///              spacing = [...] (ratios, repeated); and any key of [teeth]
/// Records every mistake at its line, finishes reading and builds the bit. Throws InputError.
Bit read_cone_bit(Config& file, const std::string& name);

/// Returns every kind of tooth with its name in a bit file.
std::vector<std::pair<std::string, ToothKind>> tooth_kinds();

/// Returns a roller cone bit as the text of a bit file, in SI, including its cones' positions along
/// their journals and their height. read_bit builds the same bit from it, up to rounding, and its
/// cones turn. Overlaps of neighbouring cones are reported, not refused, because the bit was built
/// with them.
std::string cone_bit_text(const Bit& bit);

}  // namespace tdbd::bit
