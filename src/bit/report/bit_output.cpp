#include "bit/report/bit_output.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "bit/cone/cone_bit.hpp"
#include "bit/report/cone_report.hpp"
#include "core/simd.hpp"
#include "io/whole_file.hpp"
#include "mesh/files/vtp.hpp"

namespace tdbd::bit {

BodyPoses body_poses(const Bit& bit, const Pose& X_WB, const std::vector<double>& cone_angles,
                     double time) {
  BodyPoses poses{time, {X_WB}};
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    poses.X_WB.push_back(X_WB *
                         (cone_pose(bit.cones[k], cone_angles.at(k)) * inverse(bit.cones[k].X_BK)));
  return poses;
}

void write_bit_poses(const std::filesystem::path& path, const Bit& bit,
                     const std::vector<BodyPoses>& frames) {
  std::string text = "time [s],body,x [m],y [m],z [m],xx,xy,xz,yx,yy,yz,zx,zy,zz\n";
  for (const BodyPoses& frame : frames)
    for (std::size_t body = 0; body < frame.X_WB.size(); ++body) {
      const Pose& X = frame.X_WB[body];
      text += fmt::format("{},{},{},{},{}", frame.time,
                          body == 0 ? "bit" : bit.cones[body - 1].name, X.p.x(), X.p.y(), X.p.z());
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) text += fmt::format(",{}", X.R(i, k));
      text += '\n';
    }
  write_text(path, text);
}

nlohmann::ordered_json vector_json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

void write_bit_files(const std::filesystem::path& folder, const Bit& bit,
                     std::span<const PartLaw> laws) {
  nlohmann::ordered_json cutters = nlohmann::ordered_json::array();
  for (const Cutter& c : bit.cutters)
    cutters.push_back({{"name", "cutter-" + std::to_string(c.id)},
                       {"blade", c.blade},
                       {"zone", c.zone},
                       {"tip_radius_m", c.tip_radius},
                       {"azimuth_rad", c.azimuth},
                       {"tip_height_m", c.tip_height},
                       {"profile_angle_rad", c.profile_angle},
                       {"back_rake_rad", c.back_rake},
                       {"side_rake_rad", c.side_rake},
                       {"diameter_m", c.diameter},
                       {"chamfer_m", c.chamfer}});
  nlohmann::ordered_json file{
      {"schema", 1}, {"name", bit.name}, {"gage_radius_m", bit.gage_radius}, {"cutters", cutters}};
  if (!bit.cones.empty()) file["cones"] = cones_json(bit);
  file["parts"] = properties_json(bit, laws);
  write_text(folder / "bit.json", file.dump(2) + "\n");
}

mesh::TriangleMesh merged_mesh(const Bit& bit, const Pose& X_WB,
                               std::vector<int>* part_of_triangle) {
  mesh::TriangleMesh all;
  for (std::size_t i = 0; i < bit.parts.size(); ++i) {
    const Part& part = bit.parts[i];
    const int first = static_cast<int>(all.positions.size());
    for (const Vec3& x_P : part.mesh_P.positions) all.positions.push_back(X_WB * (part.X_BP * x_P));
    for (const mesh::Triangle& t : part.mesh_P.triangles) {
      all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
      if (part_of_triangle) part_of_triangle->push_back(static_cast<int>(i));
    }
  }
  return all;
}

void write_bit_vtp(const std::filesystem::path& path, const Bit& bit, const Pose& X_WB) {
  std::vector<int> owner;
  const mesh::TriangleMesh all = merged_mesh(bit, X_WB, &owner);
  constexpr auto whole = mesh::FieldValues::whole_numbers;
  mesh::Field part{"part", {}, whole}, kind{"kind", {}, whole}, cutter{"cutter", {}, whole},
      cone{"cone", {}, whole};
  for (const int i : owner) {
    const Part& p = bit.parts[static_cast<std::size_t>(i)];
    part.values.push_back(i);
    kind.values.push_back(static_cast<double>(p.kind));
    cutter.values.push_back(p.cutter);
    cone.values.push_back(p.cone);
  }
  std::vector<mesh::Field> cells{part, kind, cutter};
  if (!bit.cones.empty()) cells.push_back(cone);
  mesh::write_vtp(path, all, {}, cells);
}

