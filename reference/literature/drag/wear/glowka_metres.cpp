#include "reference/literature/drag/wear/glowka_metres.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/error.hpp"

namespace tdbd::reference {
namespace {

/// The arrays of a run, and its constant data.
struct WearStepper {
  const GlowkaBit& bit;
  const GlowkaLaw& law;
  const FlatHeat& heat;
  const WearLaw& wear;
  const GlowkaRun& run;
  std::vector<double> worn, slope, ahead, slope_ahead;
  GlowkaLoads loads;
};

/// dy/ds of every cutter, 1.
void wear_slopes(WearStepper& s, const std::vector<double>& worn, std::vector<double>& slope) {
  glowka_loads(s.bit, s.law, s.heat, worn, s.run, s.loads);
  slope.resize(worn.size());
  const double per_metre = s.run.advance * s.run.rotary_speed / (2.0 * std::numbers::pi);  // m/s
  for (std::size_t i = 0; i < worn.size(); ++i) {
    const bit::Cutter& c = s.bit.cutters[i];
    const GlowkaCutterLoad& load = s.loads.cutters[i];
    slope[i] = wear_speed(s.wear, glowka_face(c), load.temperature, load.flat_stress,
                          s.run.rotary_speed * c.tip_radius) /
               per_metre;
  }
}

/// Tries a step with given slopes at its start. Returns the largest difference between Heun's and
/// Euler's method over the allowed error.
double try_wear_step(WearStepper& s, double step, const GlowkaWearOptions& options) {
  for (std::size_t i = 0; i < s.worn.size(); ++i) s.ahead[i] = s.worn[i] + step * s.slope[i];
  wear_slopes(s, s.ahead, s.slope_ahead);
  double error = 0.0;
  for (std::size_t i = 0; i < s.worn.size(); ++i)
    error = std::max(error,
                     0.5 * step * std::abs(s.slope_ahead[i] - s.slope[i]) /
                         std::max(options.height_tolerance, options.share_tolerance * s.worn[i]));
  return error;
}

void take_wear_step(WearStepper& s, double step) {
  for (std::size_t i = 0; i < s.worn.size(); ++i)
    s.worn[i] += 0.5 * step * (s.slope[i] + s.slope_ahead[i]);
}

std::optional<std::size_t> worn_out_cutter(const WearStepper& s) {
  for (std::size_t i = 0; i < s.worn.size(); ++i)
    if (s.worn[i] >= s.bit.cutters[i].diameter / 2.0) return i;
  return std::nullopt;
}

void record_wear(WearStepper& s, double distance, GlowkaWear& result) {
  GlowkaWearRecord r{.distance = distance, .worn = s.worn, .loads = {}};
  glowka_loads(s.bit, s.law, s.heat, s.worn, s.run, r.loads);
  result.records.push_back(std::move(r));
}

/// Drills to a distance. Returns false if a cutter is worn out. `step`: m, the last one tried.
bool wear_to(WearStepper& s, double goal, double& distance, double& step,
             const GlowkaWearOptions& options, GlowkaWear& result) {
  constexpr double usual_growth = 2.0, care = 0.9, least_factor = 0.2;
  while (distance < goal) {
    const double left = goal - distance, tried = std::min(step, left);
    wear_slopes(s, s.worn, s.slope);
    const double error = try_wear_step(s, tried, options);
    if (result.steps + result.refused >= options.most_steps)
      throw RunError("Glowka: wear took " + std::to_string(options.most_steps) +
                     " steps and did not reach " + std::to_string(goal) + " m");
    const double factor = care / std::sqrt(std::max(error, 1e-300));
    if (tried == step || factor < 1.0)
      step = tried * std::clamp(factor, least_factor, usual_growth);
    if (error > 1.0) {
      ++result.refused;
      continue;
    }
    ++result.steps;
    take_wear_step(s, tried);
    distance = tried == left ? goal : distance + tried;
    if ((result.worn_out = worn_out_cutter(s))) return false;
  }
  return true;
}

void check_wear_run(const GlowkaBit& bit, const GlowkaLaw& law, const WearLaw& wear,
                    const GlowkaWearOptions& options) {
  const auto require = [](bool good, const std::string& found, const std::string& expected) {
    if (!good) throw InputError("Glowka: found " + found + ", expected " + expected);
  };
  require(options.distance > 0.0, "no distance to drill", "one above 0");
  require(options.records > 0, "no records", "at least one");
  require(options.height_tolerance > 0.0, "no tolerance of height", "one above 0");
  require(law.flat_stress.value > 0.0, "a law without stress under a wear flat",
          "one above 0: wear needs it");
  require(wear.coefficient > 0.0, "no wear coefficient", "one above 0");
  for (const bit::Cutter& c : bit.cutters)
    require(c.back_rake > 0.0, "cutter " + std::to_string(c.id) + " without back rake",
            "one above 0: its flat has no end");
}

}  // namespace

GlowkaWear glowka_wear(const GlowkaBit& bit, const GlowkaLaw& law, const FlatHeat& heat,
                       const WearLaw& wear, const GlowkaRun& run,
                       const GlowkaWearOptions& options) {
  check_wear_run(bit, law, wear, options);
  WearStepper s{bit, law, heat, wear, run, {}, {}, {}, {}, {}};
  for (const bit::Cutter& c : bit.cutters) s.worn.push_back(c.wear / std::cos(c.back_rake));
  s.ahead.resize(s.worn.size());
  GlowkaWear result;
  record_wear(s, 0.0, result);
  double distance = 0.0, step = options.distance / options.records;
  for (int i = 1; i <= options.records; ++i) {
    const bool whole =
        wear_to(s, options.distance * i / options.records, distance, step, options, result);
    record_wear(s, distance, result);
    if (!whole) break;
  }
  return result;
}

}  // namespace tdbd::reference
