#include "simulation/result/run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "rotation/screw.hpp"
#include "verification/simulation/mesh_bit.hpp"
#include "verification/simulation/result_files.hpp"

namespace tdbd::simulation::run_test {

/// Ten steps of bit B, coarse.
Case with(const std::string& name, std::vector<std::string> settings) {
  settings.insert(settings.end(), {"rock.edge_length='6 mm'", "output.means_from=0"});
  return read_case(TDBD_SOURCE_DIR "/cases/" + name + ".toml", settings);
}

using Row = std::map<std::string, double>;  ///< by the column's name

/// The rows of history.csv.
std::vector<Row> rows_of(const std::filesystem::path& folder) {
  std::istringstream in(result_files(folder).at("history.csv"));
  std::vector<std::string> names;
  std::vector<Row> rows;
  std::string line, word;
  std::getline(in, line);
  for (std::istringstream head(line); std::getline(head, word, ',');)
    names.push_back(word.substr(0, word.find(' ')));
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    Row& row = rows.emplace_back();
    for (const std::string& name : names) {
      std::getline(cells, word, ',');
      row[name] = std::stod(word);
    }
  }
  return rows;
}

std::vector<Row> rows_of_run(const Case& c) {
  const auto folder = test_folder();
  run(c, {.folder = folder / "out"});
  return rows_of(folder / "out");
}

TEST(RecordOfARun, follows_the_motion_step_by_step) {
  const Case c = with("bit-b-steady", {"motion.kind=whirl", "time={step=0.002, duration=0.02}",
                                       "motion.whirl={radius=0.001, frequency=20, ramp=0.01}",
                                       "motion.tilt={angle=0.01, ramp=0}"});
  const auto rows = rows_of_run(c);
  ASSERT_EQ(rows.size(), 10U);
  double removed = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    const double t = 0.002 * static_cast<double>(i + 1);
    const Pose X_WB = pose_at(c.motion, t);
    const Vec3 turn = rotation::log(X_WB.R);
    EXPECT_DOUBLE_EQ(row.at("time"), t);
    EXPECT_DOUBLE_EQ(row.at("position_x"), X_WB.p.x());
    EXPECT_DOUBLE_EQ(row.at("position_y"), X_WB.p.y());
    EXPECT_DOUBLE_EQ(row.at("position_z"), X_WB.p.z());
    EXPECT_DOUBLE_EQ(row.at("rotation_vector_x"), turn.x());
    EXPECT_DOUBLE_EQ(row.at("rotation_vector_y"), turn.y());
    EXPECT_DOUBLE_EQ(row.at("rotation_vector_z"), turn.z());
    EXPECT_DOUBLE_EQ(row.at("rotation_angle"), c.motion.rotary_speed * t);
    EXPECT_GE(row.at("removed_volume_total"), removed);
    removed = row.at("removed_volume_total");
  }
  EXPECT_GT(removed, 0.0);
  EXPECT_FALSE(rows[0].contains("weight_on_bit"));
  EXPECT_FALSE(rows[0].contains("string_twist"));
}

TEST(RecordOfARun, has_what_the_case_measures) {
  const auto with_forces =
      rows_of_run(with("bit-b-3000psi", {"time.revolutions=0.02", "measure.contact=on"}));
  ASSERT_FALSE(with_forces.empty());
  for (const char* name :
       {"weight_on_bit", "torque_on_bit", "section_area_total", "contact_area_total"})
    EXPECT_TRUE(with_forces.back().contains(name)) << name;
  EXPECT_FALSE(with_forces.back().contains("string_twist"));
  const auto driven = rows_of_run(with("drill-bit-b", {"time.duration='5 ms'"}));
  ASSERT_EQ(driven.size(), 5U);
  EXPECT_NEAR(driven.back().at("string_twist"), 2600.0 / 5000.0, 7.5e-3);
  EXPECT_GT(driven.back().at("energy_stored"), 0.0);
}

/// Rows every so many steps, and one of what is left.
TEST(RecordOfARun, has_a_row_for_what_is_left) {
  const auto rows = rows_of_run(
      with("bit-b-steady", {"time={step=0.002, duration=0.02}", "output.history_every=4"}));
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_DOUBLE_EQ(rows[0].at("time"), 0.008);
  EXPECT_DOUBLE_EQ(rows[1].at("time"), 0.016);
  EXPECT_DOUBLE_EQ(rows[2].at("time"), 0.02);
}

TEST(SummaryOfARun, has_its_steps_turns_and_volumes) {
  const Case c = with("bit-b-3000psi", {"title=a bit's first turn", "time.revolutions=0.02"});
  const auto folder = test_folder();
  const RunSummary s = run(c, {.folder = folder});
  EXPECT_EQ(s.command, "run");
  EXPECT_EQ(s.title, "a bit's first turn");
  EXPECT_EQ(s.case_hash, c.hash);
  EXPECT_EQ(s.steps, c.time.steps);
  EXPECT_NEAR(s.revolutions, 0.02, 1e-12);
  EXPECT_NEAR(s.duration, c.time.step * static_cast<double>(c.time.steps), 1e-15);
  EXPECT_EQ(s.gage_radius, c.bit.gage_radius);
  double by_part = 0.0, by_revolution = 0.0;
  for (const PartVolumes& p : s.parts) by_part += p.removed;
  for (const double v : s.removed_volume_by_revolution) by_revolution += v;
  EXPECT_GT(s.removed_volume, 0.0);
  EXPECT_NEAR(by_part / s.removed_volume, 1.0, 1e-12);
  EXPECT_NEAR(by_revolution / s.removed_volume, 1.0, 1e-12);
  ASSERT_TRUE(s.loads);
  EXPECT_EQ(s.loads->steps, c.time.steps);
  EXPECT_EQ(s.faces.size(), c.bit.cutters.size());
  EXPECT_FALSE(s.drive);
  EXPECT_EQ(s.rock_triangles_start, start(c).state.rock.surface.triangle_count());
}

/// A step that ends at output.means_from is not in the means, the next one is; time counts from the case's first step.
TEST(SummaryOfARun, has_the_means_of_the_steps_after_their_start) {
  for (const std::string from : {"0", "0.0078125", "0.01171875", "0.0125"}) {
    const Case c =
        read_case(TDBD_SOURCE_DIR "/cases/bit-b-3000psi.toml",
                  {"rock.edge_length='8 mm'", "time={step=0.00390625, duration=0.0234375}",
                   "output.means_from=" + from});
    const RunSummary s = run(c, {.folder = test_folder(), .overwrite = Overwrite::force});
    ASSERT_TRUE(s.loads);
    const double left_out = std::floor(std::stod(from) / 0.00390625);
    EXPECT_EQ(s.loads->steps, 6 - std::lround(left_out)) << from;
    EXPECT_NEAR(s.loads->from, left_out * 0.00390625, 1e-15) << from;
  }
}

}  // namespace tdbd::simulation::run_test
