#pragma once

#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/config/config.hpp"
#include "forces/rock/rock_material.hpp"
#include "mesh/files/length_unit.hpp"
#include "rock/section/breakout.hpp"
#include "rock/start/borehole.hpp"
#include "simulation/case/force_settings.hpp"

namespace tdbd::simulation {

enum class RockShape { conforming, flat, rough, profile, file };
enum class IntersectionCheck { full, none };

/// m: longer than any borehole.
inline constexpr double largest_length = 1e5;

/// [rock]: the rock at the start.
struct RockStart {
  RockShape shape = RockShape::conforming;
  double edge_length = 0.0;   ///< m
  double wall = 0.03;         ///< m, height of the cylindrical wall above the bottom's rim
  double radius = 0.0;        ///< m, only for flat and rough; 0: the bit's gage radius
  rock::Roughness roughness;  ///< only for rough
  std::vector<rock::MeridianPoint> profile;  ///< only for profile: from the axis to the boundary
  std::string file;                          ///< only for file
  double unit = 1e-3;                        ///< m per unit of the file
  IntersectionCheck intersections = IntersectionCheck::full;  ///< only for file and profile
  double trim = 0.0;  ///< m: wall higher than this above the bit's lowest point is removed; 0: none

  static constexpr TableKey table{"rock", "the rock's surface at the start, and its material"};
  void visit(FieldVisitor& v) {
    v(shape,
      {.name = "shape",
       .values = {{{"conforming", RockShape::conforming},
                   {"flat", RockShape::flat},
                   {"rough", RockShape::rough},
                   {"profile", RockShape::profile},
                   {"file", RockShape::file}}},
       .meaning =
           "the bottom: the bit's exposure profile, a plane at the bit's lowest cutting point, "
           "that plane with random roughness, a surface of revolution, or a mesh file"});
    v(edge_length, {.name = "edge_length",
                    .unit = "m",
                    .need = Need::required,
                    .range = Range::within(1e-5, 0.1),
                    .meaning = "target length of the mesh's edges"});
    const bool is_file = shape == RockShape::file, is_profile = shape == RockShape::profile;
    if (v.when(!is_file && !is_profile)) {
      v(wall, {.name = "wall",
               .unit = "m",
               .range = Range::within(0.0, largest_length),
               .meaning = "shapes conforming, flat, rough: height of the cylindrical wall",
               .usual = Range::within(0.0, 10.0)});
    }
    if (v.when(shape == RockShape::flat || shape == RockShape::rough)) {
      v(radius, {.name = "radius",
                 .unit = "m",
                 .range = Range::within(0.0, largest_length),
                 .meaning = "shapes flat, rough: radius of the bottom; 0: the bit's gage radius",
                 .usual = Range::within(0.0, 1.5)});
    }
    if (v.when(shape == RockShape::rough)) {
      v(roughness.amplitude, {.name = "amplitude",
                              .unit = "m",
                              .need = Need::required,
                              .computed_default = "required with shape rough",
                              .range = Range::within(0.0, 1.0),
                              .meaning = "root mean square of the roughness",
                              .usual = Range::within(0.0, 0.2)});
      v(roughness.correlation_length,
        {.name = "correlation_length",
         .unit = "m",
         .need = Need::required,
         .computed_default = "required with shape rough",
         .range = Range::positive(),
         .meaning = "correlation length of the roughness, two edges or more",
         .usual = Range::within(0.0, 0.5)});
      v(roughness.seed, {.name = "seed", .meaning = "shape rough: seed of the random roughness"});
    }
    if (v.when(is_file || is_profile)) visit_given(v);
    v(trim, {.name = "trim",
             .unit = "m",
             .range = Range::non_negative(),
             .meaning = "wall higher than this above the bit's lowest point is removed; 0: none",
             .usual = Range::within(0.0, 10.0)});
  }
  /// A surface that the case gives.
  void visit_given(FieldVisitor& v) {
    if (v.when(shape == RockShape::profile)) {
      std::vector<std::pair<double, double>> points;
      v(points, {.name = "profile",
                 .unit = "m",
                 .need = Need::required,
                 .computed_default = "required with shape profile",
                 .meaning = "[[radius, depth], ...] from the axis to the boundary"});
      profile.clear();
      for (const auto& [r, z] : points) profile.push_back({r, z});
    }
    if (v.when(shape == RockShape::file)) {
      v.path(file,
             {.name = "file",
              .need = Need::required,
              .computed_default = "required with shape file",
              .meaning = "the mesh, an open sheet: z points down, into the rock, and facets face "
                         "up, out of the rock (tdbd mesh --sheet)"});
      unit = mesh::unit_or(file, unit);
      v(unit, {.name = "unit",
               .unit = "m",
               .computed_default = "the unit that the file states, otherwise 1 mm",
               .range = Range::positive(),
               .meaning = "shape file: length of the mesh file's unit"});
    }
    v(intersections,
      {.name = "intersection_check",
       .values = {{{"on", IntersectionCheck::full}, {"off", IntersectionCheck::none}}},
       .meaning = "shapes file and profile: whether to refuse a surface that intersects itself"});
  }
};

/// The conditions around the rock at the bottom of the hole, in [rock].
struct Surroundings {
  forces::BottomHole hole;
  forces::Confinement confinement = forces::Confinement::permeable;

