// The production step, called as in a program.

#include <cmath>

#include "benchmarks/rotation/method.hpp"
#include "dynamics/rotation/step.hpp"

namespace tdbd::bench {
namespace {

class TdbdIntegration final : public Integration {
 public:
  TdbdIntegration(const RotationCase& c, const dynamics::Integrator& integrator, double h)
      : case_(c), integrator_(integrator), h_(h) {
    rotating_ = dynamics::start(case_.body, case_.loads, start_of(case_));
  }

  void take(long steps) override {
    for (long i = 0; i < steps; ++i)
      dynamics::step(case_.body, case_.loads, integrator_, h_, rotating_);
    steps_ += steps;
  }
  void run_to_end() override { take(std::lround(case_.duration / h_)); }
  dynamics::RotationState state() const override { return rotating_.state; }
  long steps() const override { return steps_; }
  long torque_evaluations() const override { return rotating_.evaluations; }

 private:
  RotationCase case_;
  dynamics::Integrator integrator_;
  double h_;
  dynamics::Rotating rotating_;
  long steps_ = 0;
};

Method method(const char* name, dynamics::Drift drift, int drifts_per_step, int order) {
  const dynamics::Integrator integrator{
      .drift = drift, .drifts_per_step = drifts_per_step, .order = order};
  return {name, Control::step,
          [integrator](const RotationCase& c, double h) -> std::unique_ptr<Integration> {
            return std::make_unique<TdbdIntegration>(c, integrator, h);
          }};
}

}  // namespace

Contender tdbd() {
  using enum dynamics::Drift;
  return {"TDBD",
          "",
          {method("split", split, 1, 2), method("split order 4", split, 1, 4),
           method("split order 6", split, 1, 6), method("split order 8", split, 1, 8),
           method("three-axis", three_axis, 1, 2), method("three-axis order 4", three_axis, 1, 4),
           method("three-axis order 6", three_axis, 1, 6),
           method("three-axis order 8", three_axis, 1, 8), method("lie-mean", lie_mean, 1, 2),
           method("lie-mean order 4", lie_mean, 1, 4), method("lie-mean order 6", lie_mean, 1, 6),
           method("lie-mean order 8", lie_mean, 1, 8), method("lie-midpoint", lie_midpoint, 1, 2),
           method("lie-midpoint twice", lie_midpoint, 2, 2),
           method("lie-midpoint order 4", lie_midpoint, 1, 4),
           method("lie-midpoint order 6", lie_midpoint, 1, 6),
           method("lie-midpoint order 8", lie_midpoint, 1, 8)}};
}

}  // namespace tdbd::bench
