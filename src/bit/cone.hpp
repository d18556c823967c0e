#pragma once

#include <string>
#include <vector>

#include "bit/part_kind.hpp"
#include "core/pose.hpp"

namespace tdbd::bit {

/// How a tooth is made. Domain: milled teeth are cut from the cone's steel, inserts are pressed in.
enum class ToothKind { milled_chisel, hemispherical, conical, chisel };

/// A row at the gage has its teeth reach the gage radius in the course of a cone's turn.
enum class RowPlace { inner, gage };

/// One tooth, in its frame T: origin on the shell, Z out of the cone, X along the cone's meridian
/// towards the base. Every kind is mirror-symmetric in X and in Y. Lengths in m, angles in rad.
struct ToothShape {
  ToothKind kind = ToothKind::hemispherical;
  double diameter = 12e-3;     ///< of an insert's shank; a milled tooth's length at the shell
  double width = 8e-3;         ///< milled only: along the circumference, at the shell
  double protrusion = 6.5e-3;  ///< tip above the shell
  double crest_length = 6e-3;  ///< chisels only: along X
  double crest_width = 2e-3;   ///< chisels only: along Y
  double tip_radius = 4e-3;    ///< conical only
  double half_angle = 0.6;     ///< conical only: of the cone
  double embedding = 4e-3;     ///< how far it is sunk below the shell
  double density = 14.9e3;     ///< kg/m3
};

/// A ring of equal teeth around a cone.
struct ToothRow {
  double s = 0.0;              ///< m, place on the shell: as ShellPoint
  double sink = 0.0;           ///< m, how far the teeth's origins lie below the shell
  double lean = 0.0;           ///< rad, from the shell's normal towards the base
  std::vector<double> angles;  ///< rad about the cone's Z, one for each tooth, rising, in [0, 2 pi)
  RowPlace place = RowPlace::inner;
  ToothShape shape;
};

/// A point of a cone's meridian: s along the journal outwards (against the cone's Z), r from it.
struct ShellPoint {
  double s = 0.0;  ///< m
  double r = 0.0;  ///< m
};

/// A cone as drawn: where its journal is, its shell of several pitches (no true cone), its rows.
/// Thesis: 1.2, 3.1, fig. 3.5; domain 2.3. The frames are those of cone_frame.hpp.
struct ConeLayout {
  double journal_angle = 0.0;     ///< rad, journal's axis below the plane normal to the bit's axis
  double offset = 0.0;            ///< m, of the journal's axis, in the sense of the bit's rotation
  double skew = 0.0;              ///< rad, of the journal's outer end, in the same sense
  double azimuth = 0.0;           ///< rad, of the journal about the bit's +z
  double apex = 0.0;              ///< m, from the foot of the journal to the cone's origin, along Z
  double foot_height = 0.0;       ///< m, of the journal's foot above the bit's origin (against z)
  std::vector<ShellPoint> shell;  ///< s rising, from the nose to the base
  std::vector<ToothRow> rows;     ///< from the nose to the base
  Cutting body = Cutting::never;  ///< whether the shell crushes what rock stands between prints
  double density = 7850.0;        ///< kg/m3
  int segments = 96;              ///< of the shell's mesh
  int facets = 16;                ///< of an insert's mesh, a multiple of 4
};

/// A cone of a bit: as drawn, and its frame K in the bit's frame B at the angle 0.
struct Cone {
  std::string name;  ///< "cone-1"
  ConeLayout layout;
  Pose X_BK;
};

/// The steel above the cones: a cylinder about the bit's axis that never cuts and stands for legs
/// and shank alike. Lengths in m.
struct Shank {
  double radius = 0.0;  ///< 0: none
  double length = 0.0;
  double height = 0.0;  ///< of its lower end above the bit's origin
  double density = 7850.0;
};

}  // namespace tdbd::bit
