#pragma once

namespace tdbd::tolerance {

/// Every tolerance of the program, each with its scale. None is loosened to make a test pass.

/// No rock vertex deeper than this inside a cutting part; scale: bit diameter.
inline constexpr double inside = 1e-9;

/// A vertex counts as swept only when it lies deeper than this inside the part; scale: part size.
/// Far above the rounding of a coordinate (1e-16) and far below `inside`, so that a vertex that was
/// set down on a part's surface is not picked up again.
inline constexpr double swept = 1e-12;

/// A part is convex when its hull's planes miss none of its vertices by more; scale: part size.
/// Single-precision STL files round coordinates by 6e-8.
inline constexpr double convex = 5e-7;

/// The volume ledger closes to this; scale: the largest volume in it.
inline constexpr double ledger = 1e-12;

/// Symmetry of an inertia, and the triangle inequality of its principal values (equality is a flat
/// body); scale: the largest of them.
inline constexpr double inertia = 1e-9;

/// An attitude given as a matrix is a rotation when no entry of R^T R - 1 is larger; scale: 1.
inline constexpr double rotation = 1e-9;

/// Principal inertias closer than this are equal: what taking the cones out of a symmetric bit
/// leaves by rounding; scale: the largest of them.
inline constexpr double equal_inertia = 1e-14;

}  // namespace tdbd::tolerance
