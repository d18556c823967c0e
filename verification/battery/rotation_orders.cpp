#include "verification/battery/rotation_orders.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/observed_order.hpp"

namespace tdbd::battery {
namespace {

/// Reference states at half of the time and at its end.
template <class S>
using Reference = std::array<dynamics::RotationStateOf<S>, 2>;

/// States of the scheme at half of the time and at its end, after an even number of steps.
template <class S>
Reference<S> run(const RotationScheme& scheme, const GoldenCase& c, long steps) {
  const double h = c.states.back().time / static_cast<double>(steps);
  auto r = dynamics::start(c.gyrostat, c.loads, as_scalar<S>(c.initial));
  Reference<S> states;
  for (long i = 1; i <= steps; ++i) {
    scheme.step_of<S>()(c.gyrostat, c.loads, h, r);
    if (2 * i == steps) states[0] = r.state;
  }
  states[1] = r.state;
  return states;
}

/// At one time alone an error may pass through zero.
template <class S>
StateErrors largest_errors(const Reference<S>& a, const Reference<S>& b) {
  const StateErrors half = state_errors(a[0], b[0]), end = state_errors(a[1], b[1]);
  StateErrors largest{};
  for (std::size_t v = 0; v < largest.size(); ++v) largest[v] = std::max(half[v], end[v]);
  return largest;
}

RotationScheme eighth_order() {
  return production("split order 8", {dynamics::Drift::split, 1, 8});
}

/// A reference, and the rounding of errors against it.
template <class S>
struct Yardstick {
  Reference<S> reference;
  StateErrors floor{};
};

constexpr double margin = 20.0;  ///< of the floor over the largest rounding seen

template <class S>
void raise_floor(Yardstick<S>& y, const GoldenCase& c, double least) {
  for (const long steps : {1200L, 1448L, 1700L}) {
    const StateErrors e = largest_errors(run<S>(eighth_order(), c, steps), y.reference);
    for (std::size_t v = 0; v < e.size(); ++v)
      y.floor[v] = std::max({y.floor[v], margin * e[v], margin * least});
  }
}

Yardstick<double> golden_yardstick(const GoldenCase& c) {
  Yardstick<double> y;
  y.reference = {as_state(golden_at(c, 0.5 * c.states.back().time)), as_state(c.states.back())};
  raise_floor(y, c, 1e-13);  // momenta and angles of order one
  return y;
}

Yardstick<long double> extended_yardstick(const GoldenCase& c) {
  Yardstick<long double> y;
  y.reference = run<long double>(eighth_order(), c, 2048);
  raise_floor(y, c, 1e-17);
  return y;
}

/// Errors over falling steps.
struct Levels {
  std::vector<double> steps;
  std::vector<StateErrors> errors;
};

template <class S>
Levels run_levels(const RotationScheme& scheme, const GoldenCase& c, const Yardstick<S>& y) {
  const double refinement = std::pow(2.0, 0.25);
  const double finest = scheme.order == 2 ? 16384.0 : 2048.0;  // pairs of steps
  Levels levels;
  long last = 0;
  for (double n = 4.0; n <= finest; n *= refinement) {
    const long steps = 2 * std::lround(n);
    if (std::exchange(last, steps) == steps) continue;
    try {
      levels.errors.push_back(largest_errors(run<S>(scheme, c, steps), y.reference));
      levels.steps.push_back(c.states.back().time / static_cast<double>(steps));
    } catch (const RunError&) {
      continue;  // too large a step for a drift that solves an equation
    }
  }
  return levels;
}

VariableOrder fit(const Levels& levels, std::size_t variable, double floor) {
  constexpr std::size_t most = 6;
  VariableOrder o;
  o.variable = state_variables[variable];
  std::vector<double> steps, errors;
  for (std::size_t i = levels.steps.size(); i-- > 0 && errors.size() < most;) {
    if (levels.errors[i][variable] <= floor) continue;
    steps.push_back(levels.steps[i]);
    errors.push_back(levels.errors[i][variable]);
  }
  o.levels = static_cast<int>(errors.size());
  o.exact = errors.empty();
  if (o.levels >= 2) o.order = least_squares_order(steps, errors);
  return o;
}

template <class S>
std::vector<VariableOrder> fit_all(const RotationScheme& scheme, const GoldenCase& c,
                                   const Yardstick<S>& y) {
  const Levels levels = run_levels(scheme, c, y);
  std::vector<VariableOrder> orders;
  for (std::size_t v = 0; v < state_variables.size(); ++v)
    orders.push_back(fit(levels, v, y.floor[v]));
  return orders;
}

}  // namespace

std::vector<VariableOrder> observed_orders(const RotationScheme& scheme, const GoldenCase& c) {
  if (scheme.order == 2) return fit_all(scheme, c, golden_yardstick(c));
  return fit_all(scheme, c, extended_yardstick(c));
}

}  // namespace tdbd::battery
