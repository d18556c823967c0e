#pragma once

#include <span>

#include "rock/cut/cutting_bit.hpp"

namespace tdbd::rock {

/// One part of the bit for the measurement of contact: its solids at the end of a step, and their
/// motion in the step. All points in the frame P of the part's group at the end of the step.
struct PressingPart {
  std::span<const CuttingPart> solids;    ///< one, or the convex pieces of the part
  Pose X_P1P0;                            ///< pose at the step's beginning relative to its end
  double gap = 0.0;                       ///< m, largest distance that counts as touching
  double ramp = 0.0;                      ///< ContactOfPart::ramp
  Vec3 excluded_normal_P = Vec3::Zero();  ///< ContactOfPart::excluded_normal_P
};

/// The planes of a part that is one convex solid; null for other parts.
inline const mesh::ConvexSolid* convex(const PressingPart& part) {
  return part.solids.size() == 1 && !part.solids[0].tree_P ? &part.solids[0].solid_P : nullptr;
}

/// Shorter displacements, m, are rounding errors: the part does not move.
inline double rest_tolerance(const PressingPart& part) { return 1e-7 * part.gap; }

/// The displacement of the part's material at x_P in the step, m.
inline Vec3 displacement_P(const PressingPart& part, const Vec3& x_P) {
  return x_P - part.X_P1P0 * x_P;
}

/// Whether a surface with outward normal n_P and displacement move_P presses or slides: n . v >= 0,
/// to within 1e-4 of |v|. Otherwise the surface moved away from the rock.
bool presses_or_slides(const PressingPart& part, const Vec3& move_P, const Vec3& n_P);

/// Whether it presses, by more than that tolerance.
bool presses(const PressingPart& part, const Vec3& move_P, const Vec3& n_P);

/// Whether the surface of the part nearest to x_P moved away from the rock. Where two surfaces are
/// equally near, as on a ridge, both must have moved away. Rock (14).
bool is_on_lee_side(const PressingPart& part, const Vec3& x_P);

/// The same for a sequence of points: starts with the solid that was nearest to the previous one.
bool is_on_lee_side(const PressingPart& part, const Vec3& x_P, std::size_t& nearest_solid);

/// A vertex that the part holds: whether it is on the part's lee side, the point of the part's
/// surface below it, and its distance outside that surface.
struct Touch {
  bool is_lee = false;
  Vec3 x_P;           ///< m
  double rise = 0.0;  ///< m; 0 for a vertex inside
};

/// For a part that is one convex solid, the point is on its nearest plane, within the gap. For
/// other parts it is x_P itself.
Touch touch(const PressingPart& part, const Vec3& x_P);

/// Whether the undisturbed place U_P is inside a part that is one convex solid of planes.
bool is_inside(const PressingPart& part, const Vec3& U_P);

/// Outward normal of the part's surface nearest to x_P. Of several equally near surfaces, the one
/// that moves most into the rock is used.
Vec3 nearest_normal(const PressingPart& part, const Vec3& x_P);

/// The share of the full stress (ContactPatch) at x_P, where the part's outward normal is n_P. 1 if
/// the part does not move.
double stress_share(const PressingPart& part, const Vec3& x_P, const Vec3& n_P);

}  // namespace tdbd::rock
