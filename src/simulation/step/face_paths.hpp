#pragma once

#include <span>
#include <vector>

#include "bit/bit.hpp"
#include "rotation/screw.hpp"
#include "simulation/case/plans.hpp"
#include "simulation/step/move.hpp"

namespace tdbd::simulation {

/// Path along which the section ahead of a face is taken. The direction in which a bit at rest
/// creeps is noise: faces would alternate between thousands of mm2 and nothing ahead of them. A
/// creeping face is therefore measured along its last path, which is initially a rotation about the
/// axis of the bit, and keeps its last section if there is no rock surface ahead. An addition of
/// TDBD [+].
struct FacePath {
  rotation::Twist way{Vec3::UnitZ(), Vec3::Zero()};  ///< in B, with the speed of the face
  bool creeps = false;

  template <class Archive>
  void serialize(Archive& a) {
    a(way, creeps);
  }
};

/// One entry per cutter. If empty, all faces use the path of the step.
using FacePaths = std::vector<FacePath>;

/// Slip speed of the law of each cutter's face, m/s; 0 if there is none.
std::vector<double> creep_of_faces(const bit::Bit& bit, const ForcePlan& plan);

/// Stores the path of the step for all faces that do not creep, that is, that move forward faster
/// than `creep` (m/s, per cutter), or ten times as fast in any direction.
void follow(const bit::Bit& bit, const Move& move, std::span<const double> creep, FacePaths& paths);

inline bool creeps(const FacePaths& paths, int cutter) {
  return !paths.empty() && paths[at(cutter)].creeps;
}

/// The path along which a face is measured, with the speed of the step.
rotation::Twist path_of(const FacePaths& paths, const bit::Bit& bit, int cutter,
                        const rotation::Twist& of_step);

}  // namespace tdbd::simulation
