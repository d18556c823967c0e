#include "simulation/result/history_columns.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

namespace tdbd::simulation::history_columns_test {

const std::vector<HistoryPart> parts{{"cutter-1/face", "face"}, {"cone-1/tooth-1", "tooth"}};

/// A step in which no two numbers are alike.
struct Step {
  std::array<double, 2> volumes{1e-9, 2e-9}, angles{-0.3, -0.4}, speeds{-5.0, -6.0};
  std::array<rock::Section, 2> sections{
      rock::Section{1e-6, Vec3(0.1, 0.2, 0.3), 4e-3, 0.5, 6e-7, rock::OutlineStatus::clear,
                    Vec3(0.7, 0.8, 0.9)},
      rock::Section{2e-6, Vec3(1.1, 1.2, 1.3), 5e-3, 0.6, 8e-7, rock::OutlineStatus::clear,
                    Vec3(1.7, 1.8, 1.9)}};
  std::array<rock::PartContact, 2> contacts{rock::PartContact{{3e-6}, {}, 0.0},
                                            rock::PartContact{{5e-6}, {}, 0.0}};
  BitLoads loads;
  BitVelocity velocity;
  Pose X_WB{Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitX()).toRotationMatrix(),
            Vec3::Zero()};
  std::vector<double> removed{1e-9, 2e-9};
  DriveRow drive{0.01, 0.02, 30.0, 40.0, 50.0, 60.0, 70.0};
  LoadedStep loaded{loads, velocity, X_WB, removed, 0.001, {47.0, 48.0}};
  HistoryRow row;

  Step() {
    loads.force_W = Vec3(11.0, 12.0, -13.0);
    loads.torque_W = Vec3(14.0, 15.0, -16.0);
    loads.power = 17.0;
    loads.parts = {{Vec3(21.0, 22.0, 23.0), Vec3::Zero(), 24.0, 25.0, 26.0},
                   {Vec3(31.0, 32.0, 33.0), Vec3::Zero(), 34.0, 35.0, 36.0}};
    velocity.v_W = Vec3(41.0, 42.0, 43.0);
    velocity.w_W = Vec3(44.0, -45.0, 46.0);
    row.time = 0.5;
    row.p_WB = Vec3(51.0, 52.0, 53.0);
    row.rotation_vector = Vec3(54.0, 55.0, 56.0);
    row.rotation_angle = 57.0;
    row.removed_volume_total = 58.0;
    row.swept_vertices = 59;
    row.rock_triangles = 60;
    row.removed_volume_by_part = volumes;
    row.cone_angles = angles;
    row.cone_speeds = speeds;
    row.sections = sections;
    row.contacts = contacts;
    row.drive = &drive;
    row.loaded = &loaded;
  }
  Step(const Step&) = delete;
  Step& operator=(const Step&) = delete;
};

using Numbers = std::map<std::string, std::vector<double>>;

Numbers by_name(const HistoryRow& row, const HistoryExtent& extent) {
  const RecordLayout layout = step_layout(parts, extent);
  std::vector<double> numbers;
  numbers_of(row, extent, numbers);
  EXPECT_EQ(numbers.size(), layout.row_width());
  Numbers found;
  std::size_t at = 0;
  for (const RecordColumn& c : layout.columns)
    for (std::size_t i = 0; i < layout.width(c) && at < numbers.size(); ++i)
      found[c.name].push_back(numbers[at++]);
  return found;
}

const Numbers of_any_bit{{"time", {0.5}},
                         {"position_x", {51.0}},
                         {"position_y", {52.0}},
                         {"position_z", {53.0}},
                         {"rotation_vector_x", {54.0}},
                         {"rotation_vector_y", {55.0}},
                         {"rotation_vector_z", {56.0}},
                         {"rotation_angle", {57.0}},
                         {"removed_volume_total", {58.0}},
                         {"swept_vertices", {59.0}},
                         {"rock_triangles", {60.0}},
                         {"removed_volume_by_part", {1e-9, 2e-9}}};

