#pragma once

#include <span>
#include <vector>

#include "bit/bit.hpp"
#include "rotation/screw.hpp"
#include "simulation/case/plans.hpp"
#include "simulation/step/move.hpp"

namespace tdbd::simulation {

/// A section is taken ahead of a face, along its path. The direction in which a standing bit creeps
/// is that of what dithers around it: faces would find thousands of mm2 ahead and none by turns. So
/// a face that creeps is measured along the way that it last went, at first around the bit's axis,
/// and keeps its last section where it finds no rock's surface ahead (ours).
struct FacePath {
  rotation::Twist way{Vec3::UnitZ(), Vec3::Zero()};  ///< B, as fast as the face went
  bool creeps = false;
};

/// Per cutter; none: every face goes along the step's own path.
using FacePaths = std::vector<FacePath>;

/// Per cutter, the slip speed of its face's law, m/s; 0 where there is none.
std::vector<double> creep_of_faces(const bit::Bit& bit, const ForcePlan& plan);

/// Takes over the step's path for the faces that do not creep: those that go forward faster than
/// `creep` (m/s, per cutter), or ten times as fast in any direction.
void follow(const bit::Bit& bit, const Move& move, std::span<const double> creep, FacePaths& paths);

inline bool creeps(const FacePaths& paths, int cutter) {
  return !paths.empty() && paths[at(cutter)].creeps;
}

/// The path along which one face is measured, at the speed of the step's own.
rotation::Twist path_of(const FacePaths& paths, const bit::Bit& bit, int cutter,
                        const rotation::Twist& of_step);

}  // namespace tdbd::simulation
