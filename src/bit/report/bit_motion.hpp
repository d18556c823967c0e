#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Where the bodies of a bit are at a time: the bit itself, then each of its cones. A pose takes a point from where it is at
/// rest (bit frame B, cones at angle 0) to the space frame W.
struct BodyPoses {
  double time = 0.0;  ///< s
  std::vector<Pose> X_WB;
};

/// Of a bit at a pose, its cones at these angles (rad).
BodyPoses body_poses(const Bit& bit, const Pose& X_WB, const std::vector<double>& cone_angles,
                     double time);

/// The body of a part in BodyPoses.
inline std::size_t body_of(const Part& part) { return at(1 + part.cone); }

/// Writes a table, one row for each time and body: time [s], body ("bit", or the cone's name), x, y, z [m], and the rotation
/// matrix row by row. Digits that read back to the bit. Throws RunError.
void write_bit_poses(const std::filesystem::path& path, const Bit& bit,
                     const std::vector<BodyPoses>& frames);

/// Writes bit and motion as binary glTF 2.0, which ParaView, Blender and browsers play: each body's mesh once, a colour for
/// each kind of part, and its places as an animation that holds each frame until the next. Metres, seconds, frame W; single
/// precision, as the format has it. Throws RunError.
void write_bit_animation(const std::filesystem::path& path, const Bit& bit,
                         const std::vector<BodyPoses>& frames);

}  // namespace tdbd::bit