namespace {

using Json = nlohmann::ordered_json;

// Constants of the format: glTF 2.0, sections 3.6.2 and 4.4; type numbers are those of OpenGL.
constexpr int of_floats = 5126, of_indices = 5125;
constexpr std::uint32_t magic = 0x46546C67, version = 2, json_chunk = 0x4E4F534A,
                        binary_chunk = 0x004E4942;

/// The JSON descriptions of a file and its binary data.
struct Gltf {
  Json accessors = Json::array(), views = Json::array(), meshes = Json::array(),
       nodes = Json::array(), materials = Json::array(), channels = Json::array(),
       samplers = Json::array();
  std::string bytes;
};

/// Appends numbers of four bytes each. Returns the index of their accessor.
template <class Number>
std::size_t add_numbers(Gltf& g, const std::vector<Number>& numbers, const char* shape,
                        std::size_t width) {
  static_assert(sizeof(Number) == 4);
  const std::size_t size = 4 * numbers.size();
  g.views.push_back({{"buffer", 0}, {"byteOffset", g.bytes.size()}, {"byteLength", size}});
  g.bytes.append(reinterpret_cast<const char*>(numbers.data()), size);
  g.accessors.push_back({{"bufferView", g.views.size() - 1},
                         {"componentType", std::is_same_v<Number, Single> ? of_floats : of_indices},
                         {"count", numbers.size() / width},
                         {"type", shape}});
  return g.accessors.size() - 1;
}

/// The format requires the ranges of positions and times.
void note_range(Gltf& g, std::size_t accessor, const std::vector<Single>& numbers,
                std::size_t width) {
  std::vector<Single> low(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(width));
  std::vector<Single> high = low;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    low[i % width] = std::min(low[i % width], numbers[i]);
    high[i % width] = std::max(high[i % width], numbers[i]);
  }
  g.accessors[accessor]["min"] = low;
  g.accessors[accessor]["max"] = high;
}

/// Grey for bodies, dark for cutting parts.
std::array<double, 4> colour_of(PartKind kind) {
  switch (kind) {
    case PartKind::face:
    case PartKind::tooth:
      return {0.03, 0.03, 0.04, 1.0};
    case PartKind::gage_pad:
      return {0.55, 0.37, 0.11, 1.0};
    case PartKind::chamfer:
    case PartKind::cse:
    case PartKind::cutter_body:
    case PartKind::bit_body:
    case PartKind::cone:
      break;
  }
  return {0.45, 0.49, 0.54, 1.0};
}

std::size_t add_material(Gltf& g, PartKind kind) {
  g.materials.push_back(
      {{"name", kind_name(kind)},
       {"doubleSided", true},
       {"pbrMetallicRoughness", {{"baseColorFactor", colour_of(kind)}, {"metallicFactor", 0.2}}}});
  return g.materials.size() - 1;
}

/// The triangles of a body's parts of one kind, at rest.
struct KindMesh {
  std::vector<Single> places;
  std::vector<std::uint32_t> corners;
};

void add_part(const Part& part, KindMesh& m) {
  const auto first = static_cast<std::uint32_t>(m.places.size() / 3);
  for (const Vec3& x_P : part.mesh_P.positions) {
    const Vec3 x_B = part.X_BP * x_P;
    for (int i = 0; i < 3; ++i) m.places.push_back(static_cast<Single>(x_B(i)));
  }
  for (const mesh::Triangle& t : part.mesh_P.triangles)
    for (const int v : t) m.corners.push_back(first + static_cast<std::uint32_t>(v));
}

std::size_t add_mesh(Gltf& g, const KindMesh& m, std::size_t material) {
  const std::size_t points = add_numbers(g, m.places, "VEC3", 3);
  note_range(g, points, m.places, 3);
  const Json primitive{{"attributes", {{"POSITION", points}}},
                       {"indices", add_numbers(g, m.corners, "SCALAR", 1)},
                       {"material", material}};
  g.meshes.push_back({{"primitives", Json::array({primitive})}});
  return g.meshes.size() - 1;
}

