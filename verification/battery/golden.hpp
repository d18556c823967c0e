#pragma once

#include <string>
#include <vector>

#include "dynamics/gyrostat.hpp"
#include "dynamics/loads.hpp"

/// Reads verification/data/golden: reference solutions and steps of the schemes (its README
/// explains how they were made).
namespace tdbd::battery {

/// A golden state as written in its file, not made consistent by any function of TDBD. Frames: W
/// space, B bit.
struct GoldenState {
  double time = 0.0;                    ///< s
  Mat3 R_WB = Mat3::Identity();         ///< takes B to W
  Vec3 body_momentum_B = Vec3::Zero();  ///< Pi, N m s
  Vec3 w_B = Vec3::Zero();              ///< W, rad/s
  Vec3 momentum_W = Vec3::Zero();       ///< N m s
  std::vector<double> cone_angles;      ///< phi_k, rad, unwrapped
  std::vector<double> cone_momenta;     ///< pi_k, N m s
  double energy = 0.0;                  ///< J
};

struct GoldenCase {
  std::string name;
  dynamics::Gyrostat gyrostat;  ///< made with InertiaCheck::off
  dynamics::Loads loads;        ///< one ConeLoad for each cone
  dynamics::RotationState initial;
  std::vector<GoldenState> states;  ///< at t = 0, 1, 2, 5, 10 s
};

/// One step has drifts_per_step drifts of h / drifts_per_step between two kicks of h / 2. The
/// states after the steps have R, Pi, phi and pi only; time is set.
struct GoldenStep {
  std::string drift;  ///< "LieMid", "CayVar", "ExpVar", "Split3" or "SplitSph"
  int drifts_per_step = 1;
  double h = 0.0;  ///< s
  GoldenState after_1, after_100;
};

/// Names of the golden cases: "slow_top" and eight more.
std::vector<std::string> golden_names();

/// Throws InputError when there is no such case, nlohmann::json's exceptions when a key is missing.
GoldenCase read_golden_case(const std::string& name);
std::vector<GoldenStep> read_golden_steps(const std::string& name);

}  // namespace tdbd::battery
