#pragma once

#include "core/config/key.hpp"
#include "dynamics/schedule.hpp"

namespace tdbd::simulation {

/// drilling: forces move the bit (drive.hpp); as a prescribed motion it would follow its top.
enum class MotionKind { steady, whirl, legs, table, drilling };
enum class WhirlSense { forward, backward };

/// How the cones of a roller cone bit turn: each at a given speed over the bit's, or as its
/// contacts with rock let it (drive.hpp).
enum class ConeDrive { given, rolling };

/// No spring, damper, mass or load is larger (SI): the products of larger ones with others are no numbers.
inline constexpr double largest_constant = 1e16;
inline constexpr Range up_to_largest = Range::within(0.0, largest_constant);
inline constexpr Range above_zero_to_largest{
    .lo = 0.0, .hi = largest_constant, .ends = Range::Ends::open_lo};

namespace motion_keys {

inline constexpr TableKey table{"motion", "how the bit moves"};

inline constexpr ChoiceKey<MotionKind> kind{
    .name = "kind",
    .values = {{{"steady", MotionKind::steady},
                {"whirl", MotionKind::whirl},
                {"legs", MotionKind::legs},
                {"table", MotionKind::table},
                {"drilling", MotionKind::drilling}}},
    .fallback = MotionKind::steady,
    .meaning =
        "a prescribed motion (steady, whirl, legs, or a path from a file), or drilling: "
        "forces move the bit"};
inline constexpr PathKey file{
    .name = "file",
    .usual = "required with kind table",
    .meaning =
        "the path: CSV with time_s, x_m, y_m, z_m, rx_rad, ry_rad, rz_rad (place of the "
        "bit's origin and rotation vector, spatial frame)"};
inline constexpr VectorKey start{.name = "start",
                                 .unit = "m",
                                 .fallback = {{0.0, 0.0, 0.0}},
                                 .meaning = "where the bit's origin starts; all kinds but table"};
inline constexpr QuantityKey rotary_speed{
    .name = "rotary_speed",
    .unit = "rad/s",
    .usual = "required, except legs and table",
    .range = Range::non_negative(),
    .meaning = "of the bit; drilling: of the top, or a table over time"};
inline constexpr QuantityKey rate_of_penetration{
    .name = "rate_of_penetration",
    .unit = "m/s",
    .usual = "required, except legs and table",
    .meaning = "of the bit; drilling: the top is lowered at this rate, or by a table over time"};
inline constexpr QuantityKey weight_on_bit{
    .name = "weight_on_bit",
    .unit = "N",
    .usual = "in place of rate_of_penetration",
    .range = up_to_largest,
    .meaning = "drilling: load of the top, or a table over time"};
inline constexpr QuantityKey expected_rate{
    .name = "expected_rate",
    .unit = "m/s",
    .fallback = 0.0,
    .meaning =
        "drilling with weight_on_bit: rate at which the bit and the upper end of its damper start"};
inline constexpr QuantityKey rate_memory{
    .name = "rate_memory",
    .unit = "s",
    .usual = "one turn at the fastest rotary_speed",
    .range = Range::non_negative(),
    .meaning =
        "drilling with weight_on_bit: time in which the upper end of the axial damper follows the "
        "bit's advance, so that the damper takes no part of the mean weight. 0: the end moves at "
        "expected_rate"};
inline constexpr QuantityKey weight_at_start{
    .name = "weight_at_start",
    .unit = "N",
    .fallback = 0.0,
    .range = up_to_largest,
    .meaning = "drilling: what the string carries at t = 0"};
inline constexpr QuantityKey torque_at_start{
    .name = "torque_at_start",
    .unit = "N m",
    .fallback = 0.0,
    .range = up_to_largest,
    .meaning = "drilling: torque that winds up the string at t = 0"};
inline constexpr ListKey cone_speeds{
    .name = "cone_speeds",
    .usual = "required with cones, unless drilling",
    .meaning = "speed of each cone over the bit's, positive: rolling"};
inline constexpr ChoiceKey<ConeDrive> cone_drive{
    .name = "cone_speeds",
    .values = {{{"rolling", ConeDrive::rolling}}},
    .usual = "in place of the list",
    .meaning = "cones turn as their contacts with the rock let them"};
inline constexpr QuantityKey cone_memory{.name = "cone_memory",
                                         .unit = "s",
                                         .usual = "the time of 0.1 rad of the bit",
                                         .range = Range::non_negative(),
                                         .meaning = "rolling cones: how long a contact counts"};

}  // namespace motion_keys

/// A quantity of [motion] over time.
namespace schedule_keys {

inline constexpr TableKey table{
    "motion.KEY", "rotary_speed, rate_of_penetration or weight_on_bit (KEY) over time: drilling"};

inline constexpr ListKey times{.name = "times", .unit = "s", .meaning = "ascending"};

constexpr ListKey values(const QuantityKey& of) {
  return {.name = "values", .unit = of.unit, .meaning = "as many as times, in the unit of KEY"};
}

inline constexpr ChoiceKey<dynamics::Interpolation> between{
    .name = "between",
    .values = {{{"stepwise", dynamics::Interpolation::stepwise},
                {"linear", dynamics::Interpolation::linear}}},
    .fallback = dynamics::Interpolation::stepwise,
    .meaning = "a staircase or ramps"};

}  // namespace schedule_keys

namespace whirl_keys {

inline constexpr TableKey table{"motion.whirl", "kind whirl: the bit's centre circles the axis"};

inline constexpr QuantityKey radius{.name = "radius",
                                    .unit = "m",
                                    .range = Range::non_negative(),
                                    .meaning = "of the centre's orbit"};
inline constexpr QuantityKey frequency{.name = "frequency",
                                       .unit = "rad/s",
                                       .range = Range::non_negative(),
                                       .meaning = "of the centre on its orbit"};
inline constexpr ChoiceKey<WhirlSense> sense{
    .name = "sense",
    .values = {{{"forward", WhirlSense::forward}, {"backward", WhirlSense::backward}}},
    .fallback = WhirlSense::backward,
    .meaning = "with the bit's rotation or against it"};
inline constexpr QuantityKey ramp{.name = "ramp",
                                  .unit = "s",
                                  .usual = "one turn of the bit",
                                  .range = Range::non_negative(),
                                  .meaning = "time in which the orbit grows to its radius"};

}  // namespace whirl_keys

namespace tilt_keys {

inline constexpr TableKey table{"motion.tilt", "kinds steady, whirl: the bit's axis leans"};

inline constexpr QuantityKey angle{.name = "angle",
                                   .unit = "rad",
                                   .range = Range::within(0.0, 0.5),
                                   .meaning = "between the bit's axis and z"};
inline constexpr QuantityKey azimuth{.name = "azimuth",
                                     .unit = "rad",
                                     .fallback = 0.0,
                                     .meaning = "towards which the axis leans at t = 0"};
inline constexpr QuantityKey frequency{.name = "frequency",
                                       .unit = "rad/s",
                                       .fallback = 0.0,
                                       .range = Range::non_negative(),
                                       .meaning = "of the precession of the azimuth"};
inline constexpr ChoiceKey<WhirlSense> sense{
    .name = "sense",
    .values = {{{"forward", WhirlSense::forward}, {"backward", WhirlSense::backward}}},
    .fallback = WhirlSense::forward,
    .meaning = "of the precession: with the bit's rotation or against it"};
inline constexpr QuantityKey ramp{.name = "ramp",
                                  .unit = "s",
                                  .usual = "one turn of the bit",
                                  .range = Range::non_negative(),
                                  .meaning = "time in which the axis comes to its angle"};

}  // namespace tilt_keys

namespace leg_keys {

inline constexpr TableKey table{
    "motion.legs", "kind legs: a piece of the motion at constant speeds", Repeats::yes};

inline constexpr QuantityKey duration{
    .name = "duration", .unit = "s", .range = Range::positive(), .meaning = "of the leg"};
inline constexpr VectorKey velocity{.name = "velocity",
                                    .unit = "m/s",
                                    .fallback = {{0.0, 0.0, 0.0}},
                                    .meaning = "of the bit's origin, spatial frame"};
inline constexpr QuantityKey rotary_speed{
    .name = "rotary_speed", .unit = "rad/s", .fallback = 0.0, .meaning = "about z"};

}  // namespace leg_keys

}  // namespace tdbd::simulation
