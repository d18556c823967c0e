#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/cone/cone_bit.hpp"
#include "core/config/config.hpp"
#include "core/config/field.hpp"
#include "rock/cut/cutting_bit.hpp"
#include "rock/section/section.hpp"
#include "simulation/case/string_settings.hpp"

namespace tdbd::simulation {

/// What a warning is about. text: how the input is written, so it is not in summary.json, which is the
/// same for a resolved case.
enum class WarningAbout { result, text };

/// A setting without effect, or a value that is probably unintended. TDBD warns and continues.
struct CaseWarning {
  std::string place;  ///< "FILE:LINE: KEY" (Config::place)
  std::string key;    ///< dotted, from the top of the file
  std::string text;   ///< what has no effect or is doubtful, and what to do
  WarningAbout about = WarningAbout::result;
};

/// The doubts about numbers without a unit (Config::doubts) as warnings.
inline void add_number_doubts(const Config& c, std::vector<CaseWarning>& warnings) {
  for (const ConfigDoubt& d : c.doubts())
    warnings.push_back({d.place, d.key, d.text, WarningAbout::text});
}

/// Returns "FILE:LINE: KEY: TEXT", for users who have the file.
inline std::string with_place(const CaseWarning& w) { return w.place + ": " + w.text; }

/// Returns "KEY: TEXT", which does not depend on the path and the layout of the file.
inline std::string without_place(const CaseWarning& w) { return w.key + ": " + w.text; }

/// Returns the doubts about numbers without a unit, with their places.
inline std::vector<std::string> doubts_about_numbers(const std::vector<CaseWarning>& warnings) {
  std::vector<std::string> texts;
  for (const CaseWarning& w : warnings)
    if (w.about == WarningAbout::text) texts.push_back(with_place(w));
  return texts;
}

/// Returns the warnings about a result, for summary.json.
inline std::vector<std::string> texts_of_result(const std::vector<CaseWarning>& warnings) {
  std::vector<std::string> texts;
  for (const CaseWarning& w : warnings)
    if (w.about == WarningAbout::result) texts.push_back(without_place(w));
  return texts;
}

/// The default number of rows of a history is at most this, for the size of plots and files.
inline constexpr long most_history_rows = 10'000;

/// The default number of steps between rows for a run of so many steps.
inline long usual_history_every(long steps) {
  return std::max(1L, (steps + most_history_rows - 1) / most_history_rows);
}

/// mean: over the steps that count. diagnosed: by simulation::Diagnosis; noise for a steady bit.
enum class FigureKind { mean, diagnosed };

/// A value of summary.json that a study of convergence also has.
struct StudiedFigure {
  const char* in_study;
  const char* in_summary;
  FigureKind kind = FigureKind::mean;
};

inline constexpr StudiedFigure studied_figures[] = {
    {"wob_mean", "wob_mean_n"},
    {"tob_mean", "tob_mean_n_m"},
    {"rop_mean", "rop_mean_m_per_s"},
    {"rotary_speed_mean", "rotary_speed_mean_rad_per_s"},
    {"stick_slip_severity", "stick_slip_severity", FigureKind::diagnosed},
    {"torsional_frequency", "torsional_frequency_hz", FigureKind::diagnosed},
    {"orbit_radius", "orbit_radius_m", FigureKind::diagnosed},
    {"orbit_frequency", "orbit_frequency_hz", FigureKind::diagnosed}};

/// Values in SI, by their names in summary.json.
using Figures = std::map<std::string, double>;

/// The result of `tdbd converge` for a case: the values at every level, and the uncertainty of
/// those of the finest level.
struct StudiedConvergence {
  struct Level {
    std::vector<double> sizes;  ///< of the keys, SI
    Figures figures;
  };
  std::vector<std::string> keys;  ///< dotted, of what was divided: "time.step"
  std::vector<Level> levels;      ///< the finest last
  Figures left;                   ///< numerical uncertainty of the finest level
};

/// Reads a convergence.json, or a list of such objects in one file. Reads only the members of
/// StudiedConvergence. Throws InputError: "FILE: found ..., expected ...".
std::vector<StudiedConvergence> read_studied_convergence(const std::string& file);

/// The numerical uncertainty of a run's values x according to a study [+]: that of the finest level
/// n, and the distance from it,
///   U = |x - x_n| + U_n.
struct NumericalUncertainty {
  std::vector<std::string> keys;
  Figures figures;     ///< U by name; empty: not known
  std::string reason;  ///< why it is not known
};

/// Computes the uncertainty. `quantities`: of the case, SI, by dotted key; `figures`: of the run.
/// It is not known if no level has the sizes of the case, or if a mean of the run differs from that
/// of its level by more than the U of the level: then the study is of another case.
NumericalUncertainty numerical_uncertainty(const StudiedConvergence& study,
                                           const std::map<std::string, double>& quantities,
                                           const Figures& figures);

/// The keys before the first table of a case.
struct TitleSettings {
  std::string title;

