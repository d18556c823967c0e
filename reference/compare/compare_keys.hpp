#pragma once

#include "core/config/key.hpp"
#include "reference/literature/drag/planar_outline.hpp"

/// The keys of [compare], which only tdbd-compare reads; the rest of the file is a case of tdbd run.
namespace tdbd::reference::compare_keys {

inline constexpr TableKey table{"compare", "how the models of chapter 2 are asked"};
inline constexpr TextsKey models{.name = "models", .usual = "all", .meaning = "which models run"};
inline constexpr QuantityKey counted_revolutions{
    .name = "counted_revolutions",
    .fallback = 1.0,
    .range = Range::positive(),
    .meaning = "at the end of the run, over which means are taken"};
inline constexpr QuantityKey weight_on_bit{
    .name = "weight_on_bit",
    .unit = "N",
    .usual = "the weight that tdbd finds",
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
                                     .fallback = 0.5e-3,
                                     .range = Range::positive(),
                                     .meaning = "of Hanson and Hansen's nodes"};

}  // namespace tdbd::reference::compare_keys
