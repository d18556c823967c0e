#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// The poses of the bodies of a bit at a time: the bit itself, then each of its cones. A pose maps
/// a point from its place at rest (bit frame B, cones at angle 0) to the space frame W.
struct BodyPoses {
  double time = 0.0;  ///< s
  std::vector<Pose> X_WB;

  template <class Archive>
  void serialize(Archive& a) {
    a(time, X_WB);
  }
};

/// The poses of a bit at X_WB with its cones at these angles (rad).
BodyPoses body_poses(const Bit& bit, const Pose& X_WB, const std::vector<double>& cone_angles,
                     double time);

/// The index of a part's body in BodyPoses.
inline std::size_t body_of(const Part& part) { return at(1 + part.cone); }

/// Writes a table with one row per time and body: time [s], body ("bit", or the cone's name), x, y,
/// z [m], and the rotation matrix row by row. The numbers read back exactly. Throws RunError.
void write_bit_poses(const std::filesystem::path& path, const Bit& bit,
                     const std::vector<BodyPoses>& frames);

/// Writes bit and motion as binary glTF 2.0, which ParaView, Blender and browsers can play: each
/// body's mesh once, a colour for each kind of part, and the poses as an animation that keeps each
/// frame until the next one. Metres, seconds, frame W; single precision, as the format requires.
/// Throws RunError.
void write_bit_animation(const std::filesystem::path& path, const Bit& bit,
                         const std::vector<BodyPoses>& frames);

}  // namespace tdbd::bit
