#include "simulation/result/frames.hpp"

#include "bit/cone/part_pose.hpp"
#include "bit/report/bit_output.hpp"
#include "mesh/files/files.hpp"
#include "mesh/files/vtp.hpp"
#include "mesh/measures.hpp"

namespace tdbd::simulation {
namespace {

/// Point data: depth below the start of the bit (m) and the part that cut a vertex last; cell data:
/// shape quality.
void write_rock(const std::filesystem::path& path, const rock::Rock& rock) {
  std::vector<int> slots;
  const mesh::TriangleMesh m = mesh::compact(rock.surface, &slots);
  mesh::Field depth{"depth_m", {}}, part{"last_part", {}}, quality{"quality", {}};
  for (const int v : slots) {
    depth.values.push_back(rock.surface.position(v).z());
    part.values.push_back(rock.last_part[static_cast<std::size_t>(v)]);
  }
  const auto at = [&](int v) { return m.positions[static_cast<std::size_t>(v)]; };
  for (const mesh::Triangle& t : m.triangles)
    quality.values.push_back(mesh::triangle_quality(at(t[0]), at(t[1]), at(t[2])));
  mesh::write_vtp(path, m, {depth, part}, {quality});
}

double time_of(const Case& c, const Simulation& s) {
  return c.time.step * static_cast<double>(s.steps_done);
}

void write_bit(const std::filesystem::path& path, const Case& c, const Simulation& s) {
  bit::write_bit_vtp(path, bit::turned(c.bit, angles_of(s.cones)), s.place.X_WB);
}

}  // namespace

void Frames::add(const Case& c, const Simulation& s) {
  const auto rock = folder_.frame("rock", s.steps_done), bit = folder_.frame("bit", s.steps_done);
  write_rock(rock, s.rock);
  write_bit(bit, c, s);
  rock_.emplace_back(time_of(c, s), "frames/" + rock.filename().string());
  bit_.emplace_back(time_of(c, s), "frames/" + bit.filename().string());
}

void Frames::write_final(const Case& c, const Simulation& s) {
  write_rock(folder_.frames() / "rock_final.vtp", s.rock);
  mesh::write_mesh(folder_.path / "rock_final.ply", mesh::compact(s.rock.surface));
  write_bit(folder_.frames() / "bit_final.vtp", c, s);
  write_collection("rock", rock_, time_of(c, s));
  write_collection("bit", bit_, time_of(c, s));
}

void Frames::write_collection(const std::string& name, Collection frames, double end) const {
  if (!frames.empty() && frames.back().first == end) frames.pop_back();  // one frame for one time
  frames.emplace_back(end, "frames/" + name + "_final.vtp");
  mesh::write_pvd(folder_.path / (name + ".pvd"), frames);
}

}  // namespace tdbd::simulation
