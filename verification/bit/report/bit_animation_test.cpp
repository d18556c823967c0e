#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "bit/cone/cone_bit.hpp"
#include "bit/files/bit_reading.hpp"
#include "bit/report/bit_output.hpp"
#include "core/config/csv.hpp"
#include "core/error.hpp"
#include "core/read_file.hpp"
#include "core/simd.hpp"
#include "core/temporary_folder.hpp"
#include "rotation/screw.hpp"

namespace tdbd::bit::bit_animation_test {

using Json = nlohmann::json;

/// A binary glTF file taken apart.
struct Gltf {
  std::array<std::uint32_t, 3> head{};    ///< magic, version, length
  std::array<std::uint32_t, 2> chunks{};  ///< what the two are
  std::string padded;                     ///< the text with its padding
  Json text;
  std::string bytes;

  const Json& accessor(std::size_t k) const { return text.at("accessors").at(k); }
};

std::uint32_t word_at(const std::string& all, std::size_t place) {
  std::uint32_t word = 0;
  std::memcpy(&word, all.data() + place, sizeof(word));
  return word;
}

Gltf written(const Bit& bit, const std::vector<BodyPoses>& frames) {
  const std::filesystem::path file = std::filesystem::path(temporary_folder()) / "motion.glb";
  write_bit_animation(file, bit, frames);
  const std::string all = read_file(file, "an animation");
  const std::size_t length = word_at(all, 12), behind = 20 + length;
  Gltf g{{word_at(all, 0), word_at(all, 4), word_at(all, 8)},
         {word_at(all, 16), word_at(all, behind + 4)},
         all.substr(20, length),
         Json::parse(all.substr(20, length)),
         all.substr(behind + 8)};
  EXPECT_EQ(word_at(all, behind), g.bytes.size());
  EXPECT_EQ(g.head[2], all.size());
  return g;
}

template <class Number>
std::vector<Number> numbers(const Gltf& g, std::size_t accessor) {
  static const std::map<std::string, std::size_t> widths{{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}};
  const Json& a = g.accessor(accessor);
  const Json& view = g.text.at("bufferViews").at(a.at("bufferView").get<std::size_t>());
  EXPECT_EQ(a.at("componentType"), (std::is_same_v<Number, Single> ? 5126 : 5125));  // OpenGL's
  std::vector<Number> all(a.at("count").get<std::size_t>() * widths.at(a.at("type")));
  std::memcpy(all.data(), g.bytes.data() + view.at("byteOffset").get<std::size_t>(),
              all.size() * sizeof(Number));
  return all;
}

/// Of each component of an accessor's numbers.
void expect_range(const Gltf& g, std::size_t accessor) {
  const Json &least = g.accessor(accessor).at("min"), &most = g.accessor(accessor).at("max");
  const std::vector<Single> all = numbers<Single>(g, accessor);
  const std::size_t width = least.size();
  for (std::size_t k = 0; k < width; ++k) {
    std::vector<Single> own;
    for (std::size_t i = k; i < all.size(); i += width) own.push_back(all[i]);
    EXPECT_EQ(least.at(k).get<Single>(), std::ranges::min(own));
    EXPECT_EQ(most.at(k).get<Single>(), std::ranges::max(own));
  }
}

using Corners = std::vector<Vec3>;  ///< three for each triangle

/// Of a node at rest.
Corners corners_of(const Gltf& g, const Json& node) {
  const Json& primitive = g.text.at("meshes").at(node.at("mesh").get<std::size_t>());
  EXPECT_EQ(primitive.at("primitives").size(), 1U);
  const Json& shape = primitive.at("primitives")[0];
  const auto points = shape.at("attributes").at("POSITION").get<std::size_t>();
  EXPECT_EQ(g.accessor(points).at("type"), "VEC3");
  expect_range(g, points);
  const std::vector<Single> places = numbers<Single>(g, points);
  Corners corners;
  for (const std::uint32_t v : numbers<std::uint32_t>(g, shape.at("indices").get<std::size_t>()))
    corners.emplace_back(places.at(3 * v), places.at(3 * v + 1), places.at(3 * v + 2));
  return corners;
}

/// Of a bit's parts of one kind that belong to one body, at rest.
Corners corners_of(const Bit& bit, std::size_t body, const std::string& kind) {
  Corners corners;
  for (const Part& part : bit.parts)
    if (body_of(part) == body && kind_name(part.kind) == kind)
      for (const mesh::Triangle& t : part.mesh_P.triangles)
        for (const int v : t)
          corners.push_back(part.X_BP * part.mesh_P.positions[static_cast<std::size_t>(v)]);
  return corners;
}

/// Of a body at every frame, with the times.
struct Motion {
  std::vector<Single> times;
  std::vector<Vec3> places;
  std::vector<Eigen::Quaterniond> turns;
};

Motion motion_of(const Gltf& g, std::size_t body) {
  const Json& animation = g.text.at("animations").at(0);
  Motion m;
  for (const Json& channel : animation.at("channels")) {
    if (channel.at("target").at("node") != body) continue;
    const Json& sampler = animation.at("samplers").at(channel.at("sampler").get<std::size_t>());
    EXPECT_EQ(sampler.at("interpolation"), "STEP");
    const auto input = sampler.at("input").get<std::size_t>();
    expect_range(g, input);
    m.times = numbers<Single>(g, input);
    const std::vector<Single> n = numbers<Single>(g, sampler.at("output").get<std::size_t>());
    if (channel.at("target").at("path") == "translation")
      for (std::size_t i = 0; i + 2 < n.size(); i += 3)
        m.places.emplace_back(n[i], n[i + 1], n[i + 2]);
    else
      for (std::size_t i = 0; i + 3 < n.size(); i += 4)
        m.turns.emplace_back(n[i + 3], n[i], n[i + 1], n[i + 2]);  // the file has x y z w
  }
  return m;
}

double number(double least, double most) {
  return least + (most - least) * 1e-6 * *rc::gen::inRange(0, 1'000'001);
}

Vec3 vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }

