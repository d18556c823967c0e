#pragma once

#include "core/config/key.hpp"
#include "sweep/design/design.hpp"

/// The keys of a sweep's design.
namespace tdbd::sweep {

namespace top_keys {

inline constexpr TableKey table{"", "what the design is"};

inline constexpr TextKey title{
    .name = "title", .fallback = "", .meaning = "an attribute of the table"};

}  // namespace top_keys

namespace set_keys {

inline constexpr TableKey table{"set", "keys of the case, the same at all points"};

inline constexpr AnyKey any{.name = "KEY",
                            .kind = "as in the case",
                            .usual = "the case's",
                            .meaning =
                                "any key of the case, dotted: time.revolutions; of its bit "
                                "file behind bit.set: bit.set.adjust.back_rake"};

}  // namespace set_keys

namespace sweep_keys {

inline constexpr TableKey table{"sweep", "what is done at each point"};

inline constexpr PathKey case_file{.name = "case",
                                   .meaning = "the case (TOML); of the command bit a bit file"};
inline constexpr ChoiceKey<Command> command{.name = "command",
                                            .values = {{{"run", Command::run},
                                                        {"rotate", Command::rotate},
                                                        {"calibrate", Command::calibrate},
                                                        {"bit", Command::bit},
                                                        {"planar", Command::planar}}},
                                            .fallback = Command::run,
                                            .meaning = "that takes the case"};
inline constexpr TextsKey figures{
    .name = "figures", .meaning = "numbers of the command's summary, dotted: \"wob_mean_n\""};
inline constexpr ChoiceKey<Sampling> sampling{
    .name = "sampling",
    .values = {{{"none", Sampling::none},
                {"latin-hypercube", Sampling::latin_hypercube},
                {"sobol", Sampling::sobol}}},
    .fallback = Sampling::none,
    .meaning = "of the factors with from and to but no count"};
inline constexpr IntegerKey samples{.name = "samples",
                                    .fallback = 1,
                                    .lo = 1,
                                    .hi = 4'000'000'000,
                                    .meaning = "at each combination of levels"};
inline constexpr IntegerKey seed{.name = "seed",
                                 .fallback = 2007,
                                 .lo = 0,
                                 .hi = 2'147'483'647,
                                 .meaning = "of latin-hypercube"};
inline constexpr QuantityKey penetration{.name = "penetration",
                                         .unit = "m",
                                         .fallback = 5e-3,
                                         .range = Range::positive(),
                                         .meaning = "per revolution, of the command bit"};

inline constexpr QuantityKey normal_ratio{
    .name = "normal_ratio",
    .fallback = 0.8,
    .range = Range::positive(),
    .meaning = "normal over cutting force, of the planar model"};

}  // namespace sweep_keys

namespace factor_keys {

inline constexpr TableKey table{"factors", "a key of the case that varies", Repeats::yes};

inline constexpr TextKey key{.name = "key", .meaning = "dotted, as --set has it"};
inline constexpr WordsKey values{.name = "values",
                                 .usual = "required without from and to",
                                 .meaning = "the levels, as the key takes them"};
inline constexpr WordKey from{.name = "from",
                              .usual = "required without values",
                              .meaning = "the lowest level, or where samples begin"};
inline constexpr WordKey to{
    .name = "to", .usual = "required with from", .meaning = "the highest, in the unit of from"};
inline constexpr IntegerKey count{.name = "count",
                                  .usual = "none: the factor is sampled",
                                  .lo = 2,
                                  .hi = 4'000'000'000,
                                  .meaning = "of levels, both ends included"};
inline constexpr ChoiceKey<Scale> scale{
    .name = "scale",
    .values = {{{"linear", Scale::linear}, {"log", Scale::log}}},
    .fallback = Scale::linear,
    .meaning = "on which levels or samples are evenly spread"};

}  // namespace factor_keys

namespace goal_keys {

inline constexpr TableKey table{"goals", "a figure of the non-dominated front", Repeats::yes};

inline constexpr TextKey figure{.name = "figure", .meaning = "one of sweep.figures"};
inline constexpr ChoiceKey<Sense> better{
    .name = "better",
    .values = {{{"smaller", Sense::smaller}, {"larger", Sense::larger}}},
    .fallback = Sense::smaller,
    .meaning = "which of two values is preferred"};

}  // namespace goal_keys

namespace filter_keys {

inline constexpr TableKey table{"filter",
                                "points are judged by the planar model, and the best are run"};

inline constexpr TextKey figure{.name = "figure", .meaning = "of the command planar"};
inline constexpr IntegerKey keep{
    .name = "keep", .lo = 1, .hi = most_points, .meaning = "points that are run"};

}  // namespace filter_keys

}  // namespace tdbd::sweep
