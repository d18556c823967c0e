#pragma once

#include <limits>
#include <numbers>
#include <string_view>
#include <vector>

#include "core/config/key.hpp"
#include "forces/rock/rock_material.hpp"

namespace tdbd::simulation {

enum class RockShape { conforming, flat, rough, profile, file };
enum class IntersectionCheck { full, none };

/// The keys of [rock]: its surface at the start.
namespace rock_keys {

/// m: no borehole is longer.
inline constexpr double largest_length = 1e5;

inline constexpr TableKey table{"rock", "the rock's surface at the start, and its material"};

inline constexpr ChoiceKey<RockShape> shape{
    .name = "shape",
    .values = {{{"conforming", RockShape::conforming},
                {"flat", RockShape::flat},
                {"rough", RockShape::rough},
                {"profile", RockShape::profile},
                {"file", RockShape::file}}},
    .fallback = RockShape::conforming,
    .meaning =
        "the bottom: the bit's exposure profile, a plane at the bit's lowest cutting point, "
        "that plane with random roughness, a surface of revolution, or a mesh file"};
inline constexpr QuantityKey edge_length{.name = "edge_length",
                                         .unit = "m",
                                         .range = Range::within(1e-5, 0.1),
                                         .meaning = "target length of the mesh's edges"};
inline constexpr QuantityKey trim{
    .name = "trim",
    .unit = "m",
    .fallback = 0.0,
    .range = Range::non_negative(),
    .meaning = "wall higher than this above the bit's lowest point is removed; 0: none is"};
inline constexpr PathKey file{
    .name = "file", .usual = "required with shape file", .meaning = "the mesh"};
inline constexpr QuantityKey unit{.name = "unit",
                                  .unit = "m",
                                  .fallback = 1e-3,
                                  .range = Range::positive(),
                                  .meaning = "shape file: length of the mesh file's unit"};
inline constexpr PairsKey profile{
    .name = "profile",
    .unit = "m",
    .usual = "required with shape profile",
    .meaning = "[[radius, depth], ...] from the axis to the boundary"};
inline constexpr ChoiceKey<IntersectionCheck> intersection_check{
    .name = "intersection_check",
    .values = {{{"on", IntersectionCheck::full}, {"off", IntersectionCheck::none}}},
    .fallback = IntersectionCheck::full,
    .meaning = "shapes file and profile: whether to refuse a surface that intersects itself"};
inline constexpr QuantityKey wall{
    .name = "wall",
    .unit = "m",
    .fallback = 0.03,
    .range = Range::within(0.0, largest_length),
    .meaning = "shapes conforming, flat, rough: height of the cylindrical wall"};
inline constexpr QuantityKey radius{
    .name = "radius",
    .unit = "m",
    .fallback = 0.0,
    .range = Range::within(0.0, largest_length),
    .meaning = "shapes flat, rough: radius of the bottom; 0: the bit's gage radius"};
inline constexpr QuantityKey amplitude{.name = "amplitude",
                                       .unit = "m",
                                       .usual = "required with shape rough",
                                       .range = Range::within(0.0, 1.0),
                                       .meaning = "root mean square of the roughness"};
inline constexpr QuantityKey correlation_length{
    .name = "correlation_length",
    .unit = "m",
    .usual = "required with shape rough",
    .range = Range::positive(),
    .meaning = "correlation length of the roughness, two edges or more"};
inline constexpr IntegerKey seed{
    .name = "seed", .fallback = 1, .meaning = "shape rough: seed of the random roughness"};

}  // namespace rock_keys

/// The keys of [rock] and [[rock.layers]] that describe the rock as a material; read with [forces].
namespace formation_keys {

/// Pa: ten times what the deepest well has, and what diamond bears.
inline constexpr Range any_pressure = Range::within(0.0, 1e10);
inline constexpr Range any_strength{.lo = 0.0, .hi = 1e12, .ends = Range::Ends::open_lo};

inline constexpr TableKey layers{"rock.layers", "beds below the first one, from above",
                                 Repeats::yes};
inline constexpr TableKey material_table{
    "rock.material", "a rock by its numbers, in place of rock.material or rock.layers.material"};

/// The names of the table of rocks.
inline std::vector<std::string_view> rock_names() {
  std::vector<std::string_view> names;
  for (const forces::KnownRock& rock : forces::known_rocks()) names.push_back(rock.name);
  return names;
}

inline constexpr NameKey material{
    .name = "material",
    .names = &rock_names,
    .usual = "required with forces",
    .meaning = "a rock of the table of rocks, or a table [rock.material]"};
inline constexpr QuantityKey pressure{.name = "pressure",
                                      .unit = "Pa",
                                      .fallback = 0.0,
                                      .range = any_pressure,
                                      .meaning = "of the mud at the bottom of the hole"};
inline constexpr QuantityKey pore_pressure{.name = "pore_pressure",
                                           .unit = "Pa",
                                           .fallback = 0.0,
                                           .range = any_pressure,
                                           .meaning = "in the rock's pores"};
inline constexpr QuantityKey overburden{.name = "overburden",
                                        .unit = "Pa",
                                        .fallback = 0.0,
                                        .range = any_pressure,
                                        .meaning = "pressure of the rock above"};
inline constexpr ChoiceKey<forces::Confinement> confinement{
    .name = "confinement",
    .values = {{{"permeable", forces::Confinement::permeable},
                {"impermeable", forces::Confinement::impermeable},
                {"by-porosity", forces::Confinement::by_porosity}}},
    .fallback = forces::Confinement::permeable,
    .meaning = "which pressure confines the rock at the bottom"};
inline constexpr QuantityKey dip{.name = "dip",
                                 .unit = "rad",
                                 .fallback = 0.0,
                                 .range = Range::within(0.0, 0.5 * std::numbers::pi),
                                 .meaning = "angle of the beds with the horizontal"};
inline constexpr QuantityKey dip_azimuth{.name = "dip_azimuth",
                                         .unit = "rad",
                                         .fallback = 0.0,
                                         .meaning = "direction in which the beds go down"};
inline constexpr QuantityKey top{
    .name = "top", .unit = "m", .meaning = "top of the bed, along the normal of the beds"};

inline constexpr TextKey name{
    .name = "name", .fallback = "given by the case", .meaning = "of the rock, in the results"};
inline constexpr QuantityKey unconfined_strength{.name = "unconfined_strength",
                                                 .unit = "Pa",
                                                 .range = any_strength,
                                                 .meaning = "unconfined compressive strength"};
inline constexpr QuantityKey friction_angle{.name = "friction_angle",
                                            .unit = "rad",
                                            .range = Range::within(0.0, std::numbers::pi / 3.0),
                                            .meaning = "internal friction (Mohr and Coulomb)"};
/// Pumice, the most porous rock, has 0.9.
inline constexpr QuantityKey porosity{.name = "porosity",
                                      .fallback = forces::default_porosity,
                                      .range = Range::within(0.0, 0.9),
                                      .meaning = "effective porosity; confinement by-porosity"};

}  // namespace formation_keys

}  // namespace tdbd::simulation
