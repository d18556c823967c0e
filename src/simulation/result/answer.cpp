#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "bit/cone/cone_bit.hpp"
#include "core/units.hpp"
#include "dynamics/schedule.hpp"
#include "rock/section/rubbing_contact.hpp"
#include "simulation/case/doubtful_values.hpp"
#include "simulation/result/summary.hpp"
#include "simulation/start/rock_start.hpp"

namespace tdbd::simulation {
namespace {

constexpr double per_cent = 100.0;

/// A unit in which an answer is printed.
struct AnswerUnit {
  std::string name;
  double si = 1.0;  ///< its value in SI
};

/// "1 kN" with its SI unit.
AnswerUnit unit_of(const std::string& name, const std::string& si_unit) {
  return {name, to_si("1 " + name, si_unit)};
}

struct UnitSet {
  AnswerUnit force, torque, rate, length, stress;
};

UnitSet units_of(AnswerUnits units) {
  if (units == AnswerUnits::metric)
    return {unit_of("kN", "N"),
            {"kN m", 1e3},
            unit_of("m/h", "m/s"),
            unit_of("mm", "m"),
            unit_of("MPa", "Pa")};
  const AnswerUnit lbf = unit_of("lbf", "N"), ft = unit_of("ft", "m");
  return {lbf,
          {"ft lbf", ft.si * lbf.si},
          unit_of("ft/h", "m/s"),
          unit_of("in", "m"),
          unit_of("psi", "Pa")};
}

std::string quantity(double value, const std::optional<double>& half_width, const AnswerUnit& u) {
  const auto scaled = half_width ? std::optional(*half_width / u.si) : std::nullopt;
  return with_half_width(value / u.si, scaled) + " " + u.name;
}

std::string labelled(const char* label, const std::string& text) {
  return fmt::format("{:<16} {}", label, text);
}

std::string weight_text(const RunSummary& s, const UnitSet& u) {
  std::string text = quantity(s.loads->wob.mean, s.loads->uncertainty.wob, u.force);
  if (!s.set_weight) return text;
  text += fmt::format("; set: {:.4g} {}", *s.set_weight / u.force.si, u.force.name);
  if (*s.set_weight > 0.0)
    text +=
        fmt::format(", difference {:+.2g} %", per_cent * (s.loads->wob.mean / *s.set_weight - 1.0));
  return text;
}

std::string rate_text(const LoadStatisticsSummary& f, const UnitSet& u) {
  constexpr double rpm = 2.0 * std::numbers::pi / 60.0;
  const double turns = f.rotary_speed.mean / (2.0 * std::numbers::pi);
  std::string text = quantity(f.rop.mean, f.uncertainty.rop, u.rate) +
                     fmt::format(" at {:.4g} rpm", f.rotary_speed.mean / rpm);
  if (std::abs(turns) > 0.0)
    text += fmt::format(", {:.4g} {} per revolution", f.rop.mean / std::abs(turns) / u.length.si,
                        u.length.name);
  return text;
}

std::string energy_text(const LoadStatisticsSummary& f, const UnitSet& u) {
  if (!(f.rop.mean > 0.0)) return "not defined: the bit does not advance";
  return quantity(f.specific_energy, {}, u.stress);
}

std::string imbalance_text(const LoadStatisticsSummary& f) {
  if (!(f.wob.mean > 0.0)) return "not defined: the bit carries no weight";
  const auto half =
      f.uncertainty.imbalance ? std::optional(per_cent * *f.uncertainty.imbalance) : std::nullopt;
  return fmt::format("{} % of the weight on bit, azimuth {:.0f} deg",
                     with_half_width(per_cent * f.imbalance, half),
                     f.imbalance_azimuth * 180.0 / std::numbers::pi);
}

/// The steady state of the means, after the vibrations of a bit that forces move.
std::string diagnosis_text(const RunSummary& s) {
  const SteadyState& steady = s.steady;
  const bool drifts = !steady.is_steady.value_or(true);
  std::string motion = s.drive ? s.diagnosis.text : "prescribed motion";
  if (s.drive && drifts && motion == "steady") motion = "no vibrations";
  if (motion.empty()) motion = "none, the run is too short";
  const std::string means =
      "means over " + counted(fmt::format("{:.3g}", steady.revolutions), "revolution");
  if (drifts) return fmt::format("{}; {}, not steady yet", motion, means);
  if (steady.is_steady) return fmt::format("{}; {}", motion, means);
  return fmt::format("{}; {}, too few for a test of steadiness", motion, means);
}

}  // namespace

std::string with_half_width(double value, std::optional<double> half_width) {
  constexpr int usual_digits = 4, most_digits = 6, most_decimals = 12;
  constexpr double negligible = 1e-6, whole = 10.0;
  const auto leading = [](double x) {
    return x == 0.0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(x))));
  };
  if (!half_width || !(*half_width > negligible * std::abs(value)))
    return fmt::format("{:.{}f}", value,
                       std::clamp(usual_digits - 1 - leading(value), 0, most_decimals));
  const int most = std::clamp(most_digits - 1 - leading(value), 0, most_decimals);
  const int decimals = std::clamp(1 - leading(*half_width), 0, most);
  return fmt::format("{:.{}f} +- {}", value, decimals,
                     *half_width < whole ? fmt::format("{:.2g}", *half_width)
                                         : fmt::format("{:.0f}", *half_width));
}

