#pragma once

#include "core/config/field.hpp"
#include "core/types.hpp"
#include "reference/literature/drag/plane/planar_outline.hpp"

/// The keys of [compare], which only tdbd-compare reads. The rest of the file is a case of tdbd
/// run.
namespace tdbd::reference::compare_keys {

inline constexpr TableKey table{"compare", "how the models of chapter 2 are evaluated"};
inline constexpr TextsKey models{
    .name = "models", .computed_default = "all", .meaning = "which models run"};
inline constexpr QuantityKey counted_revolutions{
    .name = "counted_revolutions",
    .fallback = 1.0,
    .range = Range::positive(),
    .meaning = "at the end of the run, over which means are taken"};
inline constexpr QuantityKey weight_on_bit{
    .name = "weight_on_bit",
    .unit = "N",
    .computed_default = "the weight that tdbd finds, or that motion gives a string",
    .range = Range::positive(),
    .meaning = "reference weight, for the rate that models find"};
inline constexpr QuantityKey circle{.name = "circle",
                                    .unit = "m",
                                    .fallback = 0.1,
                                    .range = Range::positive(),
                                    .meaning = "radius on which the bottom is compared"};
inline constexpr IntegerKey circle_samples{.name = "circle_samples",
                                           .fallback = 1440,
                                           .lo = 8,
                                           .hi = 100'000,
                                           .meaning = "of our bottom on that circle"};

inline constexpr ChoiceKey<OutlineForm> outline{
    .name = "outline",
    .values = {{{"planar", OutlineForm::planar}, {"turned", OutlineForm::turned}}},
    .fallback = OutlineForm::planar,
    .meaning =
        "of Warren and Sinor, and Glowka: rims drawn in one plane as they are seen along "
        "the motion, or each point turned about the axis"};

inline constexpr TableKey planes_table{"compare.planes", "Behr et al."};
inline constexpr IntegerKey planes{.name = "planes",
                                   .fallback = 72,
                                   .lo = 3,
                                   .hi = 10'000,
                                   .meaning = "radial planes: 72 are 5 degrees apart"};
inline constexpr IntegerKey nodes{
    .name = "nodes", .fallback = 500, .lo = 10, .hi = 100'000, .meaning = "on each plane"};

inline constexpr TableKey spokes_table{"compare.spokes", "Langeveld; Hanson and Hansen"};
inline constexpr IntegerKey spokes{
    .name = "spokes", .fallback = 120, .lo = 3, .hi = 10'000, .meaning = "around the hole"};
inline constexpr IntegerKey spoke_nodes{.name = "nodes",
                                        .fallback = 500,
                                        .lo = 10,
                                        .hi = 100'000,
                                        .meaning = "on each spoke of Langeveld"};
inline constexpr QuantityKey spacing{.name = "spacing",
                                     .unit = "m",
                                     .fallback = 0.25e-3,
                                     .range = Range::positive(),
                                     .meaning = "of Hanson and Hansen's nodes"};

inline constexpr TableKey glowka_table{"compare.glowka", "Glowka"};
inline constexpr QuantityKey power{
    .name = "power",
    .fallback = 1.5,
    .range = Range::positive(),
    .meaning = "of the depth, with which the forces on a sharp cutter grow"};
inline constexpr QuantityKey reference_depth{
    .name = "reference_depth",
    .unit = "m",
    .fallback = 1e-3,
    .range = Range::positive(),
    .meaning = "of a virgin groove in which those forces are eps and zeta eps times its area"};
inline constexpr QuantityKey flat_stress{.name = "flat_stress",
                                         .unit = "Pa",
                                         .computed_default = "none: flats stay out",
                                         .range = Range::positive(),
                                         .meaning = "under a wear flat"};
inline constexpr QuantityKey wear_coefficient{.name = "wear_coefficient",
                                              .unit = "m3/(N m)",
                                              .computed_default = "none: cutters do not wear",
                                              .range = Range::positive(),
                                              .meaning = "of a cool flat: volume over work"};
inline constexpr QuantityKey distance{.name = "distance",
                                      .unit = "m",
                                      .fallback = 100.0,
                                      .range = Range::positive(),
                                      .meaning = "drilled until flats are looked at"};
inline constexpr QuantityKey flat_friction{.name = "flat_friction",
                                           .fallback = 0.6,
                                           .range = Range::non_negative(),
                                           .meaning = "of a flat on the rock"};
inline constexpr QuantityKey rock_conductivity{.name = "rock_conductivity",
                                               .unit = "W/(m K)",
                                               .fallback = 2.0,
                                               .range = Range::positive(),
                                               .meaning = "of heat"};
inline constexpr QuantityKey rock_diffusivity{.name = "rock_diffusivity",
                                              .unit = "m2/s",
                                              .fallback = 1e-6,
                                              .range = Range::positive(),
                                              .meaning = "of heat"};
inline constexpr QuantityKey cutter_resistance{.name = "cutter_resistance",
                                               .unit = "m2 K/W",
                                               .fallback = 0.5e-4,
                                               .range = Range::positive(),
                                               .meaning = "from a flat to the fluid"};

inline constexpr TableKey roller_table{"compare.roller", "models of roller cone bits"};
inline constexpr QuantityKey specific_energy{
    .name = "specific_energy",
    .unit = "Pa",
    .computed_default = "that at which the weight is the reference weight",
    .range = Range::positive(),
    .meaning = "Sheppard and Lesage: of the rock"};
inline constexpr QuantityKey normal_ratio{
    .name = "normal_ratio",
    .fallback = 0.8,
    .range = Range::non_negative(),
    .meaning = "Sheppard and Lesage: force across the motion over that against it"};
inline constexpr QuantityKey half_angle{.name = "half_angle",
                                        .unit = "rad",
                                        .fallback = 0.0,
                                        .range = Range::within(-1.5, 1.5),
                                        .meaning = "Sheppard and Lesage: of the bands' cone"};
inline constexpr PathKey tooth_table{
    .name = "tooth_table",
    .computed_default = "that of a sphere under the case's law",
    .meaning = "single-tooth tests: CSV of depth, force, crater_radius with units"};
inline constexpr QuantityKey penetration{.name = "penetration",
                                         .unit = "m",
                                         .computed_default = "the advance of a revolution",
                                         .range = Range::positive(),
                                         .meaning = "Ma and Azar: of rows into a flat bottom"};
inline constexpr QuantityKey cone_ratio{.name = "cone_ratio",
                                        .computed_default = "that of the outer row without slip",
                                        .range = Range::positive(),
                                        .meaning = "Ma and Azar: of the cones' speed to the bit's"};

inline constexpr QuantityKey tooth_half_angle{.name = "tooth_half_angle",
                                              .unit = "rad",
                                              .fallback = 30.0 * degree,
                                              .range = Range::within(0.05, 1.5),
                                              .meaning = "Briggs: of its wedges"};

inline constexpr TableKey winters_table{"compare.winters", "Winters, Warren and Onyia"};
inline constexpr ListKey weights{.name = "weights",
                                 .unit = "N",
                                 .computed_default = "none: it is not fitted",
                                 .meaning = "of at least three known rates"};
inline constexpr ListKey rates{.name = "rates",
                               .unit = "m/s",
                               .computed_default = "as many as weights",
                               .meaning = "the known rates"};
inline constexpr QuantityKey strength{.name = "strength",
                                      .unit = "Pa",
                                      .fallback = 100e6,
                                      .range = Range::positive(),
                                      .meaning = "of the rock, confined"};

}  // namespace tdbd::reference::compare_keys
