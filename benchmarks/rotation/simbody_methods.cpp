// Simbody: the body on a Ball at the fixed point, gravity on an offset centre of mass, every cone
// as a separate body on a Pin. Compiled as C++17, because Simbody 3.7 compares its indices in a way
// that is ambiguous in C++20.

// Our headers use std::numbers, which C++17 does not have.
namespace std::numbers {
inline constexpr double pi = 3.141592653589793238;
}

#include <Simbody.h>

#include "benchmarks/rotation/method.hpp"

namespace tdbd::bench {
namespace {

constexpr double mass = 1.0, arm = 0.1;  // kg, m: only their product with gravity matters

SimTK::Vec3 to_simtk(const Vec3& v) { return {v[0], v[1], v[2]}; }

SimTK::Inertia to_inertia(const Mat3& I) {
  return {I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)};
}

/// Body, cones and gravity as Simbody's own objects.
struct Assembly {
  explicit Assembly(const RotationCase& c) : matter(system), forces(system) {
    const bool is_heavy = c.loads.gravity_moment != 0.0;
    const Vec3 centre_B = (is_heavy ? arm : 0.0) * c.loads.gravity_arm_B;
    const SimTK::MassProperties all(mass, to_simtk(centre_B),
                                    to_inertia(inertia_without_cones(c.body)));
    body = SimTK::MobilizedBody::Ball(matter.Ground(), SimTK::Body::Rigid(all));
    for (const dynamics::Cone& cone : c.body.cones) add_cone(cone);
    const double g = c.loads.gravity_moment / (mass * arm);
    if (is_heavy) SimTK::Force::UniformGravity(forces, matter, SimTK::Vec3(0, 0, -g));
    system.realizeTopology();
  }

  /// A Pin rotates about the z axis of its frame.
  void add_cone(const dynamics::Cone& cone) {
    const SimTK::Rotation along(SimTK::UnitVec3(to_simtk(cone.axis_B)), SimTK::ZAxis);
    const SimTK::Transform X(along, SimTK::Vec3(0));
    const SimTK::MassProperties own(mass, SimTK::Vec3(0), to_inertia(cone_inertia(cone)));
    cones.push_back(SimTK::MobilizedBody::Pin(body, X, SimTK::Body::Rigid(own), X));
  }

  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter;
  SimTK::GeneralForceSubsystem forces;
  SimTK::MobilizedBody::Ball body;
  std::vector<SimTK::MobilizedBody::Pin> cones;
};

SimTK::State first_state(const RotationCase& c, const Assembly& a) {
  SimTK::State s = a.system.getDefaultState();
  const Eigen::Quaterniond q = start_of(c).q_WB;
  a.body.setQToFitRotation(s, SimTK::Rotation(SimTK::Quaternion(q.w(), q.x(), q.y(), q.z())));
  a.body.setUToFitAngularVelocity(s, to_simtk(q * c.w_B));
  for (std::size_t k = 0; k < c.spins.size(); ++k) a.cones[k].setOneU(s, 0, c.spins[k]);
  a.system.realize(s, SimTK::Stage::Acceleration);
  return s;
}

template <class Integrator>
class SimbodyIntegration final : public Integration {
 public:
  SimbodyIntegration(const RotationCase& c, Control control, double setting)
      : case_(c), assembly_(c), integrator_(assembly_.system) {
    if (control == Control::step) integrator_.setFixedStepSize(setting);
    if (control == Control::tolerance) integrator_.setAccuracy(setting);
    integrator_.setReturnEveryInternalStep(true);
    integrator_.initialize(first_state(case_, assembly_));
    realizations_before_ = integrator_.getNumRealizations();
  }

  void take(long steps) override {
    for (const long last = this->steps() + steps; this->steps() < last;)
      integrator_.stepTo(SimTK::Infinity);
  }
  void run_to_end() override {
    while (integrator_.getTime() < case_.duration) integrator_.stepTo(case_.duration);
  }
  dynamics::RotationState state() const override {
    const SimTK::State& s = integrator_.getState();
    assembly_.system.realize(s, SimTK::Stage::Velocity);
    const SimTK::Rotation& R = assembly_.body.getBodyRotation(s);
    const SimTK::Vec3 w_B = ~R * assembly_.body.getBodyAngularVelocity(s);
    std::vector<double> rates, angles;
    for (const SimTK::MobilizedBody::Pin& cone : assembly_.cones) {
      rates.push_back(cone.getRate(s));
      angles.push_back(cone.getAngle(s));
    }
    Mat3 R_WB;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) R_WB(i, j) = R.asMat33()(i, j);
    return state_of(case_, R_WB, {w_B[0], w_B[1], w_B[2]}, rates, angles);
  }
  long steps() const override { return integrator_.getNumStepsTaken(); }
  long torque_evaluations() const override {
    return integrator_.getNumRealizations() - realizations_before_;
  }

 private:
  RotationCase case_;
  Assembly assembly_;
  Integrator integrator_;
  long realizations_before_ = 0;
};

template <class Integrator>
Method method(const char* name, Control control) {
  return {name, control,
          [control](const RotationCase& c, double setting) -> std::unique_ptr<Integration> {
            return std::make_unique<SimbodyIntegration<Integrator>>(c, control, setting);
          }};
}

}  // namespace

Contender simbody() {
  return {"Simbody",
          "",
          {method<SimTK::RungeKuttaMersonIntegrator>("RKMerson", Control::tolerance),
           method<SimTK::VerletIntegrator>("Verlet", Control::step)}};
}

}  // namespace tdbd::bench
