#include "benchmarks/rotation/cases.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dynamics/momenta.hpp"
#include "dynamics/rotation/step.hpp"
#include "rotation/screw.hpp"

namespace tdbd::bench {
namespace {

/// Three axes 120 degrees apart, 55 degrees from the axis of the bit.
std::vector<dynamics::Cone> three_cones(const Vec3& axial_inertias) {
  std::vector<dynamics::Cone> cones;
  for (int k = 0; k < 3; ++k) {
    const double tilt = 55.0 * std::numbers::pi / 180.0, azimuth = k * 2.0 * std::numbers::pi / 3.0;
    const Vec3 axis_B(std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth),
                      std::cos(tilt));
    cones.push_back({axis_B, axial_inertias[k]});
  }
  return cones;
}

dynamics::Loads gravity(double moment, const Vec3& arm_B, std::size_t cones) {
  dynamics::Loads loads;
  loads.gravity_moment = moment;
  loads.gravity_arm_B = arm_B;
  loads.cones.resize(cones);
  return loads;
}

Mat3 rows(const Vec3& a, const Vec3& b, const Vec3& c) {
  Mat3 R;
  R << a.transpose(), b.transpose(), c.transpose();
  return R;
}

}  // namespace

RotationCase slow_top() {
  const Mat3 I = Vec3(5.0, 5.0, 1.0).asDiagonal();
  const Mat3 R_end = rows({-0.6587840818154614, 0.7523315131310697, 0.0009098881659122142},
                          {-0.7508146901299212, -0.6575316783085638, 0.06268487142711399},
                          {0.04775808446399258, 0.04061263806548928, 0.9980329548655654});
  return {.name = "slow_top",
          .body = dynamics::make_gyrostat(I, {}),
          .loads = gravity(20.0, Vec3::UnitZ(), 0),
          .rotation_vector = {0.05, 0.0, 0.0},
          .w_B = {0.0, 0.0, 5.0},
          .spins = {},
          .R_WB_end = R_end,
          .angles_end = {}};
}

RotationCase free_gyrostat() {
  const Mat3 I = Vec3(2.0, 2.0, 3.0).asDiagonal();
  const Mat3 R_end = rows({-0.3351803775033028, -0.8735828120747882, 0.35285575662620106},
                          {0.9386336851085759, -0.27727889040408893, 0.20514195601039778},
                          {-0.08136903413607752, 0.399961857411157, 0.9129126973046104});
  return {.name = "free_gyrostat",
          .body = dynamics::make_gyrostat(I, three_cones({0.1, 0.1, 0.1})),
          .loads = gravity(0.0, Vec3::UnitZ(), 3),
          .rotation_vector = Vec3::Zero(),
          .w_B = {0.3, -0.2, 2.0},
          .spins = {-7.0, -6.0, -9.0},
          .R_WB_end = R_end,
          .angles_end = {-69.72562880874301, -65.04756839637582, -83.04954086281037}};
}

RotationCase heavy_gyrostat() {
  const Mat3 I = Vec3(2.0, 2.6, 3.0).asDiagonal();
  const Mat3 R_end = rows({-0.8747648049769436, 0.3148365452622231, -0.36832660200017864},
                          {-0.016916321555845135, -0.7795247902014082, -0.626142906632719},
                          {-0.4842523867144788, -0.5414970463712602, 0.6872267273124149});
  return {.name = "heavy_gyrostat",
          .body = dynamics::make_gyrostat(I, three_cones({0.1, 0.2, 0.15})),
          .loads = gravity(5.0, {0.6, 0.0, 0.8}, 3),
          .rotation_vector = {0.4, 0.0, 0.0},
          .w_B = {0.5, -0.4, 2.0},
          .spins = {-6.0, 4.0, -9.0},
          .R_WB_end = R_end,
          .angles_end = {-54.66340762444029, 55.75984793637216, -89.09266895047912}};
}

dynamics::RotationState state_of(const RotationCase& c, const Mat3& R_WB, const Vec3& w_B,
                                 const std::vector<double>& spins,
                                 const std::vector<double>& angles) {
  return dynamics::make_state(c.body, R_WB, w_B, spins, angles);
}

dynamics::RotationState start_of(const RotationCase& c) {
  const std::vector<double> angles(c.spins.size(), 0.0);
  return state_of(c, rotation::exp(c.rotation_vector), c.w_B, c.spins, angles);
}

EndErrors errors_of(const RotationCase& c, const dynamics::RotationState& end) {
  const dynamics::RotationState begin = start_of(c);
  const Vec3 gained_W = end.momentum_W - begin.momentum_W;
  const double kinetic = dynamics::kinetic_energy(c.body, begin);
  const double potential_gained =
      dynamics::potential_energy(c.loads, end) - dynamics::potential_energy(c.loads, begin);
  EndErrors e;
  e.attitude = (end.q_WB.toRotationMatrix() - c.R_WB_end).norm() / std::numbers::sqrt2;
  for (std::size_t k = 0; k < c.angles_end.size(); ++k)
    e.cone_angles = std::max(e.cone_angles, std::abs(end.cone_angles[k] - c.angles_end[k]));
  const bool is_heavy = c.loads.gravity_moment != 0.0;
  e.momentum = (is_heavy ? std::abs(gained_W.z()) : gained_W.norm()) / begin.momentum_W.norm();
  e.energy = (dynamics::kinetic_energy(c.body, end) - kinetic + potential_gained) / kinetic;
  return e;
}

}  // namespace tdbd::bench
