#include "simulation/result/answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/units.hpp"

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
  if (drifts) return fmt::format("{}; {}, which still drift", motion, means);
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

}  // namespace tdbd::simulation
