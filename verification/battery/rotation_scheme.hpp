#pragma once

#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "dynamics/rotation/step.hpp"
#include "verification/battery/dual.hpp"

namespace tdbd::battery {

/// A rule that carries a gyrostat over one step, in plain numbers, in extended precision and with
/// derivatives. The battery checks every scheme in the same way: the program's, and those that are
/// broken on purpose.
struct RotationScheme {
  template <class S>
  using Step = std::function<void(const dynamics::Gyrostat&, const dynamics::Loads&, double,
                                  dynamics::RotatingOf<S>&)>;
  std::string name;
  int order = 2;
  Step<double> step;
  Step<long double> step_extended;
  Step<Jet> step_jet;

  template <class S>
  const Step<S>& step_of() const {
    if constexpr (std::is_same_v<S, double>)
      return step;
    else if constexpr (std::is_same_v<S, long double>)
      return step_extended;
    else
      return step_jet;
  }
};

/// The program's step with these options.
RotationScheme production(const std::string& name, const dynamics::Integrator& integrator);

/// A step whose drift is replaced: kick(h/2), drift(h), kick(h/2). `drift` takes any scalar.
template <class DriftRule>
RotationScheme with_drift(const std::string& name, DriftRule drift) {
  const auto step = [drift](const dynamics::Gyrostat& g, const dynamics::Loads& loads, double h,
                            auto& r) {
    dynamics::kick(0.5 * h, r.torque, r.state);
    drift(g, h, r.state);
    r.state.time += h;
    dynamics::closing_kick(g, loads, dynamics::VelocityTorque::predicted, 0.5 * h, r);
  };
  return {name, 2, step, step, step};
}

/// Every drift at order 2, the thesis's form (two drifts a step) included.
std::vector<RotationScheme> second_order_schemes();

/// Every drift at this order, one drift a stage.
std::vector<RotationScheme> composed_schemes(int order);

}  // namespace tdbd::battery
