#pragma once

#include <vector>

#include "forces/part/part_cut.hpp"
#include "simulation/case/force_settings.hpp"
#include "simulation/step/measure.hpp"

namespace tdbd::simulation {

/// Cut of one part in a step, without its velocity relative to the rock, so that a law can be
/// evaluated for the same cut at several velocities.
struct CutOfPart {
  int part = 0;                   ///< index into Bit::parts
  int cone = -1;                  ///< index into Bit::cones, or -1
  forces::PartCut cut;            ///< in W; velocity and derived quantities are not set
  double face_area = 0.0;         ///< m2, area cut by a face, in its plane
  Vec3 forward_W = Vec3::Zero();  ///< unit normal of the face; only for faces
  double distance = 0.0;          ///< m, rock::PartContact::distance if the law presses
};

/// The law of the part that made the cut.
inline const forces::Law& law_of(const ForcePlan& plan, const CutOfPart& c) {
  return law_of(plan, c.cut.kind, c.part);
}

/// Collects the cuts of all parts that have a law and touched rock in the step, in the order of the
/// parts.
/// - Face: area, centroid and edge from the section ahead of it (ForcePlan::cut = section), or its
///   removed volume divided by dt and the speed of its tip along X (volume; reconstructed). The
///   normal is that of the profile at the cutter.
/// - Chamfer: engaged edge times the width of the chamfer as seen along the normal of the profile
///   (edge), or the rock triangles in contact (triangles).
/// - All others: the rock triangles in contact, their centroid, and the direction of their summed
///   area vectors. contact_area is the length of that sum, so the pressure on a closed patch
///   cancels. If the law presses (forces (4)), the pressing sides are a separate cut, and so is the
///   surface of a milled tooth in each direction of its frame.
/// - Wear flat of a cutter (ForcePlan::flat = edge): the flat behind the engaged edge, a separate
///   cut of the cutter's body. The normal is that of the profile.
void gather_cuts(const ForcePlan& plan, const MeasuredStep& step, const Measures& measures,
                 std::vector<CutOfPart>& cuts);

/// Collects the cuts of parts that press without a ramp (forces (4)) and touch the rock, for a bit
/// that has not moved yet. With a ramp, a part at rest has no force.
void gather_touching(const ForcePlan& plan, const bit::Bit& bit,
                     const std::vector<rock::PartContact>& contacts, std::vector<CutOfPart>& cuts);

/// Width of a chamfer including the land, m, as seen by the rock along the normal of the profile if
/// the face has this back rake (rad): depth cos + width sin.
double chamfer_width(const bit::Cutter& cutter, double back_rake);

/// Completes the cut for this motion of the bit: velocity of its point, its path in dt (s), area
/// normal to the velocity, thickness and effective back rake, simulation (3).
forces::PartCut cut_at(const bit::Bit& bit, const Pose& X_WB, const BitVelocity& motion, double dt,
                       const CutOfPart& cut);

/// The same for a known velocity of the cut's point (m/s). A surface that has risen from the rock
/// must first return to it, which reduces its velocity into the rock by distance/dt.
forces::PartCut cut_at_velocity(const Vec3& v_W, double dt, const CutOfPart& cut);

}  // namespace tdbd::simulation