  static constexpr TableKey table{"", "keys before the first table"};
  void visit(FieldVisitor& v, Need need = Need::defaulted) {
    v(title, {.name = "title",
              .need = need,
              .meaning = "of the case, for summary.json; empty: tdbd run writes the bit's name"});
  }
};

/// [bit]; `changes`: values that replace keys of the bit file.
struct BitSettings {
  std::string file;

  static constexpr TableKey table{"bit", "the bit"};
  void visit(FieldVisitor& v) {
    v.path(file, {.name = "file", .need = Need::required, .meaning = "the bit file (TOML)"});
  }
};

/// [bit.set], whose keys are those of the bit file.
struct BitChanges {
  static constexpr TableKey table{
      "bit.set", "values that replace keys of the bit file: bit.set.adjust.back_rake = \"2 deg\""};
  void visit(FieldVisitor& v) {
    v.any({.name = "KEY",
           .kind = "as in the bit file",
           .computed_default = "the bit file's",
           .meaning = "any key of the tables of `tdbd bit` below, dotted: gage_diameter, "
                      "cutters.chamfer, adjust.blade.2.azimuth"});
  }
};

/// [time]. Gives either a duration or a number of revolutions.
struct TimeSettings {
  double step = 0.0;
  double duration = 0.0;  ///< 0: required unless revolutions are given
  double revolutions = 0.0;
  long first_step = 0;

  static constexpr TableKey table{"time", "how long, and in which steps"};
  void visit(FieldVisitor& v) {
    const Need need_of_duration = v.gives("revolutions") ? Need::optional
                                  : duration > 0.0       ? Need::defaulted
                                                         : Need::required;
    v(step, {.name = "step",
             .unit = "s",
             .need = Need::required,
             .range = Range::positive(),
             .meaning = "time step; the bit must turn at most 0.5 rad in a step, and no part may "
                        "move farther than its size",
             .usual = Range::within(0.0, 0.2)});
    v(duration, {.name = "duration",
                 .unit = "s",
                 .need = need_of_duration,
                 .computed_default = "the path's; else required without revolutions",
                 .range = Range::positive(),
                 .meaning = "of the motion"});
    v(revolutions, {.name = "revolutions",
                    .need = Need::optional,
                    .computed_default = "in place of duration",
                    .range = Range::positive(),
                    .meaning = "of a bit with a rotary speed"});
    v(first_step,
      {.name = "first_step",
       .meaning = "steps of the motion made by an earlier run: this run continues from there"});
  }
};

/// How rock vertices leave the parts that cut.
struct UpdatePlan {
  bit::DirectionRule directions = bit::DirectionRule::hybrid;
  bit::InsideRule inside_cutters = bit::InsideRule::down;
  bit::GageRule gage_teeth = bit::GageRule::normal;
  rock::CuttingOptions cutting;
  int most_passes = 1000;

  static constexpr TableKey table{"update", "how rock vertices leave the parts that cut"};
  void visit(FieldVisitor& v) {
    v(directions, {.name = "directions",
                   .values = {{{"hybrid", bit::DirectionRule::hybrid},
                               {"all-down", bit::DirectionRule::all_down},
                               {"along-profile", bit::DirectionRule::along_profile}}},
                   .meaning = "update directions of cutters: eq. 4.2, or one of its extremes"});
    v(inside_cutters, {.name = "inside_cutters",
                       .values = {{{"down", bit::InsideRule::down},
                                   {"plus-x", bit::InsideRule::plus_x},
                                   {"minus-x", bit::InsideRule::minus_x}}},
                       .meaning = "direction e of eq. 4.2"});
    v(gage_teeth, {.name = "gage_teeth",
                   .values = {{{"normal", bit::GageRule::normal},
                               {"row", bit::GageRule::row},
                               {"down", bit::GageRule::down},
                               {"horizontal", bit::GageRule::horizontal}}},
                   .meaning = "update directions of the teeth of gage rows"});
    v(cutting.directions,
      {.name = "leaning",
       .values = {{{"upright", rock::DirectionFrame::upright}, {"bit", rock::DirectionFrame::bit}}},
       .meaning = "whether update directions lean with the bit's axis"});
    v(cutting.exit_from,
      {.name = "exit_from",
       .values = {{{"parts", rock::ExitFrom::parts}, {"whole", rock::ExitFrom::whole}}},
       .meaning = "parts: rock leaves the parts of a cutter one after another; whole: it leaves a "
                  "convex cutter at once, and the part through which it leaves has its volume"});
    v(most_passes, {.name = "most_passes",
                    .lo = 1,
                    .hi = 1'000'000,
                    .meaning = "passes of one step; more are an error"});
  }
};

enum class SectionMeasure { off, ahead };
enum class ContactMeasure { off, on };

/// The quantities that a run measures in every step, for forces.
struct MeasurePlan {
  SectionMeasure section = SectionMeasure::ahead;
  double section_lead = 1.7;
  rock::SectionAtFace section_at_face = rock::SectionAtFace::as_ahead;
  long section_every = 1;
  ContactMeasure contact = ContactMeasure::on;
  double contact_gap = 0.01;

