#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "simulation/rotate/rotate_case.hpp"

namespace tdbd::simulation {

/// A case of the repository and settings: every kind of state that a restart must keep.
struct RotatedCase {
  std::string name, file;
  std::vector<std::string> settings;
};

inline void PrintTo(const RotatedCase& c, std::ostream* out) { *out << c.name; }

inline std::vector<RotatedCase> rotated_cases() {
  return {{"free", "free-rotation", {}},
          {"top", "slow-top", {}},
          {"cones", "heavy-gyrostat", {}},
          {"torques", "applied-torque", {}},
          {"springs_and_dampers",
           "heavy-gyrostat",
           {"load.stiffness=[1, 2, 3]", "load.damping=[0.1, 0.2, 0.3]"}},
          {"composed_with_dampers",
           "heavy-gyrostat",
           {"load.damping=[0.1, 0.2, 0.3]", "integrator.order=6"}},
          {"composed", "slow-top", {"integrator.order=8", "integrator.drift=three-axis"}},
          {"lie_midpoint", "heavy-gyrostat", {"integrator.drift=lie-midpoint"}},
          {"lie_mean",
           "slow-top",
           {"integrator.drift=lie-mean", "integrator.order=4", "integrator.drifts_per_step=3"}}};
}

/// With more settings.
inline RotateCase rotated_case(const RotatedCase& c, std::vector<std::string> more = {}) {
  more.insert(more.begin(), c.settings.begin(), c.settings.end());
  return read_rotate_case(TDBD_SOURCE_DIR "/cases/" + c.file + ".toml", more);
}

}  // namespace tdbd::simulation
