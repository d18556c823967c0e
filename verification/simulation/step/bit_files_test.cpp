#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bit/files/bit_export.hpp"
#include "core/tolerance.hpp"
#include "simulation/case/case.hpp"
#include "simulation/step/simulation.hpp"
#include "verification/bit/files/bit_reading.hpp"
#include "verification/simulation/mesh_bit.hpp"

namespace tdbd::simulation::bit_files_test {

namespace fs = std::filesystem;

const std::string bit_b = TDBD_SOURCE_DIR "/cases/bits/bit-b.toml";
const std::string bit_r = TDBD_SOURCE_DIR "/cases/bits/bit-r.toml";

/// A bit, written to a folder in a format and read back.
std::string exported(const fs::path& folder, const std::string& format,
                     const std::string& bit_file = bit_b) {
  bit::export_bit(folder, bit::read(bit_file), {.parts = format});
  return (folder / "bit.toml").string();
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

/// Parts in turn: in the single precision of STL files the parts of a cutter do not fill one convex
/// solid any more.
TEST(ExportedBit, drills_the_same_hole) {
  const fs::path folder = test_folder();
  const std::vector<std::string> in_turn{"update.exit_from='parts'"};
  const Drilled original = drill(folder, bit_b, in_turn);
  for (const char* format : {"ply", "off", "stl"}) {
    const Drilled again = drill(folder, exported(folder / format, format), in_turn);
    EXPECT_NEAR(again.all / original.all, 1.0, 9e-7) << format;
    EXPECT_LE(worst_part(original, again), 1e-6) << format;
  }
}

TEST(ExportedBit, drills_the_same_hole_with_turning_cones) {
  const fs::path folder = test_folder();
  const std::vector<std::string> rolling{"motion.cone_speeds=rolling", "rock.edge_length=4 mm",
                                         "rock.shape=flat"};
  const Drilled original = drill(folder, bit_r, rolling);
  const Drilled again = drill(folder, exported(folder / "out", "ply", bit_r), rolling);
  EXPECT_GT(original.all, 5e-7);
  EXPECT_NEAR(again.all / original.all, 1.0, 1e-12);
  EXPECT_LE(worst_part(original, again), 1e-12);
}

/// The whole bit in one file: its parts lie in the bit's frame instead of their own.
TEST(ExportedBit, drills_the_same_hole_from_one_file) {
  const fs::path folder = test_folder();
  const Drilled original = drill(folder, bit_b);
  for (const char* format : {"stl", "obj", "ply", "off"}) {
    fs::create_directories(folder / format);
    bit::export_solids(folder / format, bit::read(bit_b), {.solids = format});
    const Drilled again = drill(folder, (folder / format / "solids.toml").string());
    EXPECT_NEAR(again.all / original.all, 1.0, 1e-12) << format;
    EXPECT_LE(worst_part(original, again), 1e-12) << format;
  }
}

/// Mean weight and torque of 60 steps.
std::array<double, 2> mean_loads(const fs::path& folder, const std::string& bit_file) {
  const Case c =
      read_case(write_case(folder, bit_file,
                           "shape = \"conforming\"\nedge_length = \"3 mm\"\nwall = \"15 mm\"\n"
                           "material = \"mancos-shale\"",
                           "step = \"2 ms\"\nduration = \"120 ms\"\n[forces]\n"
                           "coefficients = \"hanson-hansen-shale\""),
                {});
  Simulation s = start(c);
  std::array<double, 2> loads{};
  while (s.state.steps_done < c.time.steps) {
    step(c, s);
    loads[0] -= s.work.loads.force_W.z() / static_cast<double>(c.time.steps);
    loads[1] -= s.work.loads.torque_W.z() / static_cast<double>(c.time.steps);
  }
  return loads;
}

/// Faces and chamfers carry what they carry as cutters of a table.
TEST(ExportedBit, carries_the_same_forces) {
  const fs::path folder = test_folder();
  const std::array<double, 2> original = mean_loads(folder, bit_b);
  EXPECT_GT(original[0], 1e3);
  bit::export_solids(folder, bit::read(bit_b), {.solids = "stl"});
  for (const std::string& file :
       {(folder / "solids.toml").string(), exported(folder / "parts", "ply")}) {
    const std::array<double, 2> again = mean_loads(folder, file);
    EXPECT_NEAR(again[0] / original[0], 1.0, 1e-9) << file;
    EXPECT_NEAR(again[1] / original[1], 1.0, 1e-9) << file;
  }
}

/// A rock that conforms to a bit with cones is the same whether its teeth are designed or meshes.
TEST(ExportedBit, starts_in_the_same_hole_with_cones) {
  const fs::path folder = test_folder();
  bit::export_solids(folder, bit::read(bit_r), {.solids = "ply"});
  const auto hole_of = [&](const std::string& file) {
    return start(read_case(write_case(folder, file,
                                      "shape = \"conforming\"\nedge_length = \"4 mm\"\n"
                                      "wall = \"90 mm\"",
                                      "step = \"1 ms\"\nduration = \"1 ms\""),
                           {"motion.cone_speeds=rolling"}))
        .state.ledger.hole_start;
  };
  const double designed = hole_of(bit_r);
  EXPECT_NEAR(hole_of((folder / "solids.toml").string()) / designed, 1.0, 1e-4);
}

/// Blades that may cut, 1.5 mm behind their cutters, at 8.3 mm a revolution: they remove rock, no
/// vertex stays inside any part, and the ledger closes. A body that rubs removes none.
TEST(BladesThatCut, a_body_that_cuts_removes_rock_and_the_ledger_closes) {
  const fs::path folder = test_folder();
  const std::string file =
      write_file(folder / "bit.toml", "name = \"b\"\ntable = \"" TDBD_SOURCE_DIR
                                      "/cases/bits/bit-b.csv\"\n[blades]\nexposure = \"1.5 mm\"\n"
                                      "slot_depth = \"16 mm\"\nedge = \"8 mm\"\ncuts = true\n");
  const Case c = read_case(
      write_case(folder, file, "shape = \"conforming\"\nwall = \"15 mm\"\nedge_length = \"4 mm\"",
                 "step = \"2 ms\"\nduration = \"160 ms\""),
      {});
  Simulation s = start(c);
  ASSERT_FALSE(s.work.cutting.groups.empty());
  ASSERT_EQ(s.work.cutting.groups.back().parts[0].name, "bit-body");
  EXPECT_TRUE(s.work.cutting.groups.back().parts[0].tree_P.has_value());
  const auto body = static_cast<std::size_t>(s.work.cutting.groups.back().parts[0].part);
  while (s.state.steps_done < c.time.steps) step(c, s);
  EXPECT_GT(s.state.ledger.removed_by_part[body].value(), 1e-9);
  EXPECT_LE(ledger_defect(s), tolerance::ledger);
}

}  // namespace tdbd::simulation::bit_files_test
