#pragma once

#include "verification/dynamics/drilling/drilling_run.hpp"

/// A problem in which everything acts at once and is smooth.
namespace tdbd::dynamics {

/// Symmetric, positive, coupled in all directions.
inline Mat3 coupled(const Vec3& diagonal, double coupling) {
  Mat3 A = diagonal.asDiagonal();
  const Vec3 d = diagonal.cwiseSqrt();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (i != j) A(i, j) = coupling * d[i] * d[j];
  return A;
}

/// Two unequal cones, centre of mass off the axis, string held off the centre, coupled springs and
/// dampers, bearings, moving rock, a ring that stays on the wall, and a top that speeds up.
inline DrillingSystem coupled_bit(AxialMode axial, DamperEnd end) {
  DrillingSystem s;
  s.mass = 120.0;
  s.centre_B = Vec3(0.004, -0.002, -0.1);
  s.gyrostat = make_gyrostat(Vec3(2.0, 2.6, 3.0).asDiagonal(),
                             {{Vec3(0.8, 0, 0.6), 0.1}, {Vec3(-0.6, 0.5, 0.6), 0.2}});
  s.bearing_damping = {0.3, 0.2};
  s.string = {Vec3(0.0, 0.0, -0.3),
              Vec3(0.001, 0.0, -0.3),
              coupled(Vec3(4e4, 6e4, 9e4), 0.2),
              coupled(Vec3(300.0, 200.0, 900.0), 0.3),
              coupled(Vec3(2e3, 3e3, 500.0), 0.1),
              coupled(Vec3(6.0, 4.0, 9.0), 0.2),
              end};
  s.top = {make_schedule(Interpolation::linear, {0.0, 2.0}, {6.0, 12.0}), axial,
           make_schedule(Interpolation::linear, {0.0, 2.0}, {0.002, 0.02}),
           make_schedule(Interpolation::linear, {0.0, 2.0}, {500.0, 3000.0})};
  s.wall = {2e5, 0.0, 0.1, -0.02, 1.0, 0.2, 0.5};
  s.rock = {60.0, 3e4, 150.0};
  s.gravity = 9.81;
  return make_drilling_system(std::move(s));
}

inline DrillingState coupled_start(const DrillingSystem& s) {
  DrillingState x;
  const std::vector<double> spins{-9.0, 6.0}, angles{0.1, 0.2};
  const Mat3 R = Eigen::AngleAxisd(0.05, Vec3(0.6, 0.8, 0.0)).toRotationMatrix();
  x.rotation = make_state(s.gyrostat, R, Vec3(0.2, -0.1, 7.0), spins, angles);
  x.c_W = Vec3(0.012, 0.0, -0.1);
  x.momentum_W = Vec3(2.0, 25.0, 0.5);
  x.rock_z = 0.001;
  x.rock_momentum = 0.2;
  return x;
}

/// Resists along all three directions by position and velocity, turns bit and cones against their
/// motion; smooth, not linear. Depth counts from where the rock has moved.
inline void smooth_law(const DrillingSystem&, const DrillingState& s, const DrillingVelocity& v,
                       Wrench& w) {
  const double depth = s.c_W.z() - s.rock_z + 0.2, slip = std::tanh(v.w_W.z() / 5.0);
  w.force_W = Vec3(-60.0 * v.v_W.x(), -80.0 * v.v_W.y() * std::abs(v.v_W.y()),
                   -4e3 * depth - 200.0 * (v.v_W.z() - v.rock));
  w.torque_W = Vec3(-2.0 * v.w_W.x(), -2.0 * v.w_W.y(), -40.0 * depth * slip * (1.0 + depth));
  for (std::size_t k = 0; k < w.cones.size(); ++k)
    w.cones[k] = -0.4 * std::tanh((v.cone_rates[k] + v.w_W.z()) / 4.0);
  w.rock_force = -w.force_W.z();
}

}  // namespace tdbd::dynamics