  static constexpr TableKey table{"measure", "what a run measures in every step, for forces"};
  void visit(FieldVisitor& v) {
    v(section, {.name = "section",
                .values = {{{"ahead", SectionMeasure::ahead}, {"off", SectionMeasure::off}}},
                .meaning = "the section of uncut rock ahead of every cutter's face"});
    v(section_lead, {.name = "section_lead",
                     .range = Range::within(0.1, 10.0),
                     .meaning = "distance ahead of the face over rock.edge_length; sections are "
                                "too small unless it exceeds the longest edge"});
    v(section_at_face,
      {.name = "section_at_face",
       .values = {{{"as_ahead", rock::SectionAtFace::as_ahead},
                   {"extrapolated", rock::SectionAtFace::extrapolated}}},
       .meaning = "as_ahead: the section ahead of the face, exact in steady motion; extrapolated: "
                  "from sections at one and two leads, which takes about a fifth of a step"});
    v(section_every, {.name = "section_every",
                      .lo = 1,
                      .hi = 1000,
                      .meaning = "steps between the sections of a face; faces take turns and keep "
                                 "their last section; must be 1 if forces move the bit"});
    v(contact, {.name = "contact",
                .values = {{{"on", ContactMeasure::on}, {"off", ContactMeasure::off}}},
                .meaning = "the contact area of every part"});
    v(contact_gap, {.name = "contact_gap",
                    .range = Range::within(1e-6, 1.0),
                    .meaning = "largest distance that counts as contact, over rock.edge_length"});
  }
};

/// Whether a bit that is moved by forces observes the order of the residual of its energy.
enum class EnergyOrderOption {
  off,
  on,      ///< if that takes at most a tenth of the run's steps
  always,  ///< regardless of the number of steps
};

/// What moves the bit.
enum class BitMotion { prescribed, by_forces };

struct OutputPlan {
  long history_every = 1;
  long frames_every = 0;
  long checkpoint_every = -1;  ///< negative: chosen so that it takes less than 1 % of the time
  double means_from = 0.0;
  std::string convergence_file;
  EnergyOrderOption energy_order = EnergyOrderOption::on;
  long energy_order_window = 24;
  std::vector<StudiedConvergence> convergence = {};  ///< of the file
  ChainOutput chain = {};                            ///< for a string on a chain

  static constexpr TableKey table{"output", "what is recorded, and when"};
  void visit(FieldVisitor& v, BitMotion motion = BitMotion::by_forces) {
    v(history_every, {.name = "history_every",
                      .computed_default = "at most 10 000 rows",
                      .lo = 1,
                      .hi = 1'000'000'000,
                      .meaning = "steps between rows of the history; more than 1: a row has their "
                                 "means, sums, extremes"});
    v(frames_every, {.name = "frames_every",
                     .hi = 1'000'000'000,
                     .meaning = "steps between frames; 0: only the last one"});
    v(checkpoint_every,
      {.name = "checkpoint_every",
       .need = Need::optional,
       .computed_default = "so that they take less than 1 % of the time",
       .hi = 1'000'000'000,
       .meaning = "steps between checkpoints, from which `tdbd run --resume` resumes; 0: none"});
    v(means_from,
      {.name = "means_from",
       .unit = "s",
       .computed_default = "half of the run",
       .range = Range::non_negative(),
       .meaning = "since the beginning of the run: earlier steps do not count in means"});
    v.path(convergence_file,
           {.name = "convergence",
            .need = Need::optional,
            .computed_default = "none",
            .meaning = "a convergence.json of this case (`tdbd converge`), or a list of several in "
                       "one file: summary.json then has the numerical uncertainty of its means"});
    if (!v.when(motion == BitMotion::by_forces)) return;
    v(energy_order, {.name = "energy_order",
                     .values = {{{"on", EnergyOrderOption::on},
                                 {"off", EnergyOrderOption::off},
                                 {"always", EnergyOrderOption::always}}},
                     .meaning = "drilling: whether to observe the order of the energy's residual; "
                                "on: if that takes at most a tenth of the run's steps"});
    v(energy_order_window, {.name = "energy_order_window",
                            .lo = 8,
                            .hi = 1'000'000,
                            .meaning = "drilling: steps of that observation; all its levels "
                                       "together take seven times as many"});
  }
};

}  // namespace tdbd::simulation