Numbers with(Numbers more) {
  more.insert(of_any_bit.begin(), of_any_bit.end());
  return more;
}

TEST(HistoryColumns, of_every_run_are_its_steps_places_and_volumes) {
  Step s;
  s.row.cone_angles = s.row.cone_speeds = {};
  EXPECT_EQ(by_name(s.row, {}), of_any_bit);
}

TEST(HistoryColumns, have_cones_by_name) {
  const Step s;
  HistoryExtent extent;
  extent.cones = {"cone-1", "cone-2"};
  EXPECT_EQ(by_name(s.row, extent),
            with({{"cone_angle", {-0.3, -0.4}}, {"cone_speed", {-5.0, -6.0}}}));
  const RecordLayout layout = step_layout(parts, extent);
  EXPECT_EQ(layout.axes.at(1).components, extent.cones);
  EXPECT_EQ(layout.labels.back().texts, extent.cones);
}

TEST(HistoryColumns, have_what_touches_and_what_is_cut) {
  Step s;
  s.row.cone_angles = s.row.cone_speeds = {};
  HistoryExtent extent;
  extent.contact_areas = true;
  extent.cutters = {"cutter-1", "cutter-2"};
  EXPECT_EQ(by_name(s.row, extent), with({{"contact_area_total", {3e-6 + 5e-6}},
                                          {"contact_area", {3e-6, 5e-6}},
                                          {"section_area_total", {1e-6 + 2e-6}},
                                          {"section_volume_rate_total", {6e-7 + 8e-7}},
                                          {"section_area", {1e-6, 2e-6}},
                                          {"section_centroid_x", {0.1, 1.1}},
                                          {"section_centroid_y", {0.2, 1.2}},
                                          {"section_centroid_z", {0.3, 1.3}},
                                          {"section_engaged_edge", {4e-3, 5e-3}},
                                          {"section_angle_of_attack", {0.5, 0.6}},
                                          {"section_volume_rate", {6e-7, 8e-7}},
                                          {"section_edge_centroid_x", {0.7, 1.7}},
                                          {"section_edge_centroid_y", {0.8, 1.8}},
                                          {"section_edge_centroid_z", {0.9, 1.9}}}));
}

/// Weight and torque are those on the rock; the rotary speed is about the bit's own axis.
TEST(HistoryColumns, have_loads_and_the_accounts_of_a_driven_bit) {
  Step s;
  s.row.cone_angles = s.row.cone_speeds = {};
  HistoryExtent extent;
  extent.forces = extent.drive = true;
  Numbers found = by_name(s.row, extent);
  EXPECT_EQ(found, with({{"weight_on_bit", {13.0}},
                         {"torque_on_bit", {16.0}},
                         {"force_x", {11.0}},
                         {"force_y", {12.0}},
                         {"torque_x", {14.0}},
                         {"torque_y", {15.0}},
                         {"drilling_power", {17.0}},
                         {"velocity_x", {41.0}},
                         {"velocity_y", {42.0}},
                         {"rate_of_penetration", {47.0}},
                         {"rotary_speed", {48.0}},
                         {"force_normal", {24.0, 34.0}},
                         {"force_tangential", {25.0, 35.0}},
                         {"part_force_x", {21.0, 31.0}},
                         {"part_force_y", {22.0, 32.0}},
                         {"part_force_z", {23.0, 33.0}},
                         {"part_power", {26.0, 36.0}},
                         {"rock_position_z", {0.01}},
                         {"string_twist", {0.02}},
                         {"energy_stored", {30.0}},
                         {"work_of_top", {40.0}},
                         {"work_on_rock", {50.0}},
                         {"energy_lost", {60.0}},
                         {"energy_residual", {70.0}}}));
}

}  // namespace tdbd::simulation::history_columns_test
