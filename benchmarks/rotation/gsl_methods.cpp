// GSL's rk8pd. The equations are written as for a direct use of GSL: state (quaternion, body
// momentum, cone angles), constant cone momenta, no allocations.

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <cmath>
#include <limits>

#include "benchmarks/rotation/method.hpp"
#include "core/error.hpp"
#include "dynamics/momenta.hpp"

namespace tdbd::bench {
namespace {

constexpr std::size_t first_angle = 7;  // after quaternion (w, x, y, z) and momentum

struct Equations {
  const RotationCase* c = nullptr;
  Vec3 sigma_B = Vec3::Zero();
  std::vector<double> cone_momenta;
  long evaluations = 0;
};

Vec3 gravity_torque_B(const dynamics::Loads& loads, const Eigen::Quaterniond& q_WB) {
  if (loads.gravity_moment == 0.0) return Vec3::Zero();
  const double w = q_WB.w(), x = q_WB.x(), y = q_WB.y(), z = q_WB.z();
  const Vec3 up_B = {2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)};
  return -loads.gravity_moment * loads.gravity_arm_B.cross(up_B);
}

/// q' = q (0, W) / 2, Pi' = Pi x W + T, phi' = pi_k / Ic_k - s_k . W: dynamics (3).
int derivative(double, const double y[], double dy[], void* parameters) {
  Equations& e = *static_cast<Equations*>(parameters);
  const dynamics::Gyrostat& g = e.c->body;
  const Eigen::Quaterniond q_WB(y[0], y[1], y[2], y[3]);
  const Vec3 momentum_B(y[4], y[5], y[6]);
  const Vec3 w_B = g.carrier_inverse_B * (momentum_B - e.sigma_B);
  const Vec3 dq = 0.5 * (q_WB.w() * w_B + q_WB.vec().cross(w_B));
  dy[0] = -0.5 * q_WB.vec().dot(w_B);
  Eigen::Map<Vec3>(dy + 1) = dq;
  Eigen::Map<Vec3>(dy + 4) = momentum_B.cross(w_B) + gravity_torque_B(e.c->loads, q_WB);
  for (std::size_t k = 0; k < g.cones.size(); ++k)
    dy[first_angle + k] = e.cone_momenta[k] / g.cones[k].axial_inertia - g.cones[k].axis_B.dot(w_B);
  ++e.evaluations;
  return GSL_SUCCESS;
}

struct FreeDriver {
  void operator()(gsl_odeiv2_evolve* p) const { gsl_odeiv2_evolve_free(p); }
  void operator()(gsl_odeiv2_control* p) const { gsl_odeiv2_control_free(p); }
  void operator()(gsl_odeiv2_step* p) const { gsl_odeiv2_step_free(p); }
};

class Rk8pd final : public Integration {
 public:
  Rk8pd(const RotationCase& c, double tolerance)
      : case_(c), system_{derivative, nullptr, first_angle + c.spins.size(), &equations_} {
    const dynamics::RotationState s = start_of(case_);
    equations_.c = &case_;
    equations_.sigma_B = dynamics::cone_momentum_sum(case_.body, s);
    equations_.cone_momenta = s.cone_momenta;
    const Vec3 momentum_B = dynamics::body_momentum(s);
    y_ = {s.q_WB.w(), s.q_WB.x(), s.q_WB.y(), s.q_WB.z()};
    y_.insert(y_.end(), momentum_B.begin(), momentum_B.end());
    y_.insert(y_.end(), s.cone_angles.begin(), s.cone_angles.end());
    step_.reset(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, y_.size()));
    control_.reset(gsl_odeiv2_control_y_new(tolerance, tolerance));
    evolve_.reset(gsl_odeiv2_evolve_alloc(y_.size()));
  }

  void take(long steps) override {
    for (long i = 0; i < steps; ++i) step_towards(std::numeric_limits<double>::max());
  }
  void run_to_end() override {
    while (time_ < case_.duration) step_towards(case_.duration);
  }
  dynamics::RotationState state() const override {
    dynamics::RotationState s = start_of(case_);
    s.q_WB = Eigen::Quaterniond(y_[0], y_[1], y_[2], y_[3]);
    s.q_WB.normalize();
    s.momentum_W = s.q_WB * Vec3(y_[4], y_[5], y_[6]);
    s.cone_angles.assign(y_.begin() + first_angle, y_.end());
    s.time = time_;
    return s;
  }
  long steps() const override { return static_cast<long>(evolve_->count); }
  long torque_evaluations() const override { return equations_.evaluations; }

 private:
  void step_towards(double end) {
    if (gsl_odeiv2_evolve_apply(evolve_.get(), control_.get(), step_.get(), &system_, &time_, end,
                                &next_step_, y_.data()) != GSL_SUCCESS)
      throw RunError("rk8pd: GSL refuses a step of the case " + case_.name);
  }

  RotationCase case_;
  Equations equations_;
  gsl_odeiv2_system system_;
  std::vector<double> y_;
  double time_ = 0.0, next_step_ = 0.01;
  std::unique_ptr<gsl_odeiv2_step, FreeDriver> step_;
  std::unique_ptr<gsl_odeiv2_control, FreeDriver> control_;
  std::unique_ptr<gsl_odeiv2_evolve, FreeDriver> evolve_;
};

}  // namespace

Contender gsl() {
  const auto start = [](const RotationCase& c, double tolerance) -> std::unique_ptr<Integration> {
    return std::make_unique<Rk8pd>(c, tolerance);
  };
  return {"GSL", "", {{"rk8pd", Control::tolerance, start}}};
}

}  // namespace tdbd::bench
