#pragma once

#include "core/config/key.hpp"
#include "forces/law.hpp"

namespace tdbd::calibration {

/// Whether one set of coefficients is fitted for all bottom hole pressures, or a separate set for
/// each (thesis 6.4.1).
enum class Pressures { combined, separate };

namespace calibration_keys {

inline constexpr TableKey table{"calibration", "what is fitted to which records"};
inline constexpr NameKey law{.name = "law",
                             .names = &forces::law_names,
                             .usual = "required",
                             .meaning = "the force law of the cutters"};
inline constexpr PathKey records{.name = "records",
                                 .usual = "required",
                                 .meaning = "the readings, csv with units in the header"};
inline constexpr TextsKey fit_bits{
    .name = "fit_bits", .usual = "none", .meaning = "bits or cutters whose records are fitted"};
inline constexpr TextsKey predict_bits{.name = "predict_bits",
                                       .usual = "none",
                                       .meaning = "bits or cutters whose records are predicted"};
inline constexpr TextsKey leave_out{
    .name = "leave_out", .usual = "none", .meaning = "tests that are neither fitted nor predicted"};
inline constexpr ChoiceKey<Pressures> pressures{
    .name = "pressures",
    .values = {{{"combined", Pressures::combined}, {"separate", Pressures::separate}}},
    .fallback = Pressures::combined,
    .meaning = "one set of coefficients for all bottom hole pressures, or one for each"};

inline constexpr TableKey bits{"bits", "NAME = \"file\": the bits of the records"};
inline constexpr AnyKey any_bit{.name = "NAME",
                                .kind = "file",
                                .usual = "no such bit",
                                .meaning = "the bit file of the bit that records call NAME"};
inline constexpr TableKey rocks{"rocks.NAME",
                                "a rock by its numbers, for records that name it (column rock)"};

inline constexpr TableKey cutter{"cutters.NAME", "a single cutter that moves along flat rock"};
inline constexpr QuantityKey diameter{
    .name = "diameter", .unit = "m", .range = Range::positive(), .meaning = "of the cutter"};
inline constexpr QuantityKey back_rake{
    .name = "back_rake", .unit = "rad", .range = Range::within(0.0, 1.3), .meaning = "of its face"};
inline constexpr QuantityKey wear_flat{
    .name = "wear_flat",
    .unit = "m2",
    .fallback = 0.0,
    .range = Range::non_negative(),
    .meaning = "area that presses on the rock, as a chamfer does"};
inline constexpr QuantityKey chamfer{.name = "chamfer",
                                     .unit = "m",
                                     .fallback = 0.0,
                                     .range = Range::non_negative(),
                                     .meaning = "its width as the rock sees it"};

inline constexpr TableKey rock{"rock", "the rock, and its mesh in the cut runs"};
inline constexpr QuantityKey edge_length{.name = "edge_length",
                                         .unit = "m",
                                         .fallback = 2e-3,
                                         .range = Range::within(1e-5, 0.1),
                                         .meaning = "of the rock's triangles in the cut runs"};
inline constexpr TableKey time{"time", "the cut runs: one for each bit and depth of cut"};
inline constexpr IntegerKey revolutions{.name = "revolutions",
                                        .fallback = 3,
                                        .lo = 2,
                                        .hi = 100,
                                        .meaning = "of a cut run; its last one counts"};
inline constexpr IntegerKey steps_per_revolution{.name = "steps_per_revolution",
                                                 .fallback = 250,
                                                 .lo = 20,
                                                 .hi = 100'000,
                                                 .meaning = "of a cut run"};

inline constexpr TableKey noise{"noise", "relative standard deviations of what was measured"};
inline constexpr QuantityKey reading{
    .name = "reading", .fallback = 0.03, .range = Range::positive(), .meaning = "of each load"};
inline constexpr QuantityKey test{.name = "test",
                                  .fallback = 0.0,
                                  .range = Range::non_negative(),
                                  .meaning = "of a factor on all loads of one test"};
inline constexpr QuantityKey rop{.name = "rop",
                                 .fallback = 0.0,
                                 .range = Range::non_negative(),
                                 .meaning = "of the rate of penetration, or a cutter's depth"};

inline constexpr TableKey unknown{"unknowns.KEY", "a coefficient of the law that is fitted"};
// `start` and `range` have the unit of their coefficient; they are read by name and listed by `tdbd
// keys`.
inline constexpr QuantityKey start{
    .name = "start", .meaning = "first value, and the prior's; in the coefficient's unit"};
inline constexpr QuantityKey prior_sd{.name = "prior_sd",
                                      .usual = "no prior",
                                      .range = Range::positive(),
                                      .meaning = "standard deviation of the prior around start"};
inline constexpr ListKey range{.name = "range",
                               .usual = "that of the coefficient",
                               .meaning = "[lowest, highest], in the coefficient's unit"};
inline constexpr TableKey fixed{"fixed", "KEY = value: coefficients that are not fitted"};
inline constexpr AnyKey any_coefficient{.name = "KEY",
                                        .kind = "that of the coefficient",
                                        .usual = "the coefficient's, or fitted",
                                        .meaning = "a coefficient of the law, as [forces] has it"};

inline constexpr TableKey area{
    "areas.NAME",
    "parts of the bits that meet all criteria and have coefficients of their own; of several areas "
    "the one with the most particular criterion decides each coefficient"};
inline constexpr TableKey areas{"areas", area.meaning};
inline constexpr TableKey area_unknown{"areas.NAME.unknowns.KEY",
                                       "a coefficient of the area that is fitted"};
inline constexpr TableKey area_fixed{"areas.NAME.fixed",
                                     "KEY = value: coefficients of the area that are not fitted"};
inline constexpr AnyKey any_area_coefficient{
    .name = "KEY",
    .kind = "that of the coefficient",
    .usual = "that of the parts in no area, or fitted",
    .meaning = "a coefficient of the law, as [forces] has it"};

inline constexpr TableKey intervals{"intervals", "how sure the result is"};
inline constexpr QuantityKey level{.name = "level",
                                   .fallback = 0.95,
                                   .range = Range::within(0.5, 0.999),
                                   .meaning = "probability of an interval"};
inline constexpr IntegerKey bootstrap{
    .name = "bootstrap", .fallback = 0, .lo = 0, .hi = 100'000, .meaning = "replicates; 0: none"};
inline constexpr IntegerKey seed{
    .name = "seed", .fallback = 1, .meaning = "of the bootstrap and of further starts"};

}  // namespace calibration_keys

}  // namespace tdbd::calibration
