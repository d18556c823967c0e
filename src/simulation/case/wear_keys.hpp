#pragma once

#include "core/config/key.hpp"

namespace tdbd::simulation {

/// The kind of a wear law.
enum class WearKind { none, sliding, thermal, table };

/// The keys of [wear] and, for the parts of an area, of [wear.areas.NAME].
namespace wear_keys {

inline constexpr TableKey table{
    "wear",
    "wear of cutters from a cutter table, of the teeth of cones and, by area, of gage pads"};
inline constexpr TableKey areas_table{
    "wear.areas.NAME",
    "another wear law for the parts that meet all criteria given here; of several areas the one "
    "with the most particular criterion decides"};
inline constexpr TableKey areas{"areas", areas_table.meaning};

inline constexpr ChoiceKey<WearKind> law{
    .name = "law",
    .values = {{{"sliding", WearKind::sliding},
                {"thermal", WearKind::thermal},
                {"table", WearKind::table},
                {"none", WearKind::none}}},
    .meaning =
        "worn volume per path and normal force. sliding: coefficient/hardness (Archard); thermal: "
        "times exp((T - threshold)/growth) above the threshold (Glowka); table: rates"};
inline constexpr QuantityKey coefficient{.name = "coefficient",
                                         .usual = "required by sliding and thermal",
                                         .range = Range::non_negative(),
                                         .meaning = "of Archard's law"};
inline constexpr QuantityKey hardness{.name = "hardness",
                                      .unit = "Pa",
                                      .usual = "required by sliding and thermal",
                                      .range = Range::positive(),
                                      .meaning = "of what wears"};
inline constexpr QuantityKey threshold{.name = "threshold",
                                       .unit = "K",
                                       .usual = "required by thermal",
                                       .range = Range::positive(),
                                       .meaning = "temperature limit: a hotter flat wears faster"};
inline constexpr QuantityKey growth{.name = "growth",
                                    .unit = "K",
                                    .fallback = 50.0,
                                    .range = Range::positive(),
                                    .meaning = "thermal: warming that multiplies the rate by e"};
inline constexpr ListKey temperatures{
    .name = "temperatures", .unit = "K", .usual = "required by table", .meaning = "rising"};
inline constexpr ListKey rates{.name = "rates",
                               .unit = "m3 N-1 m-1",
                               .usual = "required by table",
                               .meaning =
                                   "worn volume per path and normal force, one for each "
                                   "temperature; linear between them"};
inline constexpr QuantityKey acceleration{
    .name = "acceleration",
    .fallback = 1.0,
    .range = Range::positive(),
    .meaning = "multiplies the rates: a metre drilled wears the bit like so many metres"};
inline constexpr QuantityKey from{
    .name = "from",
    .unit = "s",
    .fallback = 0.0,
    .range = Range::non_negative(),
    .meaning =
        "the bit does not wear before: the first turns of a run, in which it is not yet "
        "drilling steadily, would stand for as many metres as all others"};
inline constexpr IntegerKey every_steps{.name = "every_steps",
                                        .fallback = 0,
                                        .meaning =
                                            "largest number of time steps between two wear "
                                            "steps; 0: no limit"};
inline constexpr QuantityKey every{.name = "every",
                                   .unit = "m",
                                   .fallback = 0.0,
                                   .range = Range::non_negative(),
                                   .meaning =
                                       "largest distance that the bit goes down between two "
                                       "wear steps; 0: no limit"};
inline constexpr QuantityKey largest_growth{.name = "largest_growth",
                                            .fallback = 0.005,
                                            .range = Range::within(1e-6, 0.1),
                                            .meaning =
                                                "by which a flat's height grows at most in a wear "
                                                "step, over the diameter of its cutter, the "
                                                "protrusion of its tooth, or the thickness of its "
                                                "pad; wear steps come as often as that needs"};
inline constexpr QuantityKey friction{
    .name = "friction",
    .fallback = 0.15,
    .range = Range::non_negative(),
    .meaning = "of the flat on the rock, which heats it; assumed"};
inline constexpr QuantityKey rock_conductivity{.name = "rock_conductivity",
                                               .unit = "W/(m K)",
                                               .fallback = 3.5,
                                               .range = Range::positive(),
                                               .meaning = "thermal; assumed"};
inline constexpr QuantityKey rock_diffusivity{.name = "rock_diffusivity",
                                              .unit = "m2/s",
                                              .fallback = 1.5e-6,
                                              .range = Range::positive(),
                                              .meaning = "thermal; assumed"};
inline constexpr QuantityKey cutter_resistance{
    .name = "cutter_resistance",
    .unit = "K m2/W",
    .fallback = 0.3e-4,
    .range = Range::non_negative(),
    .meaning = "thermal, from a flat to the drilling fluid; assumed"};
inline constexpr QuantityKey fluid_temperature{.name = "fluid_temperature",
                                               .unit = "K",
                                               .fallback = 293.15,
                                               .range = Range::positive(),
                                               .meaning = "of the drilling fluid"};

}  // namespace wear_keys

}  // namespace tdbd::simulation
