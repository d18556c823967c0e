#include "verification/battery/rotation_scheme.hpp"

namespace tdbd::battery {
namespace {

using dynamics::Drift;

struct Named {
  Drift drift;
  const char* name;
};
constexpr Named drifts[] = {{Drift::split, "split"},
                            {Drift::three_axis, "three-axis"},
                            {Drift::lie_midpoint, "lie-midpoint"},
                            {Drift::lie_mean, "lie-mean"}};

}  // namespace

RotationScheme production(const std::string& name, const dynamics::Integrator& integrator) {
  const auto step = [integrator](const dynamics::Gyrostat& g, const dynamics::Loads& loads,
                                 double h, auto& r) { dynamics::step(g, loads, integrator, h, r); };
  return {name, integrator.order, step, step, step};
}

std::vector<RotationScheme> second_order_schemes() {
  std::vector<RotationScheme> schemes = composed_schemes(2);
  for (const Named& d : drifts)
    schemes.push_back(production(std::string(d.name) + " x2", {d.drift, 2, 2}));
  return schemes;
}

std::vector<RotationScheme> composed_schemes(int order) {
  std::vector<RotationScheme> schemes;
  for (const Named& d : drifts) {
    dynamics::Integrator integrator{d.drift, 1, order, dynamics::VelocityTorque::predicted};
    if (order > 2) integrator.velocity_torque = dynamics::VelocityTorque::symmetric;
    const std::string suffix = order == 2 ? "" : " order " + std::to_string(order);
    schemes.push_back(production(d.name + suffix, integrator));
  }
  return schemes;
}

}  // namespace tdbd::battery
