#pragma once

#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "core/config/config.hpp"
#include "forces/rock/rock_material.hpp"
#include "rock/start/borehole.hpp"

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
               .meaning = "shapes conforming, flat, rough: height of the cylindrical wall"});
    }
    if (v.when(shape == RockShape::flat || shape == RockShape::rough)) {
      v(radius, {.name = "radius",
                 .unit = "m",
                 .range = Range::within(0.0, largest_length),
                 .meaning = "shapes flat, rough: radius of the bottom; 0: the bit's gage radius"});
    }
    if (v.when(shape == RockShape::rough)) {
      v(roughness.amplitude, {.name = "amplitude",
                              .unit = "m",
                              .need = Need::required,
                              .usual = "required with shape rough",
                              .range = Range::within(0.0, 1.0),
                              .meaning = "root mean square of the roughness"});
      v(roughness.correlation_length,
        {.name = "correlation_length",
         .unit = "m",
         .need = Need::required,
         .usual = "required with shape rough",
         .range = Range::positive(),
         .meaning = "correlation length of the roughness, two edges or more"});
      v(roughness.seed, {.name = "seed", .meaning = "shape rough: seed of the random roughness"});
    }
    if (v.when(is_file || is_profile)) visit_given(v);
    v(trim, {.name = "trim",
             .unit = "m",
             .range = Range::non_negative(),
             .meaning = "wall higher than this above the bit's lowest point is removed; 0: none"});
  }
  /// A surface that the case gives.
  void visit_given(FieldVisitor& v) {
    if (v.when(shape == RockShape::profile)) {
      std::vector<std::pair<double, double>> points;
      v(points, {.name = "profile",
                 .unit = "m",
                 .need = Need::required,
                 .usual = "required with shape profile",
                 .meaning = "[[radius, depth], ...] from the axis to the boundary"});
      profile.clear();
      for (const auto& [r, z] : points) profile.push_back({r, z});
    }
    if (v.when(shape == RockShape::file)) {
      v.path(file, {.name = "file",
                    .need = Need::required,
                    .usual = "required with shape file",
                    .meaning = "the mesh"});
      v(unit, {.name = "unit",
               .unit = "m",
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
                      .usual = "required with forces",
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
                            .meaning = "unconfined compressive strength"});
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

}  // namespace tdbd::simulation
