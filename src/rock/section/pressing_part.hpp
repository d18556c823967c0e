#pragma once

#include <span>

#include "rock/cut/cutting_bit.hpp"

namespace tdbd::rock {

/// One part of the bit as its contact with rock sees it: its solids at the end of a step, and how
/// they moved in the step. All points in the frame P of the part's group at the step's end.
struct PressingPart {
  std::span<const CuttingPart> solids;  ///< one, or the convex pieces of the part
  Pose X_P1P0;                          ///< where the step began, seen from where it ended
  double gap = 0.0;                     ///< m, how near counts as touching
  double ramp = 0.0;                    ///< ContactOfPart::ramp
  Vec3 left_out_P = Vec3::Zero();       ///< ContactOfPart::left_out_P
};

/// The planes of a part of one convex solid; null for other parts.
inline const mesh::ConvexSolid* convex(const PressingPart& part) {
  return part.solids.size() == 1 && !part.solids[0].tree_P ? &part.solids[0].solid_P : nullptr;
}

/// Shorter displacements are only rounding: the part stands, m.
inline double standing(const PressingPart& part) { return 1e-7 * part.gap; }

/// The displacement in the step of the part's material at x_P, m.
inline Vec3 displacement_P(const PressingPart& part, const Vec3& x_P) {
  return x_P - part.X_P1P0 * x_P;
}

/// Whether a surface with outward normal n_P that moves by move_P presses or slides: n . v >= 0, to
/// within 1e-4 of |v|. It does not: the surface moved away from the rock.
bool presses_or_slides(const PressingPart& part, const Vec3& move_P, const Vec3& n_P);

/// Whether it presses, by more than that.
bool presses(const PressingPart& part, const Vec3& move_P, const Vec3& n_P);

/// Whether the surface of the part nearest to x_P moved away from the rock. Where two surfaces are
/// equally near, as on a ridge, one that did not decides. Rock (14).
bool is_on_lee_side(const PressingPart& part, const Vec3& x_P);

/// The same for points one after another: begins with the solid that was nearest to the last one.
bool is_on_lee_side(const PressingPart& part, const Vec3& x_P, std::size_t& nearest_solid);

/// A vertex that the part holds: whether on its lee side, the point of the part's surface below it, and
/// how far it is outside of that.
struct Touch {
  bool is_lee = false;
  Vec3 x_P;           ///< m
  double rise = 0.0;  ///< m, 0 for a vertex inside
};

/// The point is on the nearest plane of a part of one convex solid, within the gap; of other parts it
/// is x_P itself.
Touch touch(const PressingPart& part, const Vec3& x_P);

/// Whether undisturbed rock was at U_P inside a part of one convex solid of planes.
bool is_inside(const PressingPart& part, const Vec3& U_P);

/// Outward normal of the part's surface nearest to x_P; of several that are equally near the one that
/// moves most into the rock.
Vec3 nearest_normal(const PressingPart& part, const Vec3& x_P);

/// The share of the full stress at x_P, where the part's outward normal is n_P: ContactPatch. A part
/// that stands has all of it.
double stress_share(const PressingPart& part, const Vec3& x_P, const Vec3& n_P);

}  // namespace tdbd::rock