  /// Pa: ten times the pressure in the deepest well, and the strength of diamond.
  static constexpr Range any_pressure = Range::within(0.0, 1e10);

  void visit(FieldVisitor& v) {
    v(hole.pressure, {.name = "pressure",
                      .unit = "Pa",
                      .range = any_pressure,
                      .meaning = "of the mud at the bottom of the hole"});
    visit_without_mud(v);
  }
  void visit_without_mud(FieldVisitor& v) {
    v(hole.pore_pressure, {.name = "pore_pressure",
                           .unit = "Pa",
                           .range = any_pressure,
                           .meaning = "in the rock's pores"});
    v(hole.overburden, {.name = "overburden",
                        .unit = "Pa",
                        .range = any_pressure,
                        .meaning = "pressure of the rock above"});
    v(confinement, {.name = "confinement",
                    .values = {{{"permeable", forces::Confinement::permeable},
                                {"impermeable", forces::Confinement::impermeable},
                                {"by-porosity", forces::Confinement::by_porosity}}},
                    .meaning = "which pressure confines the rock at the bottom"});
  }
};

/// The position of the beds, in [rock].
struct Bedding {
  double dip = 0.0, azimuth = 0.0;

  void visit(FieldVisitor& v) {
    v(dip, {.name = "dip",
            .unit = "rad",
            .range = Range::within(0.0, 0.5 * std::numbers::pi),
            .meaning = "angle of the beds with the horizontal"});
    v(azimuth,
      {.name = "dip_azimuth", .unit = "rad", .meaning = "direction of the dip of the beds"});
  }
};

/// A rock of the table of rocks.
struct NamedRock {
  std::string material;

  static std::vector<std::string_view> names();
  void visit(FieldVisitor& v) {
    v.name(material, {.name = "material",
                      .names = &NamedRock::names,
                      .need = Need::required,
                      .computed_default = "required with forces",
                      .meaning = "a rock of the table of rocks, or a table [rock.material]"});
  }
};

/// [rock.material]: a rock defined by its properties.
struct RockByNumbers {
  forces::RockMaterial material{.name = "given by the case"};

  static constexpr TableKey table{
      "rock.material",
      "a rock defined by its properties, in place of rock.material or rock.layers.material"};
  static constexpr Range any_strength{.lo = 0.0, .hi = 1e12, .ends = Range::Ends::open_lo};
  void visit(FieldVisitor& v) {
    v(material.name, {.name = "name", .meaning = "of the rock, in the results"});
    v(material.unconfined, {.name = "unconfined_strength",
                            .unit = "Pa",
                            .need = Need::required,
                            .range = any_strength,
                            .meaning = "unconfined compressive strength",
                            .usual = Range::within(5e5, 2e9)});
    v(material.friction_angle, {.name = "friction_angle",
                                .unit = "rad",
                                .need = Need::required,
                                .range = Range::within(0.0, std::numbers::pi / 3.0),
                                .meaning = "internal friction (Mohr and Coulomb)"});
    // Pumice, the most porous rock, has 0.9.
    v(material.porosity, {.name = "porosity",
                          .range = Range::within(0.0, 0.9),
                          .meaning = "effective porosity; confinement by-porosity"});
  }
};

/// [[rock.layers]]: a bed below the first one.
struct RockLayer {
  double top = 0.0;

