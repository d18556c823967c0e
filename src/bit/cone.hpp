#pragma once

#include <string>
#include <vector>

#include "bit/part_kind.hpp"
#include "core/pose.hpp"

namespace tdbd::bit {

/// How a tooth is made. Milled teeth are cut from the cone's steel; inserts are pressed in.
enum class ToothKind { milled_chisel, hemispherical, conical, chisel };

/// The location of a row. The teeth of a gage row reach the gage radius during a turn of the cone.
enum class RowPlace { inner, gage };

/// One tooth, in its frame T: origin on the shell, Z out of the cone, X along the cone's meridian
/// towards the base. Every kind is mirror-symmetric in X and in Y. Lengths in m, angles in rad.
struct ToothShape {
  ToothKind kind = ToothKind::hemispherical;
  double diameter = 12e-3;     ///< of an insert's shank; of a milled tooth, length at the shell
  double width = 8e-3;         ///< milled teeth only: in circumferential direction, at the shell
  double protrusion = 6.5e-3;  ///< height of the tip above the shell
  double crest_length = 6e-3;  ///< chisels only: along X
  double crest_width = 2e-3;   ///< chisels only: along Y
  double tip_radius = 4e-3;    ///< conical inserts only
  double half_angle = 0.6;     ///< conical inserts only: of the cone
  double embedding = 4e-3;     ///< depth below the shell
  double density = 14.9e3;     ///< kg/m3
};

/// A ring of equal teeth around a cone.
struct ToothRow {
  double s = 0.0;              ///< m, position on the shell, as in ShellPoint
  double sink = 0.0;           ///< m, depth of the teeth's origins below the shell
  double lean = 0.0;           ///< rad, from the shell's normal towards the base
  std::vector<double> angles;  ///< rad about the cone's Z, one per tooth, ascending, in [0, 2 pi)
  RowPlace place = RowPlace::inner;
  ToothShape shape;
};

/// A point of a cone's meridian: s along the journal, outwards (against the cone's Z); r is the
/// distance from the journal's axis.
struct ShellPoint {
  double s = 0.0;  ///< m
  double r = 0.0;  ///< m
};

/// The layout of a cone: its journal, its shell (a stack of frustums) and its rows of teeth. For
/// the frames see cone_frame.hpp. Thesis: 1.2, 3.1, fig. 3.5.
struct ConeLayout {
  static constexpr double usual_density = 7850.0;  // kg/m3
  static constexpr int usual_segments = 96, usual_facets = 16;

  double journal_angle = 0.0;     ///< rad, of the journal below the plane normal to the bit's axis
  double offset = 0.0;            ///< m, of the journal, in the direction of the bit's rotation
  double skew = 0.0;              ///< rad, rotation of the journal's outer end, in that direction
  double azimuth = 0.0;           ///< rad, of the journal about the bit's +z
  double apex = 0.0;              ///< m, from the foot of the journal to the cone's origin, along Z
  double foot_height = 0.0;       ///< m, of the journal's foot above the bit's origin (against z)
  std::vector<ShellPoint> shell;  ///< in ascending s, from the nose to the base
  std::vector<ToothRow> rows;     ///< from the nose to the base
  Cutting body = Cutting::never;  ///< whether the shell crushes rock left between prints
  double density = usual_density;  ///< kg/m3
  int segments = usual_segments;   ///< of the shell's mesh
  int facets = usual_facets;       ///< of an insert's mesh, a multiple of 4
};

/// A cone of a bit: its layout, and its frame K in the bit frame B at the cone's angle 0.
struct Cone {
  std::string name;  ///< "cone-1"
  ConeLayout layout;
  Pose X_BK;
  /// Ratio of the speed of the rolling cone to that of the bit, for a cone of solids, which has no
  /// rows. 0: unknown.
  double rolling_ratio = 0.0;
};

/// The steel above the cones: a cylinder about the bit's axis that never cuts. In a bit without
/// legs it also represents them. Lengths in m.
struct Shank {
  double radius = 0.0;  ///< 0: none
  double length = 0.0;
  double height = 0.0;  ///< height of its lower end above the bit's origin
  double density = 7850.0;
};

/// The legs that carry the journals, one per cone (cone/legs.hpp), and the flush carbide inserts in
/// their outer sides. Lengths in m; heights above the bit's origin.
struct Legs {
  double width = 0.0;          ///< across the journal; 0: none
  double under_gage = 1.6e-3;  ///< distance of the outer side inside the gage radius
  double clearance = 2e-3;     ///< distance from the base of the cone's shell to the leg
  double tip_radius = 0.0;     ///< of the shirttail about the journal; 0: as the shell's base
  double shoulder = 0.0;       ///< height at which the outer side leaves the gage
  double top = 0.0;            ///< height at which it meets the shank's side
  double density = 7850.0;     ///< kg/m3
  Cutting cutting = Cutting::rubs;
  int inserts = 0;  ///< number on each leg, in a column
  double insert_diameter = 9.5e-3;
  double insert_length = 8e-3;
  double insert_protrusion = 0.5e-3;  ///< of the middle of an insert's flat face out of the leg
};

}  // namespace tdbd::bit
