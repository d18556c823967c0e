#pragma once

/// Every tolerance of the program, each with its scale. None is loosened to make a test pass.
namespace tdbd::tolerance {

/// No rock vertex deeper than this inside a cutting part after a step; scale: bit diameter.
inline constexpr double inside = 1e-9;

/// A vertex counts as swept only if it lies deeper than this inside the part; scale: part size.
/// Far above the rounding of a coordinate (1e-16) and far below `inside`, so that a vertex that was
/// moved onto a part's surface is not swept again.
inline constexpr double swept = 1e-12;

/// A part is convex if no vertex lies farther than this outside the plane of a facet; scale: part size.
/// Single-precision STL files round coordinates by 6e-8.
inline constexpr double convex = 5e-7;

/// A vertex of a mesh lies in the plane of a cutter's face if it is no farther from it than this; scale: the cutter's
/// diameter. Far above the rounding of single-precision files, far below a chamfer.
inline constexpr double face_plane = 1e-5;

/// The volume ledger closes to within this; scale: the largest volume in it (rock (11)).
inline constexpr double ledger = 1e-12;

/// Symmetry of an inertia, and the triangle inequality of its principal values (equality is a flat
/// body); scale: the largest of them.
inline constexpr double inertia = 1e-9;

/// An attitude given as a matrix is a rotation when no entry of R^T R - 1 is larger; scale: 1.
inline constexpr double rotation = 1e-9;

/// Principal inertias closer than this are equal: subtracting the cones from a symmetric bit leaves such rounding;
/// scale: the largest of them.
inline constexpr double equal_inertia = 1e-14;

}  // namespace tdbd::tolerance