  static constexpr TableKey table{"rock.layers", "beds below the first one, from above",
                                  Repeats::yes};
  void visit(FieldVisitor& v) {
    v(top, {.name = "top",
            .unit = "m",
            .need = Need::required,
            .meaning = "top of the bed, along the normal of the beds"});
  }
};

/// Reads [rock]. Records mistakes.
RockStart read_rock(Config& whole);

/// Reads a rock by its name from the table of rocks, or by its properties from [material].
forces::RockMaterial read_material(Config& c);

/// Whether [rock] must define the materials of its beds.
enum class BedMaterial { read, unknown };

/// A bed of the formation.
struct Bed {
  forces::RockMaterial material;    ///< without a name if unknown
  double confining_pressure = 0.0;  ///< Pa, at the bottom of the hole
};

/// Reads the beds of [rock], downward; only the first one if there are no materials. Records
/// mistakes.
std::vector<Bed> read_beds(Config c, BedMaterial material);

/// Reads the material, pressures and layers of [rock]. Records mistakes.
forces::Formation read_formation(Config c);

/// [spalling]: rock that breaks out around the faces of cutters.
struct BreakoutSettings {
  rock::BreakoutRule rule;
  double up_to_pressure = 1e6;

  static constexpr TableKey table{
      "spalling", "rock that breaks out around the faces of cutters (off without it)"};
  void visit(FieldVisitor& v) {
    visit_rule(v, rule.angle, rule.depth_share, rule.ahead_share, Need::required);
    v(up_to_pressure, {.name = "up_to_pressure",
                       .unit = "Pa",
                       .range = Range::non_negative(),
                       .meaning = "confining pressure above which no rock breaks out; assumed"});
  }

  /// `Value`: double, or std::optional<double> if an area may omit it.
  template <class Value>
  static void visit_rule(FieldVisitor& v, Value& angle, Value& depth_share, Value& ahead_share,
                         Need angle_need) {
    v(angle, {.name = "angle",
              .unit = "rad",
              .need = angle_need,
              .meaning = "between a crack and the normal of the bit's profile, in (0, 90) degrees: "
                         "0 is the wall of a groove, 90 degrees the free surface"});
    v(depth_share, {.name = "depth_share",
                    .range = Range::within(0.0, 1.0),
                    .meaning = "share of the engaged depth, from the free surface down, in which "
                               "cracks start; 0: no rock breaks out beside the face"});
    v(ahead_share, {.name = "ahead_share",
                    .range = Range::within(0.0, 0.95),
                    .meaning = "share of the engaged depth, from the free surface down, that chips "
                               "off ahead of a face, which then cuts what is left"});
  }
};

/// The rock that breaks out, in [spalling].
struct BreakingMaterial {
  std::optional<std::string> material;

  void visit(FieldVisitor& v) {
    v(material, {.name = "material",
                 .computed_default = "any",
                 .meaning = "the rock that breaks out, by its name in [rock]"});
  }
};

/// [spalling.areas.NAME]: another rule for the faces of an area.
struct BreakoutArea {
  std::optional<double> angle, depth_share, ahead_share;

  static constexpr TableKey table{
      "spalling.areas.NAME",
      "another angle or other shares for the faces that meet all criteria given here; of several "
      "areas the one with the most specific criterion decides each of them"};
  void visit(FieldVisitor& v) {
    BreakoutSettings::visit_rule(v, angle, depth_share, ahead_share, Need::optional);
  }
};

/// Rock that breaks out beside faces.
struct SpallingPlan {
  std::vector<std::optional<rock::BreakoutRule>> rules;  ///< per cutter; empty: no rock breaks out
  std::vector<std::uint8_t> beds;  ///< per bed of the formation: whether its rock breaks out
};

/// Whether rock breaks out beside any face.
inline bool spalls(const SpallingPlan& plan) { return !plan.rules.empty(); }

/// Whether any rock breaks out.
inline bool breaks_out(const rock::BreakoutRule& rule) {
  return rule.depth_share > 0.0 || rule.ahead_share > 0.0;
}

/// Reads the rule and the pressure of [spalling]. Records an angle outside (0, 90) degrees as a
/// mistake.
BreakoutSettings read_breakout_rule(Config& c);

/// Reads [spalling] and [spalling.areas.NAME]. Without the table, no rock breaks out. If every bed
/// is confined by more than up_to_pressure, no rock breaks out, either; this is a warning. Records
/// as mistakes: those of bit::read_areas, two areas of equal rank that disagree, an area with a
/// part that is not the face of a cutter, an area without a property, an angle outside (0, 90)
/// degrees or one that the update direction of a face cannot follow, a material that is not in
/// [rock], a bit without faces of cutters, and sections that are off.
SpallingPlan read_spalling(Config& whole, const bit::Bit& bit, const MeasurePlan& measure,
                           const ForcePlan& forces, std::vector<CaseWarning>& warnings);

}  // namespace tdbd::simulation
