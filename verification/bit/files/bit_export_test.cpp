#include "bit/files/bit_export.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bit/cone/part_pose.hpp"
#include "bit/files/bit_export_solids.hpp"
#include "mesh_bit.hpp"
#include "simulation/case/case.hpp"
#include "simulation/step/simulation.hpp"
#include "verification/simulation/bit_reading.hpp"

namespace tdbd::bit {
namespace {

namespace fs = std::filesystem;

const std::string bit_b = TDBD_SOURCE_DIR "/cases/bits/bit-b.toml";
const std::string bit_r = TDBD_SOURCE_DIR "/cases/bits/bit-r.toml";

/// A bit, written to a folder in a format and read back.
std::string exported(const fs::path& folder, const std::string& format,
                     const std::string& bit_file = bit_b) {
  export_bit(folder, read(bit_file), format);
  return (folder / "bit.toml").string();
}

void expect_same_but_for_rounding(const Bit& a, const Bit& b, double rounding) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_NEAR(a.gage_radius, b.gage_radius, rounding);
  ASSERT_EQ(a.parts.size(), b.parts.size());
  for (std::size_t i = 0; i < a.parts.size(); ++i) {
    const Part &p = a.parts[i], &q = b.parts[i];
    EXPECT_EQ(p.name, q.name);
    EXPECT_EQ(p.kind, q.kind);
    EXPECT_EQ(p.cutting, q.cutting);
    EXPECT_EQ(p.group, q.group);
    EXPECT_EQ(p.density, q.density);
    EXPECT_LE((p.update_direction_B - q.update_direction_B).norm(), 1e-14) << p.name;
    EXPECT_LE((p.X_BP.R - q.X_BP.R).norm(), 1e-14) << p.name;
    EXPECT_LE((p.X_BP.p - q.X_BP.p).norm(), 1e-16) << p.name;
    EXPECT_EQ(p.mesh_P.triangles.size(), q.mesh_P.triangles.size()) << p.name;
  }
}

TEST(bit_export, reads_back_with_every_bit_of_the_coordinates) {
  const Bit original = read(bit_b);
  for (const char* format : {"ply", "off", "obj"}) {
    const Bit again = read(exported(test_folder(), format));
    expect_same_but_for_rounding(original, again, 1e-16);
    for (std::size_t i = 0; i < original.parts.size(); ++i)
      EXPECT_EQ(original.parts[i].mesh_P.positions, again.parts[i].mesh_P.positions) << format;
  }
}

TEST(bit_export, reads_back_from_single_precision) {
  expect_same_but_for_rounding(read(bit_b), read(exported(test_folder(), "stl")), 1e-8);
}

struct Drilled {
  std::vector<double> by_part;
  double all = 0.0;
};

/// 3 mm edges, 150 steps.
Drilled drill(const fs::path& folder, const std::string& bit_file,
              const std::vector<std::string>& overrides = {}) {
  const Case c =
      read_case(write_case(folder, bit_file,
                           "shape = \"conforming\"\nedge_length = \"3 mm\"\nwall = \"15 mm\"",
                           "step = \"1 ms\"\nduration = \"150 ms\""),
                overrides);
  Simulation s = start(c);
  while (s.state.steps_done < c.time.steps) step(c, s);
  Drilled d;
  d.all = s.state.ledger.removed.value();
  for (const auto& sum : s.state.ledger.removed_by_part) d.by_part.push_back(sum.value());
  return d;
}

/// Largest difference of a part's volume, over the largest part's volume.
double worst_part(const Drilled& a, const Drilled& b) {
  const double scale = *std::max_element(a.by_part.begin(), a.by_part.end());
  double worst = 0.0;
  for (std::size_t i = 0; i < a.by_part.size(); ++i)
    worst = std::max(worst, std::abs(a.by_part[i] - b.by_part.at(i)) / scale);
  return worst;
}

TEST(bit_export, drills_the_same_hole) {
  const fs::path folder = test_folder();
  const Drilled original = drill(folder, bit_b);
  for (const char* format : {"ply", "off", "stl"}) {
    const Drilled again = drill(folder, exported(folder / format, format));
    EXPECT_NEAR(again.all / original.all, 1.0, 1e-6) << format;
    EXPECT_LE(worst_part(original, again), 1e-6) << format;
  }
}

TEST(bit_export, reads_back_with_cones_that_turn) {
  const Bit original = read(bit_r), again = read(exported(test_folder(), "stl", bit_r));
  ASSERT_EQ(again.cones.size(), 3u);
  const std::vector<double> angles{0.3, -20.0, 1e-3};
  expect_same_but_for_rounding(turned(original, angles), turned(again, angles), 1e-15);
  for (std::size_t i = 0; i < original.parts.size(); ++i) {
    EXPECT_EQ(original.parts[i].cone, again.parts[i].cone);
    EXPECT_EQ(original.parts[i].mesh_P.positions, again.parts[i].mesh_P.positions);
  }
}

TEST(bit_export, drills_the_same_hole_with_turning_cones) {
  const fs::path folder = test_folder();
  const std::vector<std::string> rolling{"motion.cone_speeds=rolling", "rock.edge_length=4 mm",
                                         "rock.shape=flat"};
  const Drilled original = drill(folder, bit_r, rolling);
  const Drilled again = drill(folder, exported(folder / "out", "ply", bit_r), rolling);
  EXPECT_GT(original.all, 5e-7);
  EXPECT_NEAR(again.all / original.all, 1.0, 1e-6);
  EXPECT_LE(worst_part(original, again), 1e-6);
}

/// The whole bit in one file: its parts lie in the bit's frame instead of their own.
TEST(bit_export, drills_the_same_hole_from_one_file) {
  const fs::path folder = test_folder();
  const Drilled original = drill(folder, bit_b);
  for (const char* format : {"stl", "obj", "ply", "off"}) {
    fs::create_directories(folder / format);
    export_solids(folder / format, read(bit_b), format);
    const Drilled again = drill(folder, (folder / format / "solids.toml").string());
    EXPECT_NEAR(again.all / original.all, 1.0, 1e-6) << format;
    EXPECT_LE(worst_part(original, again), 1e-6) << format;
  }
}

TEST(bit_export, writes_the_exposure_profile) {
  const fs::path folder = test_folder();
  write_profile(folder, read(bit_b));
  std::ifstream in(folder / "profile.csv");
  std::string line, last;
  std::getline(in, line);
  EXPECT_EQ(line, "r_m,z_m");
  while (std::getline(in, line)) last = line;
  EXPECT_NEAR(std::stod(last), read(bit_b).gage_radius, 1e-5);
}

}  // namespace
}  // namespace tdbd::bit
