#pragma once

/// All tolerances of the program. Each states what it is relative to ("scale"). None is loosened to
/// make a test pass.
namespace tdbd::tolerance {

/// Largest depth of a rock vertex inside a cutting part after a step; scale: bit diameter.
inline constexpr double inside = 1e-9;

/// A vertex counts as swept only if it is deeper than this inside the part; scale: part size. Far
/// above the rounding of a coordinate (1e-16) and far below `inside`, so that a vertex moved onto
/// the surface of a part is not swept again.
inline constexpr double swept = 1e-12;

/// A part is convex if no vertex is farther than this outside the plane of a facet; scale: part
/// size. Single-precision STL files round coordinates by 6e-8.
inline constexpr double convex = 5e-7;

/// A vertex of a mesh lies in the plane of a cutter's face if its distance is at most this; scale:
/// diameter of the cutter. Far above the rounding of single-precision files, far below a chamfer.
inline constexpr double face_plane = 1e-5;

/// Largest residual of the volume ledger; scale: the largest volume in it (rock (11)).
inline constexpr double ledger = 1e-12;

/// For the symmetry of an inertia tensor and the triangle inequality of its principal values
/// (equality is a flat body); scale: the largest principal value.
inline constexpr double inertia = 1e-9;

/// An attitude given as a matrix is a rotation if no entry of R^T R - 1 is larger; scale: 1.
inline constexpr double rotation = 1e-9;

/// Principal inertias that differ by less than this are equal, because subtracting the cones from a
/// symmetric bit leaves rounding of this size; scale: the largest of them.
inline constexpr double equal_inertia = 1e-14;

}  // namespace tdbd::tolerance
