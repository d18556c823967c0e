#pragma once

#include "rock/section/face_columns.hpp"

namespace tdbd::rock {

/// The wear flat of a cutter behind the plane of its outline (FaceOutline), divided into strips
/// along the motion of the flat. Not in the thesis. Every strip begins on the straight edge between
/// the flat and the outline. It meets the rock that this point of the edge met, so the strip bears
/// where the edge is in rock. No columns if the cutter has no flat.
struct FlatBehind {
  FaceColumns columns;           ///< (y of the edge in F, distance behind it along the motion), m
  Vec2 edge_F = Vec2::Zero();    ///< z of the edge over y: m at y = 0, and slope
  Vec3 motion_F = Vec3::Zero();  ///< unit vector of the motion, in the flat
  double width = 0.0;            ///< width of a strip across the motion over its dy
};

/// Computes the flat from the parts of a cutter, worn according to Cutter::wear. `index`: of the
/// cutter, as in Part::cutter.
FlatBehind flat_behind(const bit::Cutter& c, int index, const FaceOutline& outline,
                       const std::vector<bit::Part>& parts);

/// A part of a flat.
struct FlatPiece {
  double area = 0.0;             ///< m2
  Vec3 moment_F = Vec3::Zero();  ///< m3: the centroid is moment / area
};

/// The strips that begin between y0 and y1 (m, y0 <= y1) on the edge. Exact for the mesh.
FlatPiece flat_between(const FlatBehind& flat, double y0, double y1);

}  // namespace tdbd::rock
