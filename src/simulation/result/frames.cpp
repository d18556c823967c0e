#include "simulation/result/frames.hpp"

#include "bit/cone/part_pose.hpp"
#include "bit/report/bit_output.hpp"
#include "core/whole_file.hpp"
#include "mesh/files/ply.hpp"
#include "mesh/files/vtp.hpp"
#include "mesh/measures.hpp"
#include "simulation/start/rock_stamp.hpp"

namespace tdbd::simulation {
namespace {

/// Point data: depth below the start of the bit (m) and the part that cut a vertex last; cell data:
/// shape quality.
void write_rock(const std::filesystem::path& path, const rock::Rock& rock) {
  std::vector<int> slots;
  const mesh::TriangleMesh m = mesh::compact(rock.surface, &slots);
  mesh::Field depth{"depth_m", {}}, part{"last_part", {}, mesh::FieldValues::whole_numbers},
      quality{"quality", {}};
  for (const int v : slots) {
    depth.values.push_back(rock.surface.position(v).z());
    part.values.push_back(rock.last_part[at(v)]);
  }
  for (const auto& [a, b, c] : m.triangles)
    quality.values.push_back(
        mesh::triangle_quality(m.positions[at(a)], m.positions[at(b)], m.positions[at(c)]));
  mesh::write_vtp(path, m, {depth, part}, {quality});
}

/// The rock with its stamp, so that a run that goes on from it can be held to its time.
void write_stamped_rock(const std::filesystem::path& path, const Case& c, const Simulation& s) {
  const long steps = s.state.steps_done;
  WholeFile file(path);
  mesh::write_ply(file.stream(), mesh::compact(s.state.rock.surface),
                  comments_of({steps, time_at(c.time, steps), c.hash}));
  file.commit();
}

void write_bit(const std::filesystem::path& path, const Case& c, const Simulation& s) {
  bit::write_bit_vtp(path, bit::turned(c.bit, angles_of(s.state.cones)), s.state.place.X_WB);
}

bit::BodyPoses poses_of(const Case& c, const Simulation& s) {
  return bit::body_poses(c.bit, s.state.place.X_WB, angles_of(s.state.cones),
                         time_at(c.time, s.state.steps_done));
}

}  // namespace

void Frames::add(const Case& c, const Simulation& s) {
  const auto rock = folder_.frame("rock", s.state.steps_done);
  write_rock(rock, s.state.rock);
  rock_.emplace_back(time_at(c.time, s.state.steps_done), "frames/" + rock.filename().string());
  bit_.push_back(poses_of(c, s));
}

void Frames::write_final(const Case& c, const Simulation& s) {
  write_rock(folder_.frames() / "rock_final.vtp", s.state.rock);
  write_stamped_rock(folder_.path / "rock_final.ply", c, s);
  write_bit(folder_.frames() / "bit_final.vtp", c, s);
  write_collection("rock", rock_, time_at(c.time, s.state.steps_done));
  write_collection("bit", {}, time_at(c.time, s.state.steps_done));
  write_motion(c, s);
}

/// An animation of one place says no more than the mesh.
void Frames::write_motion(const Case& c, const Simulation& s) const {
  std::vector<bit::BodyPoses> frames = bit_;
  const bit::BodyPoses end = poses_of(c, s);
  if (!frames.empty() && frames.back().time == end.time) frames.pop_back();
  frames.push_back(end);
  bit::write_bit_poses(folder_.path / "bit_poses.csv", c.bit, frames);
  if (frames.size() > 1) bit::write_bit_animation(folder_.path / "bit.glb", c.bit, frames);
}

void Frames::write_collection(const std::string& name, FrameList frames, double end) const {
  if (!frames.empty() && frames.back().first == end) frames.pop_back();  // one frame for one time
  frames.emplace_back(end, "frames/" + name + "_final.vtp");
  mesh::write_pvd(folder_.path / (name + ".pvd"), frames);
}

}  // namespace tdbd::simulation