std::string volume_text(double volume, AnswerUnits units) {
  const AnswerUnit length = unit_of(units == AnswerUnits::metric ? "cm" : "in", "m");
  return fmt::format("{:.4f} {}3", volume / (length.si * length.si * length.si), length.name);
}

std::vector<std::string> answer_lines(const RunSummary& s, AnswerUnits units) {
  if (!s.loads) return {labelled("forces", "not computed: the case has no table [forces]")};
  const LoadStatisticsSummary& f = *s.loads;
  if (f.steps == 0) return {labelled("means", "none: the run ended before output.means_from")};
  const UnitSet u = units_of(units);
  return {labelled("weight on bit", weight_text(s, u)),
          labelled("torque on bit", quantity(f.tob.mean, f.uncertainty.tob, u.torque)),
          labelled("rate", rate_text(f, u)),
          labelled("specific energy", energy_text(f, u)),
          labelled("imbalance", imbalance_text(f)),
          labelled("diagnosis", diagnosis_text(s))};
}

namespace {

std::string no_rock(const Case& c, const Simulation& s) {
  const std::string text = "the bit removed no rock in " +
                           counted(std::to_string(s.state.steps_done - c.time.first), "step");
  const double gap = gap_along_path(c, s.state.rock.surface);
  return gap > 0.0 ? fmt::format("{}: it stays {:.3g} m or more from it", text, gap) : text;
}

/// Returns a warning if the mean advance is unrealistic, otherwise "". Bits slower than a tenth of
/// a metre per second are not checked: they are realistic, and bits that stick hardly turn.
std::string fast(const Case& c, const LoadStatistics& loads) {
  const double width = narrowest_width(c.bit), rate = loads.rop.mean;
  const double turns = std::abs(loads.rotary_speed.mean) / (2.0 * std::numbers::pi);
  if (rate * c.time.step > width)
    return fmt::format(
        "the bit advances {:.3g} m/s, {:.3g} mm in a step: more than the {:.3g} mm "
        "of its narrowest cutting part",
        rate, 1e3 * rate * c.time.step, 1e3 * width);
  constexpr double fastest = 0.1;  // m/s
  if (rate > fastest && turns > 0.0 && rate / turns > width)
    return fmt::format(
        "the bit advances {:.3g} m/s, {:.3g} mm in a revolution: more than the "
        "{:.3g} mm of its narrowest cutting part, so that its body would have to cut",
        rate, 1e3 * rate / turns, 1e3 * width);
  return "";
}

/// Whether rock may be inside a part. Rock moves away from cutting parts, but not from parts that
/// only rub or from bodies.
bool may_lie_in_rock(const bit::Part& part) {
  return final_cutting(part) == bit::Cutting::rubs ||
         (part.cutting == bit::Cutting::never && part.kind == bit::PartKind::bit_body);
}

/// Returns a warning if the part is deeper in rock than the rock's edge length and than a
/// millimetre, otherwise "".
std::string deep_in_rock(const Case& c, const Simulation& s, std::size_t index) {
  const bit::Part& part = c.bit.parts[index];
  constexpr double least = 1e-3;  // m
  const Pose X_WP =
      over_rock(s.state.place) * bit::part_pose(c.bit, part, angles_of(s.state.cones));
  const double depth = rock::depth_in_rock(s.state.rock.surface, part, X_WP);
  if (depth <= std::max(least, c.rock.edge_length)) return "";
  const bool bears = c.forces.forces == Forces::on && final_cutting(part) == bit::Cutting::rubs &&
                     has_law(c.forces, c.bit, index);
  return fmt::format(
      "{} is {:.3g} mm deep in rock at the end of the run, after {:.4g} s: it removes "
      "no rock{}",
      part.name, 1e3 * depth, time_at(c.time, s.state.steps_done),
      bears ? "" : ", and no force acts on it");
}

/// Returns the volumes (m3) that parts without any force removed in this run, by kind.
std::array<double, bit::part_kinds.size()> removed_for_nothing(const Case& c, const Simulation& s) {
  std::array<double, bit::part_kinds.size()> removed{};
  for (std::size_t i = 0; i < s.statistics.energy_by_part.size(); ++i)
    if (s.statistics.energy_by_part[i] == 0.0)
      removed[static_cast<std::size_t>(c.bit.parts[i].kind)] +=
          s.state.ledger.removed_by_part[i].value();
  return removed;
}

/// Returns a warning if parts of the kind removed rock without a force, otherwise "". The threshold
/// is a ten-thousandth of all rock, because the body of a cutter removes some of the rock that the
/// finite time step leaves beside the groove of its rim.
std::string free_rock(const Case& c, const Simulation& s, bit::PartKind kind, double removed) {
  constexpr double mm3_per_m3 = 1e9, percent = 100.0, least_share = 1e-4;
  if (removed <= least_share * s.state.ledger.removed.value()) return "";
  return fmt::format(
      "parts of the kind {} removed {:.3g} mm3 of rock, {:.3g} % of all, at zero force{}",
      bit::kind_name(kind), mm3_per_m3 * removed,
      percent * removed / s.state.ledger.removed.value(),
      has_law(c.forces, kind) ? "" : fmt::format(": set forces.{}.law", bit::kind_key(kind)));
}

/// Returns a warning if a bit with cutters sticks and slips although sections are not extrapolated
/// to the face, otherwise "".
std::string lagging_sections(const Case& c, const Simulation& s) {
  if (c.bit.cutters.empty() || c.measure.section == SectionMeasure::off ||
      c.measure.section_at_face == rock::SectionAtFace::extrapolated)
    return "";
  const double severity =
      diagnose(s.statistics.trace, s.statistics.loads.tob.mean).stick_slip_severity;
  if (severity <= severe_stick_slip) return "";
  return fmt::format(
      "the bit sticks and slips, severity {:.2f}, so that its depth of cut changes from turn to "
      "turn: measure.section_at_face = \"extrapolated\" is more accurate then",
      severity);
}

/// Returns a warning if the mean weight on bit is not the set one, otherwise "". Without an
/// interval of the mean nothing is known about its error.
std::string missed_weight(const Case& c, const Simulation& s) {
  constexpr double least = 0.01, percent = 100.0, kilo = 1e-3;
  const double to = time_at(c.time, s.state.steps_done), mean = s.statistics.loads.wob.mean;
  const std::optional<double> set = set_weight(c, to - s.statistics.loads.time, to);
  const std::optional<double> interval = batch_uncertainty(s.statistics.trace.wob);
  if (!set || !(*set > 0.0) || !interval) return "";
  const double missed = mean - *set;
  if (std::abs(missed) <= std::max(least * *set, *interval)) return "";
  return fmt::format(
      "the mean weight on bit, {:.4g} kN, differs from the set {:.4g} kN by {:+.2g} %, more than "
      "its 95 % interval of +-{:.2g} kN: the bit still accelerates, or dampers and springs "
      "of [string] carry the rest; run longer, or change string.axial_damping",
      kilo * mean, kilo * *set, percent * missed / *set, kilo * *interval);
}

/// Returns a warning if means drift, otherwise "".
std::string drifting(const Simulation& s) {
  const SteadyState steady = steady_state(s.statistics.trace);
  if (steady.is_steady.value_or(true)) return "";
  return fmt::format(
      "the run is too short for its means, which cover {}: from their first to their second half "
      "they change, {}; run longer, or set a later output.means_from",
      counted(fmt::format("{:.3g}", steady.revolutions), "revolution"), drifting_means(steady));
}

}  // namespace

