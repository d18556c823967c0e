#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/report/body_report.hpp"

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

/// A vector as a JSON array, [x, y, z].
nlohmann::ordered_json vector_json(const Vec3& v);

/// Writes bit.json: the cutters and cones as placed, and the properties of every part
/// (properties_json), for figures. SI, units in the keys. `laws`: per part, of a run with forces.
/// Throws RunError if it cannot be written.
void write_bit_files(const std::filesystem::path& folder, const Bit& bit,
                     std::span<const PartLaw> laws = {});

/// Writes all parts in space at a pose as a VTK file, with part number, kind and cutter as cell
/// data, and the cone if the bit has cones. Throws RunError if it cannot be written.
void write_bit_vtp(const std::filesystem::path& path, const Bit& bit, const Pose& X_WB);

/// Returns all parts in space at a pose as one mesh. part_of_triangle (if given) receives part
/// numbers.
mesh::TriangleMesh merged_mesh(const Bit& bit, const Pose& X_WB,
                               std::vector<int>* part_of_triangle);

}  // namespace tdbd::bit