std::vector<BodyPoses> any_frames(const Bit& bit) {
  std::vector<BodyPoses> frames;
  for (int k = 0, count = *rc::gen::inRange(1, 5); k < count; ++k) {
    std::vector<double> angles;
    for (std::size_t i = 0; i < bit.cones.size(); ++i) angles.push_back(number(-7.0, 7.0));
    frames.push_back(
        body_poses(bit, Pose{rotation::exp(vector(2.0)), vector(0.5)}, angles, 0.25 + k));
  }
  return frames;
}

const Bit& bit_r() {
  static const Bit bit = read(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml");
  return bit;
}

const Bit& bit_b() {
  static const Bit bit = read(TDBD_SOURCE_DIR "/cases/bits/bit-b.toml");
  return bit;
}

/// The nodes of a body's kinds hold its triangles, and all of them.
void expect_triangles(const Gltf& g, const Bit& bit, std::size_t body) {
  std::set<std::string> kinds, shown;
  for (const Part& part : bit.parts)
    if (body_of(part) == body) kinds.insert(kind_name(part.kind));
  for (const Json& child : g.text.at("nodes").at(body).value("children", Json::array())) {
    const Json& node = g.text.at("nodes").at(child.get<std::size_t>());
    EXPECT_TRUE(shown.insert(node.at("name")).second);
    const Corners own = corners_of(g, node), expected = corners_of(bit, body, node.at("name"));
    ASSERT_EQ(own.size(), expected.size());
    constexpr double single = 2.9e-8;  // m, half of the last place of 0.2 m, three times
    for (std::size_t i = 0; i < own.size(); ++i) EXPECT_LT((own[i] - expected[i]).norm(), single);
  }
  EXPECT_EQ(shown, kinds);
}

TEST(BitAnimation, shows_every_triangle_of_every_body) {
  for (const Bit* bit : {&bit_r(), &bit_b()}) {
    std::vector<BodyPoses> frames{
        body_poses(*bit, Pose{}, std::vector<double>(bit->cones.size()), 0.0)};
    const Gltf g = written(*bit, frames);
    for (std::size_t body = 0; body <= bit->cones.size(); ++body) {
      expect_triangles(g, *bit, body);
      EXPECT_EQ(g.text.at("nodes").at(body).at("name"),
                body == 0 ? bit->name : bit->cones[body - 1].name);
    }
  }
}

/// The animation takes each body to its pose of each frame, at the frame's time.
RC_GTEST_PROP(BitAnimation, takes_each_body_where_each_frame_has_it, ()) {
  static const Bit bare = [] {  // only its motion is tested
    Bit b = bit_r();
    b.parts.resize(1);
    return b;
  }();
  const std::vector<BodyPoses> frames = any_frames(bare);
  const Gltf g = written(bare, frames);
  constexpr double single = 1.1e-7;  // of places below 1 m and of rotations
  for (std::size_t body = 0; body <= bare.cones.size(); ++body) {
    const Motion m = motion_of(g, body);
    RC_ASSERT(m.times.size() == frames.size());
    RC_ASSERT(m.places.size() == frames.size());
    RC_ASSERT(m.turns.size() == frames.size());
    for (std::size_t k = 0; k < frames.size(); ++k) {
      const Pose& X = frames[k].X_WB[body];
      RC_ASSERT(m.times[k] == static_cast<Single>(frames[k].time));
      RC_ASSERT((m.places[k] - X.p).norm() < single);
      RC_ASSERT((m.turns[k].toRotationMatrix() - X.R).norm() < 3.0 * single);
    }
  }
}

/// Its head, its chunks, and what the format requires of a scene: glTF 2.0, sections 3 and 4.4.
TEST(BitAnimation, is_a_binary_file_of_version_2) {
  Bit bit = bit_r();
  bit.parts.resize(1);
  const std::vector<BodyPoses> frames{body_poses(bit, Pose{}, {0.1, 0.2, 0.3}, 0.5)};
  for (const char* name : {"a", "ab", "abc", "abcd"}) {  // texts of any length are padded
    bit.name = name;
    const Gltf g = written(bit, frames);
    EXPECT_EQ(g.head[0], 0x46546C67U);  // "glTF"
    EXPECT_EQ(g.head[1], 2U);
    EXPECT_EQ(g.chunks[0], 0x4E4F534AU);  // "JSON"
    EXPECT_EQ(g.chunks[1], 0x004E4942U);  // "BIN"
    EXPECT_EQ(g.padded.size() % 4, 0U);
    const std::size_t text = g.padded.find_last_not_of(' ') + 1;
    EXPECT_LT(g.padded.size() - text, 4U);
    EXPECT_EQ(g.text.at("asset").at("version"), "2.0");
    EXPECT_EQ(g.text.at("scene"), 0);
    EXPECT_EQ(g.text.at("scenes").at(0).at("nodes"), Json({0, 1, 2, 3}));
    EXPECT_EQ(g.text.at("buffers").size(), 1U);
    EXPECT_EQ(g.text.at("buffers")[0].at("byteLength"), g.bytes.size());
  }
}

/// What cuts is dark, bodies are grey, gage pads have a colour; nothing shines through.
TEST(BitAnimation, gives_each_kind_its_colour) {
  std::map<std::string, std::array<double, 4>> colours;
  for (const Bit* bit : {&bit_r(), &bit_b()}) {
    std::vector<BodyPoses> frames{
        body_poses(*bit, Pose{}, std::vector<double>(bit->cones.size()), 0.0)};
    const Gltf g = written(*bit, frames);
    for (const Json& node : g.text.at("nodes")) {
      if (!node.contains("mesh")) continue;
      const Json& shape = g.text.at("meshes").at(node.at("mesh").get<std::size_t>());
      const auto number = shape.at("primitives").at(0).at("material").get<std::size_t>();
      const Json& material = g.text.at("materials").at(number);
      EXPECT_EQ(material.at("name"), node.at("name"));
      EXPECT_TRUE(material.at("doubleSided").get<bool>());
      colours[node.at("name")] = material.at("pbrMetallicRoughness").at("baseColorFactor");
    }
  }
  for (const auto& [kind, c] : colours) {
    EXPECT_EQ(c[3], 1.0) << kind;
    const auto [least, most] = std::minmax({c[0], c[1], c[2]});
    EXPECT_EQ(most < 0.1, kind == "face" || kind == "tooth") << kind;
    EXPECT_EQ(most - least > 0.3, kind == "gage-pad") << kind;
    if (kind == "gage-pad") continue;
    EXPECT_LT(most - least, 0.1) << kind;
  }
  for (const char* kind : {"face", "tooth", "cone", "bit-body", "gage-pad"})
    EXPECT_TRUE(colours.contains(kind)) << kind;
}

/// Views lie one behind the other and fill the buffer; each accessor fills its view, and is named by what
/// reads it.
TEST(BitAnimation, is_a_file_whose_numbers_fill_it) {
  std::vector<BodyPoses> frames;
  for (const double time : {0.0, 0.5, 1.0})
    frames.push_back(body_poses(bit_r(), Pose{}, {0.1, 0.2, 0.3}, time));
  const Gltf g = written(bit_r(), frames);
  std::size_t end = 0;
  for (const auto& view : g.text.at("bufferViews")) {
    EXPECT_EQ(view.at("byteOffset"), end);
    end += view.at("byteLength").get<std::size_t>();
  }
  EXPECT_EQ(end, g.text.at("buffers")[0].at("byteLength"));
  EXPECT_LE(g.bytes.size() - end, 3U);
  const std::map<std::string, std::size_t> widths{{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}};
  for (std::size_t k = 0; k < g.text.at("accessors").size(); ++k) {
    const auto& a = g.text.at("accessors")[k];
    EXPECT_EQ(a.at("bufferView"), k);
    EXPECT_EQ(4 * a.at("count").get<std::size_t>() * widths.at(a.at("type")),
              g.text.at("bufferViews")[k].at("byteLength"));
  }
  std::set<std::size_t> named;
  for (const auto& sampler : g.text.at("animations")[0].at("samplers"))
    for (const char* key : {"input", "output"}) named.insert(sampler.at(key).get<std::size_t>());
  for (const auto& shape : g.text.at("meshes"))
    for (const auto& primitive : shape.at("primitives")) {
      named.insert(primitive.at("indices").get<std::size_t>());
      for (const auto& attribute : primitive.at("attributes"))
        named.insert(attribute.get<std::size_t>());
    }
  std::set<std::size_t> shown;
  for (const auto& node : g.text.at("nodes"))
    if (node.contains("mesh")) shown.insert(node.at("mesh").get<std::size_t>());
  EXPECT_EQ(shown.size(), g.text.at("meshes").size());
  EXPECT_EQ(*shown.rbegin(), g.text.at("meshes").size() - 1);
  EXPECT_EQ(named.size(), g.text.at("accessors").size());
  EXPECT_EQ(*named.rbegin(), g.text.at("accessors").size() - 1);
}

}  // namespace tdbd::bit::bit_animation_test