std::optional<double> set_weight(const Case& c, double from, double to) {
  constexpr int samples = 1000;
  const bool is_set = c.motion.kind == MotionKind::drilling && !c.drilling.system.chained &&
                      c.drilling.system.top.axial == dynamics::AxialMode::load;
  if (!is_set) return std::nullopt;
  const dynamics::Schedule& load = c.drilling.system.top.load;
  if (load.values.size() < 2) return dynamics::value_at(load, from);
  double mean = 0.0;
  for (int i = 0; i < samples; ++i)
    mean += dynamics::value_at(load, from + (i + 0.5) / samples * (to - from)) / samples;
  return mean;
}

std::vector<CaseWarning> end_warnings(const Case& c, const Simulation& s) {
  std::vector<CaseWarning> warnings;
  const auto add = [&](const std::string& text) {
    warnings.push_back({c.places.motion, std::string(Motion::table.name), text});
  };
  for (std::size_t i = 0; i < c.bit.parts.size(); ++i)
    if (may_lie_in_rock(c.bit.parts[i]))
      if (const std::string text = deep_in_rock(c, s, i); !text.empty()) add(text);
  if (s.state.ledger.removed.value() == 0.0) {
    if (s.state.steps_done > c.time.first) add(no_rock(c, s));
    return warnings;
  }
  if (c.forces.forces == Forces::on) {
    const auto removed = removed_for_nothing(c, s);
    for (const bit::PartKind kind : bit::part_kinds)
      if (const std::string text = free_rock(c, s, kind, removed[static_cast<std::size_t>(kind)]);
          !text.empty())
        add(text);
  }
  if (s.statistics.loads.rop.count == 0) return warnings;
  if (s.state.drive)
    for (const std::string& text :
         {fast(c, s.statistics.loads), lagging_sections(c, s), missed_weight(c, s)})
      if (!text.empty()) add(text);
  if (const std::string text = drifting(s); !text.empty()) add(text);
  return warnings;
}

}  // namespace tdbd::simulation
