// MuJoCo: a ball joint at the fixed point, gravity on an offset centre of mass, cones on hinges.
// Contacts, constraints and limits, which this motion does not need, are disabled.

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <cmath>
#include <cstring>

#include "benchmarks/rotation/method.hpp"
#include "core/error.hpp"

namespace tdbd::bench {
namespace {

constexpr double mass = 1.0, arm = 0.1;  // kg, m: only their product with gravity matters

std::string text(const Vec3& v) { return fmt::format("{:.17g} {:.17g} {:.17g}", v[0], v[1], v[2]); }

std::string inertial(const Vec3& centre_B, const Mat3& I) {
  return fmt::format("<inertial pos='{}' mass='{}' fullinertia='{} {}'/>", text(centre_B), mass,
                     text(I.diagonal()), text({I(0, 1), I(0, 2), I(1, 2)}));
}

/// About the centre of mass, as MuJoCo requires.
Mat3 central_inertia(const Mat3& about_origin, const Vec3& p) {
  return about_origin - mass * (p.squaredNorm() * Mat3::Identity() - p * p.transpose());
}

std::string body_text(const RotationCase& c) {
  const Vec3 centre_B =
      c.loads.gravity_moment == 0.0 ? Vec3::Zero().eval() : (arm * c.loads.gravity_arm_B).eval();
  std::string xml = "<body><joint type='ball'/>" +
                    inertial(centre_B, central_inertia(inertia_without_cones(c.body), centre_B));
  for (const dynamics::Cone& cone : c.body.cones)
    xml += fmt::format("<body><joint type='hinge' axis='{}'/>{}</body>", text(cone.axis_B),
                       inertial(Vec3::Zero(), cone_inertia(cone)));
  return xml + "</body>";
}

std::string model_text(const RotationCase& c, const char* integrator, double h) {
  const double g = c.loads.gravity_moment / (mass * arm);
  return fmt::format(
      "<mujoco><compiler angle='radian'/>"
      "<option integrator='{}' timestep='{:.17g}' gravity='0 0 {:.17g}'>"
      "<flag contact='disable' constraint='disable' equality='disable' limit='disable'/>"
      "</option><worldbody>{}</worldbody></mujoco>",
      integrator, h, -g, body_text(c));
}

mjModel* load(const std::string& xml) {
  constexpr const char* name = "gyrostat.xml";
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), name, static_cast<int>(xml.size()));
  std::memcpy(files->filedata[mj_findFileVFS(files.get(), name)], xml.data(), xml.size());
  char why[500] = "";
  mjModel* model = mj_loadXML(name, files.get(), why, sizeof why);
  mj_deleteVFS(files.get());
  if (model == nullptr) throw RunError(fmt::format("MuJoCo refuses the model: {}", why));
  return model;
}

class MujocoIntegration final : public Integration {
 public:
  MujocoIntegration(const RotationCase& c, const char* integrator, int evaluations_a_step, double h)
      : case_(c),
        evaluations_a_step_(evaluations_a_step),
        model_(load(model_text(c, integrator, h))),
        data_(mj_makeData(model_.get())) {
    const dynamics::RotationState s = start_of(case_);
    const Eigen::Quaterniond& q = s.q_WB;
    for (int i = 0; const double value : {q.w(), q.x(), q.y(), q.z()}) data_->qpos[i++] = value;
    for (int i = 0; i < 3; ++i) data_->qvel[i] = c.w_B[i];
    for (std::size_t k = 0; k < c.spins.size(); ++k) data_->qvel[3 + k] = c.spins[k];
  }

  void take(long steps) override {
    for (long i = 0; i < steps; ++i) mj_step(model_.get(), data_.get());
    steps_ += steps;
  }
  void run_to_end() override { take(std::lround(case_.duration / model_->opt.timestep)); }
  dynamics::RotationState state() const override {
    const auto n = static_cast<std::ptrdiff_t>(case_.spins.size());
    const double *q = data_->qpos, *v = data_->qvel;
    return state_of(case_, Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix(),
                    {v[0], v[1], v[2]}, {v + 3, v + 3 + n}, {q + 4, q + 4 + n});
  }
  long steps() const override { return steps_; }
  long torque_evaluations() const override { return evaluations_a_step_ * steps_; }

 private:
  struct Free {
    void operator()(mjModel* m) const { mj_deleteModel(m); }
    void operator()(mjData* d) const { mj_deleteData(d); }
  };
  RotationCase case_;
  int evaluations_a_step_;
  long steps_ = 0;
  std::unique_ptr<mjModel, Free> model_;
  std::unique_ptr<mjData, Free> data_;
};

Method method(const char* name, const char* integrator, int evaluations_a_step) {
  return {name, Control::step,
          [=](const RotationCase& c, double h) -> std::unique_ptr<Integration> {
            return std::make_unique<MujocoIntegration>(c, integrator, evaluations_a_step, h);
          }};
}

}  // namespace

Contender mujoco() {
  return {"MuJoCo", "", {method("RK4", "RK4", 4), method("implicit", "implicit", 1)}};
}

}  // namespace tdbd::bench