namespace tdbd::bit::bit_motion_test {

/// m: places of some 0.2 m after two poses.
constexpr double rounding = 2e-15;

double number(double least, double most) {
  return least + (most - least) * 1e-6 * *rc::gen::inRange(0, 1'000'001);
}

Vec3 vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }

// The poses of its bodies take every point at rest to where the turned bit has it.
RC_GTEST_PROP(BodyPoses, take_the_bit_at_rest_to_where_it_is, ()) {
  static const Bit bit = read(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml");
  const std::vector<double> angles{number(-7.0, 7.0), number(-7.0, 7.0), number(-7.0, 7.0)};
  const Pose X_WB{rotation::exp(vector(3.0)), vector(0.1)};
  const BodyPoses poses = body_poses(bit, X_WB, angles, 1.0);
  RC_ASSERT(poses.X_WB.size() == 4U);
  const mesh::TriangleMesh there = merged_mesh(turned(bit, angles), X_WB, nullptr);
  std::size_t v = 0;
  for (const Part& part : bit.parts)
    for (const Vec3& x_P : part.mesh_P.positions) {
      const Vec3 x_W = poses.X_WB[body_of(part)] * (part.X_BP * x_P);
      RC_ASSERT((x_W - there.positions[v++]).norm() < rounding);
    }
}

/// One row for each time and body, in this order, with digits that read back exactly.
TEST(BodyPoses, are_written_as_rows_of_times_and_bodies) {
  const Bit bit = read(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml");
  std::vector<BodyPoses> frames;
  for (const double time : {0.1, 0.7})
    frames.push_back(
        body_poses(bit, Pose{rotation::exp(Vec3(0.3, -1.1, time)), Vec3(0.1, 0.2, time / 3.0)},
                   {0.1, 2.2, -time}, time));
  const std::filesystem::path file = std::filesystem::path(temporary_folder()) / "bit_poses.csv";
  write_bit_poses(file, bit, frames);
  std::vector<CsvRow> rows = read_csv_rows(file.string());
  rows.erase(rows.begin());  // the header
  ASSERT_EQ(rows.size(), 2U * 4U);
  EXPECT_EQ(read_file(file, "poses").substr(0, read_file(file, "poses").find('\n')),
            "time [s],body,x [m],y [m],z [m],xx,xy,xz,yx,yy,yz,zx,zy,zz");
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const BodyPoses& frame = frames[k / 4];
    const Pose& X = frame.X_WB[k % 4];
    ASSERT_EQ(rows[k].cells.size(), 14U);
    const auto cell = [&](std::size_t i) { return csv_number<double>(rows[k].cells[i]).value(); };
    EXPECT_EQ(cell(0), frame.time);
    EXPECT_EQ(rows[k].cells[1], k % 4 == 0 ? "bit" : bit.cones[k % 4 - 1].name);
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(cell(static_cast<std::size_t>(2 + i)), X.p(i));
      for (int j = 0; j < 3; ++j)
        EXPECT_EQ(cell(static_cast<std::size_t>(5 + 3 * i + j)), X.R(i, j));
    }
  }
}

TEST(BodyPoses, that_cannot_be_written_leave_nothing_behind) {
  const Bit bit = read(TDBD_SOURCE_DIR "/cases/bits/bit-b.toml");
  const std::vector<BodyPoses> frames{body_poses(bit, Pose{}, {}, 0.0)};
  const std::filesystem::path nowhere = std::filesystem::path(temporary_folder()) / "nowhere";
  EXPECT_THROW(write_bit_poses(nowhere / "bit_poses.csv", bit, frames), RunError);
  EXPECT_THROW(write_bit_animation(nowhere / "bit.glb", bit, frames), RunError);
  EXPECT_FALSE(std::filesystem::exists(nowhere));
}

}  // namespace tdbd::bit::bit_motion_test
