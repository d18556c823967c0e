#pragma once

#include "bit/cone/cone_bit.hpp"
#include "bit/update_direction.hpp"
#include "core/config/key.hpp"
#include "rock/cut/cutting_bit.hpp"
#include "rock/maintain/maintain.hpp"
#include "rock/section/section.hpp"

namespace tdbd::simulation {

enum class SectionMeasure { off, ahead };
enum class ContactMeasure { off, on };

/// Whether a bit that forces move observes the order of its energy's residual.
enum class EnergyOrderOption {
  off,
  on,      ///< where that costs at most a tenth of the run's steps
  always,  ///< whatever it costs
};

namespace bit_keys {

inline constexpr TableKey table{"bit", "the bit"};
inline constexpr PathKey file{.name = "file", .meaning = "the bit file (TOML)"};
inline constexpr TableKey set{"set", "keys of the bit file, in place of its own"};
inline constexpr TableKey changes{
    "bit.set", "keys of the bit file, in place of its own: bit.set.adjust.back_rake = \"2 deg\""};
inline constexpr AnyKey any{.name = "KEY",
                            .kind = "as in the bit file",
                            .usual = "the bit file's",
                            .meaning =
                                "any key of the tables of `tdbd bit` below, dotted: "
                                "gage_diameter, cutters.chamfer, adjust.blade.2.azimuth"};

}  // namespace bit_keys

namespace time_keys {

inline constexpr TableKey table{"time", "how long, and in which steps"};

inline constexpr QuantityKey step{
    .name = "step",
    .unit = "s",
    .range = Range::positive(),
    .meaning = "time step; the bit turns at most 0.5 rad in it, and no part jumps past its size"};
inline constexpr QuantityKey duration{.name = "duration",
                                      .unit = "s",
                                      .usual = "the path's; else required without revolutions",
                                      .range = Range::positive(),
                                      .meaning = "of the motion"};
inline constexpr QuantityKey revolutions{.name = "revolutions",
                                         .usual = "in place of duration",
                                         .range = Range::positive(),
                                         .meaning = "of a bit with a rotary speed"};
inline constexpr IntegerKey first_step{
    .name = "first_step",
    .fallback = 0,
    .meaning = "steps of the motion that an earlier run has made: this one goes on from there"};

}  // namespace time_keys

namespace update_keys {

inline constexpr TableKey table{"update", "how rock vertices leave the parts that cut"};

inline constexpr ChoiceKey<bit::DirectionRule> directions{
    .name = "directions",
    .values = {{{"hybrid", bit::DirectionRule::hybrid},
                {"all-down", bit::DirectionRule::all_down},
                {"along-profile", bit::DirectionRule::along_profile}}},
    .fallback = bit::DirectionRule::hybrid,
    .meaning = "update directions of cutters: eq. 4.2, or one of its extremes"};
inline constexpr ChoiceKey<bit::InsideRule> inside_cutters{
    .name = "inside_cutters",
    .values = {{{"down", bit::InsideRule::down},
                {"plus-x", bit::InsideRule::plus_x},
                {"minus-x", bit::InsideRule::minus_x}}},
    .fallback = bit::InsideRule::down,
    .meaning = "direction e of eq. 4.2"};
inline constexpr ChoiceKey<bit::GageRule> gage_teeth{
    .name = "gage_teeth",
    .values = {{{"normal", bit::GageRule::normal},
                {"row", bit::GageRule::row},
                {"down", bit::GageRule::down},
                {"horizontal", bit::GageRule::horizontal}}},
    .fallback = bit::GageRule::normal,
    .meaning = "update directions of the teeth of gage rows"};
inline constexpr ChoiceKey<rock::ExitSearch> exit_search{
    .name = "exit_search",
    .values = {{{"tree", rock::ExitSearch::tree}, {"walk", rock::ExitSearch::walk}}},
    .fallback = rock::CuttingOptions{}.search,
    .meaning = "how exits from parts that are not convex are found; the results are the same"};
inline constexpr ChoiceKey<rock::ExitFrom> exit_from{
    .name = "exit_from",
    .values = {{{"parts", rock::ExitFrom::parts}, {"whole", rock::ExitFrom::whole}}},
    .fallback = rock::CuttingOptions{}.exit_from,
    .meaning =
        "whether rock leaves the parts of a cutter in turn, or a cutter of convex shape at "
        "once: then the part it leaves through has its volume"};
inline constexpr ChoiceKey<rock::DirectionFrame> leaning{
    .name = "leaning",
    .values = {{{"upright", rock::DirectionFrame::upright}, {"bit", rock::DirectionFrame::bit}}},
    .fallback = rock::CuttingOptions{}.directions,
    .meaning = "whether update directions lean with the bit's axis"};
inline constexpr IntegerKey most_passes{.name = "most_passes",
                                        .fallback = 1000,
                                        .lo = 1,
                                        .hi = 1'000'000,
                                        .meaning = "passes of one step; more are an error"};

}  // namespace update_keys

namespace maintenance_keys {

inline constexpr TableKey table{"maintenance", "how the rock's mesh is kept in shape"};

inline constexpr IntegerKey every{.name = "every",
                                  .fallback = 5,
                                  .hi = 1'000'000,
                                  .meaning = "steps between maintenances; 0: never"};
inline constexpr IntegerKey rest{
    .name = "rest",
    .fallback = 4,
    .hi = 1'000'000,
    .meaning = "steps that must have left a vertex alone before it is maintained; 0: none"};
inline constexpr IntegerKey longest_wait{
    .name = "longest_wait",
    .fallback = 20,
    .lo = 1,
    .hi = 1'000'000,
    .meaning = "steps after which a vertex is maintained even if it was never left alone"};
inline constexpr IntegerKey renumber_every{
    .name = "renumber_every",
    .fallback = 2500,
    .hi = 1'000'000'000,
    .meaning = "steps between renumberings of the mesh by place, for speed; 0: never"};
inline constexpr QuantityKey shortest_edge{
    .name = "shortest_edge",
    .fallback = 0.4,
    .range = Range::within(0.0, 0.7),
    .meaning = "over rock.edge_length; shorter edges collapse"};
inline constexpr QuantityKey longest_edge{
    .name = "longest_edge",
    .fallback = 1.6,
    .range = Range::within(1.3, 100.0),
    .meaning = "over rock.edge_length; longer edges are split"};
inline constexpr QuantityKey worst_quality{
    .name = "worst_quality",
    .fallback = 0.1,
    .range = Range::within(0.0, 0.5),
    .meaning = "an operation makes no triangle worse than this"};
inline constexpr QuantityKey flip_quality{
    .name = "flip_quality",
    .fallback = 0.6,
    .range = Range::within(0.0, 1.0),
    .meaning = "triangles below may flip their longest edge; 0: none does"};
inline constexpr ChoiceKey<rock::Smoothing> smoothing{
    .name = "smoothing",
    .values = {{{"off", rock::Smoothing::off}, {"tangential", rock::Smoothing::tangential}}},
    .fallback = rock::Smoothing::tangential,
    .meaning = "whether vertices move along the surface to better places"};
inline constexpr QuantityKey smooth_quality{.name = "smooth_quality",
                                            .fallback = 0.5,
                                            .range = Range::within(0.0, 1.0),
                                            .meaning = "vertices of triangles below are smoothed"};

}  // namespace maintenance_keys

namespace measure_keys {

inline constexpr TableKey table{"measure", "what a run measures in every step, for forces"};

inline constexpr ChoiceKey<SectionMeasure> section{
    .name = "section",
    .values = {{{"ahead", SectionMeasure::ahead}, {"off", SectionMeasure::off}}},
    .fallback = SectionMeasure::ahead,
    .meaning = "the section of uncut rock ahead of every cutter's face"};
inline constexpr QuantityKey section_lead{
    .name = "section_lead",
    .fallback = 1.7,
    .range = Range::within(0.1, 10.0),
    .meaning =
        "how far ahead of the face, over rock.edge_length; more than the longest edge, or "
        "sections are too small"};
inline constexpr ChoiceKey<rock::SectionAtFace> section_at_face{
    .name = "section_at_face",
    .values = {{{"as_ahead", rock::SectionAtFace::as_ahead},
                {"extrapolated", rock::SectionAtFace::extrapolated}}},
    .fallback = rock::SectionAtFace::as_ahead,
    .meaning =
        "the section at the face is that ahead of it, exact in steady motion, or follows from two "
        "at one and two leads; the second costs about a fifth of a step"};
inline constexpr IntegerKey section_every{
    .name = "section_every",
    .fallback = 1,
    .lo = 1,
    .hi = 1000,
    .meaning =
        "steps between the sections of a face; faces take turns and keep their last; 1 where "
        "forces move the bit"};
inline constexpr ChoiceKey<ContactMeasure> contact{
    .name = "contact",
    .values = {{{"on", ContactMeasure::on}, {"off", ContactMeasure::off}}},
    .fallback = ContactMeasure::on,
    .meaning = "the contact area of every part"};
inline constexpr QuantityKey contact_gap{
    .name = "contact_gap",
    .fallback = 0.01,
    .range = Range::within(1e-6, 1.0),
    .meaning = "how near counts as touching, over rock.edge_length"};

}  // namespace measure_keys

namespace output_keys {

inline constexpr TableKey table{"output", "what is recorded, and when"};

inline constexpr IntegerKey history_every{
    .name = "history_every",
    .usual = "at most 10 000 rows",
    .lo = 1,
    .hi = 1'000'000'000,
    .meaning =
        "steps between rows of the history; more than 1: a row has their means, sums, extremes"};
inline constexpr IntegerKey frames_every{.name = "frames_every",
                                         .fallback = 0,
                                         .hi = 1'000'000'000,
                                         .meaning = "steps between frames; 0: only the last one"};
inline constexpr IntegerKey checkpoint_every{
    .name = "checkpoint_every",
    .usual = "as often as costs less than 1 % of the time",
    .hi = 1'000'000'000,
    .meaning = "steps between checkpoints, from which `tdbd run --resume` goes on; 0: none"};
inline constexpr QuantityKey means_from{
    .name = "means_from",
    .unit = "s",
    .usual = "half of the run",
    .range = Range::non_negative(),
    .meaning = "since the run's beginning: steps before do not count in means"};
inline constexpr PathKey convergence{
    .name = "convergence",
    .usual = "none",
    .meaning =
        "a convergence.json of this case (`tdbd converge`), or a list of several in one file: "
        "summary.json then has the numerical uncertainty of its means"};
inline constexpr ChoiceKey<EnergyOrderOption> energy_order{
    .name = "energy_order",
    .values = {{{"on", EnergyOrderOption::on},
                {"off", EnergyOrderOption::off},
                {"always", EnergyOrderOption::always}}},
    .fallback = EnergyOrderOption::on,
    .meaning =
        "drilling: whether to observe the order of the energy's residual; on: where it "
        "costs at most a tenth of the run's steps"};
inline constexpr IntegerKey energy_order_window{
    .name = "energy_order_window",
    .fallback = 24,
    .lo = 8,
    .hi = 1'000'000,
    .meaning =
        "drilling: steps of that observation; all its levels together cost seven times as "
        "many"};

}  // namespace output_keys

}  // namespace tdbd::simulation
