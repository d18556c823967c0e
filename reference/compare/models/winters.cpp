#include "reference/literature/roller/wheel/winters.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "reference/compare/models/answers.hpp"

namespace tdbd::reference {
namespace {

constexpr const char* no_shape = "it knows neither shapes nor teeth: one formula for the rate";

}  // namespace

Findings run_winters_model(const Question& q) {
  const CompareCase& c = q.asked;
  const WintersSettings& s = c.options.winters;
  Findings f;
  if (s.weights.empty())
    set_missing(
        f, Quantity::rate_at_weight,
        "needs constants: compare.winters.weights and rates, three or more, to fit them to");
  else if (q.weight <= 0.0)
    set_missing(f, Quantity::rate_at_weight, no_weight);
  else {
    WintersRun run{q.weight, 2.0 * c.ours.bit.gage_radius, c.ours.motion.rotary_speed};
    std::vector<WintersPoint> points;
    for (std::size_t i = 0; i < s.weights.size(); ++i)
      points.push_back({{s.weights[i], run.diameter, run.rotary_speed}, s.strength, s.rates[i]});
    const WintersFit fit = fit_winters(points);
    say(f, Quantity::rate_at_weight, winters_rate(fit.constants, run, s.strength));
    f.notes.push_back(fmt::format("fitted to {} rates: a eps_d {:.4g}, phi {:.4g}, b + c {:.4g}",
                                  s.weights.size(), fit.constants.ductility, fit.constants.offset,
                                  fit.constants.teeth));
  }
  set_missing(f,
              {Quantity::weight, Quantity::torque, Quantity::work_of_a_turn_torque,
               Quantity::torque_at_weight, Quantity::removed_per_revolution},
              "it relates a rate and a strength, and nothing else");
  set_missing(f, lateral, no_shape);
  set_missing(f, noises, "steady: one state for all times");
  set_missing(f, Quantity::torque_noise_by_crossing, no_spokes);
  set_missing(f, of_cones, no_shape);
  set_missing(f, Quantity::resolution_at_gage, "it keeps no bottom");
  set_missing(f, Quantity::share_moved_backwards, no_cutters);
  set_missing(f, flats, no_wear);
  return f;
}

}  // namespace tdbd::reference
