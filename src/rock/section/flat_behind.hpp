#pragma once

#include "rock/section/face_columns.hpp"

namespace tdbd::rock {

/// The wear flat of a cutter behind the plane of its outline (FaceOutline), in strips along the
/// motion of the flat. Every strip begins at the outline's edge on the flat, a straight line, and its
/// rock is that which the edge met: the strip bears where the edge is in rock (ours). No columns: the
/// cutter has no flat.
struct FlatBehind {
  FaceColumns columns;           ///< (y of the edge in F, distance behind it along the motion), m
  Vec2 edge_F = Vec2::Zero();    ///< z of the edge over y: m at y = 0, and slope
  Vec3 motion_F = Vec3::Zero();  ///< unit, along the motion, in the flat
  double width = 0.0;            ///< of a strip across the motion, over its dy
};

/// Of the parts of a cutter, worn as Cutter::wear says. `index`: of the cutter, as in Part::cutter.
FlatBehind flat_behind(const bit::Cutter& c, int index, const FaceOutline& outline,
                       const std::vector<bit::Part>& parts);

/// A part of a flat.
struct FlatPiece {
  double area = 0.0;             ///< m2
  Vec3 moment_F = Vec3::Zero();  ///< m3: the centroid is moment / area
};

/// The strips that begin between y0 and y1 (m, y0 <= y1) on the edge: exact for the mesh.
FlatPiece flat_between(const FlatBehind& flat, double y0, double y1);

}  // namespace tdbd::rock
