#pragma once

#include "core/config/key.hpp"
#include "dynamics/drilling/drilling_system.hpp"
#include "simulation/case/motion_keys.hpp"

namespace tdbd::simulation {

namespace string_keys {

inline constexpr TableKey table{"string", "drilling: the drill string, from the bit to the top"};

/// Of a spring, a damper or a mass: none unless given.
constexpr QuantityKey part(std::string_view name, std::string_view unit, std::string_view meaning) {
  return {.name = name, .unit = unit, .fallback = 0.0, .range = up_to_largest, .meaning = meaning};
}

inline constexpr QuantityKey mass = part("mass", "kg", "of string that moves with the bit");
inline constexpr QuantityKey bending_inertia =
    part("bending_inertia", "kg m2", "of that string, about the horizontal axes");
inline constexpr QuantityKey torsional_inertia =
    part("torsional_inertia", "kg m2", "of that string, about the bit's axis");
inline constexpr QuantityKey lateral_stiffness =
    part("lateral_stiffness", "N/m", "against sideways displacement");
inline constexpr QuantityKey axial_stiffness =
    part("axial_stiffness", "N/m", "against displacement along z");
inline constexpr QuantityKey bending_stiffness =
    part("bending_stiffness", "N m/rad", "against leaning");
inline constexpr QuantityKey torsional_stiffness =
    part("torsional_stiffness", "N m/rad", "against twist relative to the top");
inline constexpr QuantityKey lateral_damping =
    part("lateral_damping", "N s/m", "of sideways motion");
inline constexpr QuantityKey axial_damping = part("axial_damping", "N s/m", "of motion along z");
inline constexpr QuantityKey bending_damping = part("bending_damping", "N m s/rad", "of leaning");
inline constexpr QuantityKey torsional_damping =
    part("torsional_damping", "N m s/rad", "of rotation");
inline constexpr QuantityKey bearing_damping =
    part("bearing_damping", "N m s/rad", "of the cones' bearings");
inline constexpr ChoiceKey<dynamics::DamperEnd> dampers_to{
    .name = "dampers_to",
    .values = {{{"top", dynamics::DamperEnd::top}, {"space", dynamics::DamperEnd::space}}},
    .fallback = dynamics::DamperEnd::top,
    .meaning = "what dampers pull towards: the motion of the top, or rest"};
inline constexpr QuantityKey attachment_height{
    .name = "attachment_height",
    .unit = "m",
    .usual = "the bit's centre of mass",
    .range = Range::within(-100.0, 100.0),
    .meaning =
        "height above the bit's origin of the point at which lateral and axial springs, dampers "
        "and the load act; 0: the nose. A bit that hangs from a point below its centre of mass "
        "topples unless its bending stiffness holds it"};
inline constexpr QuantityKey gravity{.name = "gravity",
                                     .unit = "m/s2",
                                     .fallback = 9.80665,
                                     .range = Range::within(0.0, 100.0),
                                     .meaning = "along +z"};

}  // namespace string_keys

/// What keeps the bit in its hole.
enum class WallModel {
  ring,  ///< a circle that a ring of the bit touches: casing, or a hole that stays as it is
  rock,  ///< the rock that the bit cuts; gage pads press on it by the law of friction
};

namespace wall_keys {

inline constexpr TableKey table{
    "wall", "drilling: the wall of the hole: a circle that a ring of the bit touches, or the rock"};

inline constexpr ChoiceKey<WallModel> model{
    .name = "model",
    .values = {{{"ring", WallModel::ring}, {"rock", WallModel::rock}}},
    .fallback = WallModel::ring,
    .meaning =
        "ring: a circle of fixed clearance, which does not learn what the bit cuts. rock: gage "
        "pads follow the law \"friction\" at the strength of the rock, unless "
        "[forces.gage_pad] gives another law; of the keys below, friction and slip_speed"};
inline constexpr QuantityKey stiffness{.name = "stiffness",
                                       .unit = "N/m",
                                       .usual = "required with model ring",
                                       .range = above_zero_to_largest,
                                       .meaning = "of the wall"};
inline constexpr QuantityKey clearance{.name = "clearance",
                                       .unit = "m",
                                       .usual = "required with model ring",
                                       .range = Range::within(0.0, 10.0),
                                       .meaning = "radius of the hole less that of the ring"};
inline constexpr QuantityKey ring_radius{.name = "ring_radius",
                                         .unit = "m",
                                         .usual = "the bit's gage radius",
                                         .range = {0.0, 10.0, Range::Ends::open_lo},
                                         .meaning = "of the ring"};
inline constexpr QuantityKey ring_height{.name = "ring_height",
                                         .unit = "m",
                                         .fallback = 0.0,
                                         .range = Range::within(-100.0, 100.0),
                                         .meaning = "of the ring above the bit's origin"};
inline constexpr QuantityKey restitution{.name = "restitution",
                                         .fallback = dynamics::Wall{}.restitution,
                                         .range = Range::within(0.0, 1.0),
                                         .meaning = "speed after an impact over that before it"};
inline constexpr QuantityKey friction{.name = "friction",
                                      .fallback = dynamics::Wall{}.friction,
                                      .range = Range::within(0.0, 10.0),
                                      .meaning = "Coulomb's coefficient along the wall"};
inline constexpr QuantityKey slip_speed{.name = "slip_speed",
                                        .unit = "m/s",
                                        .fallback = dynamics::Wall{}.slip_speed,
                                        .range = Range::within(0.0, 100.0),
                                        .meaning = "below which friction fades; 0: it does not"};

}  // namespace wall_keys

namespace rock_mount_keys {

inline constexpr TableKey table{"rock_mount", "drilling: rock that moves along z (eq. 2.2)"};

inline constexpr QuantityKey mass{
    .name = "mass", .unit = "kg", .range = above_zero_to_largest, .meaning = "of the rock"};
inline constexpr QuantityKey stiffness{.name = "stiffness",
                                       .unit = "N/m",
                                       .fallback = 0.0,
                                       .range = up_to_largest,
                                       .meaning = "of what holds the rock"};
inline constexpr QuantityKey damping{.name = "damping",
                                     .unit = "N s/m",
                                     .fallback = 0.0,
                                     .range = up_to_largest,
                                     .meaning = "of what holds the rock"};

}  // namespace rock_mount_keys

}  // namespace tdbd::simulation
