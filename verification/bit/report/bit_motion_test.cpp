#include "bit/report/bit_motion.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "bit/cone/part_pose.hpp"
#include "bit/files/bit_reading.hpp"
#include "bit/report/bit_output.hpp"
#include "core/error.hpp"
#include "core/read_file.hpp"
#include "core/temporary_folder.hpp"
#include "rotation/rotation_vector.hpp"

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

/// The parts of a glTF file: the text in JSON, and the bytes behind it.
struct Gltf {
  nlohmann::json text;
  std::size_t bytes = 0;
};

Gltf read_gltf(const std::filesystem::path& file) {
  const std::string all = read_file(file, "an animation");
  std::uint32_t length = 0, bytes = 0;
  std::memcpy(&length, all.data() + 12, 4);  // behind 12 bytes of a head: length, kind, chunk
  std::memcpy(&bytes, all.data() + 20 + length, 4);
  EXPECT_EQ(all.size(), 28 + length + bytes);
  return {nlohmann::json::parse(all.substr(20, length)), bytes};
}

/// Views lie one behind the other and fill the buffer; each accessor fills its view, and is named by what
/// reads it.
TEST(BitAnimation, is_a_file_whose_numbers_fill_it) {
  const Bit bit = read(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml");
  std::vector<BodyPoses> frames;
  for (const double time : {0.0, 0.5, 1.0})
    frames.push_back(body_poses(bit, Pose{}, {0.1, 0.2, 0.3}, time));
  const std::filesystem::path file = std::filesystem::path(temporary_folder()) / "motion.glb";
  write_bit_animation(file, bit, frames);
  const Gltf g = read_gltf(file);
  std::size_t end = 0;
  for (const auto& view : g.text.at("bufferViews")) {
    EXPECT_EQ(view.at("byteOffset"), end);
    end += view.at("byteLength").get<std::size_t>();
  }
  EXPECT_EQ(end, g.text.at("buffers")[0].at("byteLength"));
  EXPECT_LE(g.bytes - end, 3U);
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

TEST(BodyPoses, that_cannot_be_written_leave_nothing_behind) {
  const Bit bit = read(TDBD_SOURCE_DIR "/cases/bits/bit-b.toml");
  const std::vector<BodyPoses> frames{body_poses(bit, Pose{}, {}, 0.0)};
  const std::filesystem::path nowhere = std::filesystem::path(temporary_folder()) / "nowhere";
  EXPECT_THROW(write_bit_poses(nowhere / "bit_poses.csv", bit, frames), RunError);
  EXPECT_THROW(write_bit_animation(nowhere / "bit.glb", bit, frames), RunError);
  EXPECT_FALSE(std::filesystem::exists(nowhere));
}

}  // namespace tdbd::bit::bit_motion_test
