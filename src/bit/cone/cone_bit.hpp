#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "core/error.hpp"

namespace tdbd::bit {

/// Frame K of a cone in the bit frame at the cone's angle phi (rad, about K's Z). Z is along the
/// journal, from outside the bit towards its axis and down; at azimuth 0, without skew, it is (-cos
/// J, 0, sin J) with J the journal angle. Without an offset, Z meets the bit's axis at the foot.
/// The chain from the bit to the cone is
///   Rz(azimuth)  offset along Y, foot  Rz(skew)  Ry(J - pi/2)  apex along Z  Rz(phi)
/// A bit that rotates about +z rolls its cones with a negative phi'. A point of a cone moves by bit
/// (2), with s = K's Z.
Pose cone_pose(const ConeLayout& cone, double phi);

/// The same for a cone of a bit, from its frame at angle 0.
Pose cone_pose(const Cone& cone, double phi);

/// A part's frame in the bit frame with the bit's cones at these angles (rad about their Z, one per
/// cone): X_BK(phi) X_KP for the parts of a cone, X_BP for all others; bit (2). With a pose of the
/// bit, X_WP = X_WB part_pose. Parts of one cone move as one rigid body.
Pose part_pose(const Bit& bit, const Part& part, const std::vector<double>& cone_angles);

/// Returns the bit with its cones at these angles.
Bit turned(Bit bit, const std::vector<double>& cone_angles);

/// How the teeth of a gage row move rock; those of inner rows move it straight down. All four rules
/// are reconstructed: thesis 4.1.2.2 only states that a direction belongs to a region of the bit.
enum class GageRule {
  normal,     ///< each vertex along the tooth's normal there (Part::core_P), bit (9)
  row,        ///< one direction per row: its normal in the journal's plane, outward and down
  down,       ///< straight down, like inner rows
  horizontal  ///< straight outwards
};

/// Sets the update direction of every tooth of a roller cone bit. The core of a tooth is the axis
/// of a pin with a round end of the tooth's diameter, up to the centre of that end.
void set_tooth_directions(Bit& bit, GageRule rule);

/// Reports why given cones do not make a bit: the cone, the key, what was found and what is
/// expected.
struct ConeBitError : InputError {
  ConeBitError(std::size_t of_cone, std::string of_key, std::string was, std::string wanted);

  std::size_t cone;  ///< index into the given cones
  std::string key;   ///< of the cone
  std::string found, expected;
};

/// Makes a roller cone bit from the layouts of its cones: their parts (cone_parts), cone by cone,
/// then the shank. With `gage_radius` (m), every cone with a gage row is moved along its journal
/// until that row reaches it (apex_for_gage). Then all cones are moved along z until the deepest
/// reach of their teeth is z = 0, the bit's origin. Any number and arrangement of cones is
/// possible. The caller checks cone_faults first. Throws InputError without cones or teeth, and
/// ConeBitError if a row cannot reach the gage or if a cone's body extends beyond it. Thesis: 1.2,
/// 3.1, fig. 3.5.
Bit cone_bit(std::string name, std::vector<ConeLayout> cones, std::optional<double> gage_radius,
             const Shank& shank);

}  // namespace tdbd::bit
