#pragma once

#include <vector>

#include "forces/part/part_cut.hpp"
#include "simulation/case/plans.hpp"
#include "simulation/step/measure.hpp"
#include "simulation/step/move.hpp"

namespace tdbd::simulation {

/// What one part did in a step, without its velocity over the rock: a law may be
/// evaluated on the same cut at several velocities.
struct CutOfPart {
  int part = 0;                   ///< index into Bit::parts
  int cone = -1;                  ///< index into Bit::cones, or -1
  forces::PartCut cut;            ///< in the frame W; velocity and what follows from it are not set
  double face_area = 0.0;         ///< m2, cut by a face, in its plane
  Vec3 forward_W = Vec3::Zero();  ///< unit, the face's normal; of a face only
  double distance = 0.0;          ///< m, rock::PartContact::distance under a law that presses
};

/// The law of the part that made the cut.
inline const forces::Law& law_of(const ForcePlan& plan, const CutOfPart& c) {
  return law_of(plan, c.cut.kind, c.part);
}

/// The cuts of all parts with a law that touched rock in the step, in the order of the parts.
/// - face: the section ahead of it (ForcePlan::cut = section): area, centroid, edge; or its removed
///   volume over dt and the speed of its tip along X (volume; reconstructed). Normal: the
///   profile's at the cutter.
/// - chamfer: engaged edge times the chamfer's width, seen along the profile's normal (edge), or
///   the rock triangles in contact (triangles).
/// - all others: the rock triangles in contact, their centroid, and the direction of their summed
///   area; contact_area is the length of that sum, so that pressure on a closed patch cancels. Under a
///   law that presses (forces (4)), the sides that press are a cut of their own, and so is the surface
///   of a milled tooth in each direction of its frame.
/// - wear flat of a cutter (ForcePlan::flat = edge): the flat behind the engaged edge, a cut of its own
///   of the cutter's body. Normal: the profile's.
void gather_cuts(const ForcePlan& plan, const MeasuredStep& step, const Measures& measures,
                 std::vector<CutOfPart>& cuts);

/// The cuts of parts that press without a ramp (forces (4)) and touch the rock, of a bit that has not
/// moved yet. With a ramp they carry only what their motion makes them carry.
void gather_touching(const ForcePlan& plan, const bit::Bit& bit,
                     const std::vector<rock::PartContact>& contacts, std::vector<CutOfPart>& cuts);

/// Width of a chamfer as the rock sees it along the profile's normal when the face stands at this
/// back rake (rad): depth cos + width sin, m; land included.
double chamfer_width(const bit::Cutter& cutter, double back_rake);

/// The cut at this motion of the bit: with the velocity of its point, its path in dt (s), the area
/// normal to the velocity, thickness and effective back rake, simulation (3).
forces::PartCut cut_at(const bit::Bit& bit, const Pose& X_WB, const BitVelocity& motion, double dt,
                       const CutOfPart& cut);

/// The same where the velocity of the cut's point (m/s) is known. A surface that has risen from the
/// rock first comes back to it: its velocity into the rock is less by distance/dt.
forces::PartCut cut_at_velocity(const Vec3& v_W, double dt, const CutOfPart& cut);

}  // namespace tdbd::simulation