/// Adds a node below the body's node for each kind of its parts. Returns their indices.
Json add_kinds(Gltf& g, const Bit& bit, std::size_t body) {
  std::map<PartKind, KindMesh> kinds;
  for (const Part& part : bit.parts)
    if (body_of(part) == body && !part.mesh_P.triangles.empty()) add_part(part, kinds[part.kind]);
  Json children = Json::array();
  for (const auto& [kind, m] : kinds) {
    g.nodes.push_back({{"name", kind_name(kind)}, {"mesh", add_mesh(g, m, add_material(g, kind))}});
    children.push_back(g.nodes.size() - 1);
  }
  return children;
}

/// The bodies' nodes come first: node i is body i.
void add_bodies(Gltf& g, const Bit& bit, std::size_t count) {
  for (std::size_t body = 0; body < count; ++body)
    g.nodes.push_back({{"name", body == 0 ? bit.name : bit.cones[body - 1].name}});
  for (std::size_t body = 0; body < count; ++body) {
    const Json children = add_kinds(g, bit, body);
    if (!children.empty()) g.nodes[body]["children"] = children;
  }
}

/// STEP, because nothing was computed between two frames, and the shortest rotation need not be
/// that of the bit.
void add_channel(Gltf& g, std::size_t body, std::size_t times, const std::vector<Single>& numbers,
                 const char* shape, std::size_t width) {
  g.samplers.push_back({{"input", times},
                        {"output", add_numbers(g, numbers, shape, width)},
                        {"interpolation", "STEP"}});
  g.channels.push_back(
      {{"sampler", g.samplers.size() - 1},
       {"target", {{"node", body}, {"path", width == 3 ? "translation" : "rotation"}}}});
}

void add_motion(Gltf& g, const std::vector<BodyPoses>& frames) {
  std::vector<Single> times;
  times.reserve(frames.size());
  for (const BodyPoses& f : frames) times.push_back(static_cast<Single>(f.time));
  const std::size_t input = add_numbers(g, times, "SCALAR", 1);
  note_range(g, input, times, 1);
  for (std::size_t body = 0; body < frames.front().X_WB.size(); ++body) {
    std::vector<Single> places, turns;
    for (const BodyPoses& f : frames) {
      const Eigen::Quaterniond q(f.X_WB[body].R);
      for (int i = 0; i < 3; ++i) places.push_back(static_cast<Single>(f.X_WB[body].p(i)));
      for (int i = 0; i < 4; ++i) turns.push_back(static_cast<Single>(q.coeffs()(i)));  // x y z w
    }
    add_channel(g, body, input, places, "VEC3", 3);
    add_channel(g, body, input, turns, "VEC4", 4);
  }
}

Json document_of(const Gltf& g, std::size_t bodies) {
  Json scene = Json::array();
  for (std::size_t i = 0; i < bodies; ++i) scene.push_back(i);
  return {
      {"asset", {{"version", "2.0"}, {"generator", "tdbd"}}},
      {"scene", 0},
      {"scenes", {{{"nodes", scene}}}},
      {"nodes", g.nodes},
      {"meshes", g.meshes},
      {"materials", g.materials},
      {"animations", {{{"name", "drilling"}, {"channels", g.channels}, {"samplers", g.samplers}}}},
      {"accessors", g.accessors},
      {"bufferViews", g.views},
      {"buffers", {{{"byteLength", g.bytes.size()}}}}};
}

void put(std::ostream& out, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8) out.put(static_cast<char>(word >> shift & 0xFF));
}

void put_chunk(std::ostream& out, std::uint32_t kind, const std::string& bytes) {
  put(out, static_cast<std::uint32_t>(bytes.size()));
  put(out, kind);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

void write_bit_animation(const std::filesystem::path& path, const Bit& bit,
                         const std::vector<BodyPoses>& frames) {
  Gltf g;
  const std::size_t bodies = frames.front().X_WB.size();
  add_bodies(g, bit, bodies);
  add_motion(g, frames);
  std::string text = document_of(g, bodies).dump();
  text.append((4 - text.size() % 4) % 4, ' ');  // chunks are aligned to four bytes
  AtomicFile file(path);
  put(file.stream(), magic);
  put(file.stream(), version);
  put(file.stream(), static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + g.bytes.size()));
  put_chunk(file.stream(), json_chunk, text);
  put_chunk(file.stream(), binary_chunk, g.bytes);
  file.commit();
}

}  // namespace tdbd::bit
