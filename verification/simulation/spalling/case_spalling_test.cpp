#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/types.hpp"
#include "simulation/case/case.hpp"
#include "simulation/case/rock_settings.hpp"

namespace tdbd::simulation::case_spalling_test {
namespace {

Case spalling(std::vector<std::string> settings, const std::string& file = "bit-b-3000psi") {
  settings.emplace_back("rock.edge_length='4 mm'");
  settings.emplace_back("rock.pressure='0 psi'");
  return read_case(TDBD_SOURCE_DIR "/cases/" + file + ".toml", settings);
}

void expect_complaint(const std::vector<std::string>& settings, const std::string& expected,
                      const std::string& file = "bit-b-3000psi") {
  std::string found = "none";
  try {
    spalling(settings, file);
  } catch (const InputError& e) {
    found = e.what();
  }
  EXPECT_NE(found.find(expected), std::string::npos) << found << "\nexpected: " << expected;
}

TEST(CaseSpalling, is_off_without_the_table) { EXPECT_FALSE(spalls(spalling({}).spalling)); }

TEST(CaseSpalling, has_the_rule_of_the_table_on_every_cutter) {
  const Case c = spalling({"spalling={angle='60 deg', ahead_share=0.25}"});
  ASSERT_EQ(c.spalling.rules.size(), c.bit.cutters.size());
  for (const auto& rule : c.spalling.rules) {
    ASSERT_TRUE(rule);
    EXPECT_EQ(rule->angle, 60.0 * degree);
    EXPECT_EQ(rule->depth_share, 1.0);
    EXPECT_EQ(rule->ahead_share, 0.25);
  }
  EXPECT_EQ(c.spalling.beds, std::vector<std::uint8_t>{1});
}

TEST(CaseSpalling, areas_decide_each_property_by_rank) {
  const Case c = spalling({"spalling={angle='60 deg'}",
                           "spalling.areas.faces={kind='face', angle='70 deg', depth_share=0.5}",
                           "spalling.areas.nose={kind='face', zone='nose', depth_share=0}"});
  int on = 0, off = 0;
  for (std::size_t i = 0; i < c.bit.cutters.size(); ++i) {
    const bool nose = c.bit.cutters[i].zone == "nose";
    EXPECT_EQ(c.spalling.rules[i].has_value(), !nose);
    ++(nose ? off : on);
    if (nose) continue;
    EXPECT_EQ(c.spalling.rules[i]->angle, 70.0 * degree);
    EXPECT_EQ(c.spalling.rules[i]->depth_share, 0.5);
  }
  EXPECT_GT(on, 0);
  EXPECT_GT(off, 0);
}

/// Off under pressure: the case then has no rules at all, and a warning.
TEST(CaseSpalling, is_off_where_the_rock_is_confined) {
  const auto at = [](const char* pressure) {
    return spalling({"spalling={angle='60 deg', up_to_pressure='2 MPa'}",
                     std::string("rock.pressure=") + pressure});
  };
  // The last setting of a key counts: spalling() sets rock.pressure to 0.
  EXPECT_TRUE(spalls(at("'2 MPa'").spalling));
  const Case confined =
      read_case(TDBD_SOURCE_DIR "/cases/bit-b-3000psi.toml",
                {"rock.edge_length='4 mm'", "spalling={angle='60 deg', up_to_pressure='2 MPa'}"});
  EXPECT_FALSE(spalls(confined.spalling));
  ASSERT_EQ(confined.warnings.size(), 1U);
  EXPECT_EQ(without_place(confined.warnings.front()),
            "spalling: no rock breaks out: all of it is confined by more than up_to_pressure");
  const Case less =
      read_case(TDBD_SOURCE_DIR "/cases/bit-b-3000psi.toml",
                {"rock.edge_length='4 mm'", "spalling={angle='60 deg', up_to_pressure='21 MPa'}"});
  EXPECT_TRUE(spalls(less.spalling));
}

TEST(CaseSpalling, chooses_the_beds_of_a_material) {
  const Case c = spalling({"spalling={angle='60 deg', material='sierra-white-granite'}",
                           "rock.layers=[{top='5 mm', material='sierra-white-granite'}, {top='9 "
                           "mm', material='berea-sandstone'}]"});
  EXPECT_EQ(c.spalling.beds, (std::vector<std::uint8_t>{0, 1, 0}));
}

TEST(CaseSpalling, rejects_angles_outside_0_and_90_degrees) {
  for (const auto& [given, shown] :
       {std::pair{"'0 deg'", "0"}, {"'90 deg'", "90"}, {"'-10 deg'", "-10"}, {"'120 deg'", "120"}})
    expect_complaint({std::string("spalling.angle=") + given},
                     "--set: spalling.angle: found " + std::string(shown) +
                         " degrees, expected an angle in (0, 90) degrees");
  expect_complaint({"spalling={angle='60 deg'}", "spalling.areas.a={kind='face', angle='95 deg'}"},
                   "--set: spalling.areas.a.angle: found 95 degrees, expected an angle in (0, 90) "
                   "degrees");
}

TEST(CaseSpalling, rejects_meaningless_values_with_their_key) {
  const std::string on = "spalling.angle='60 deg'";
  expect_complaint({"spalling.depth_share=0.5"}, "spalling.angle: ");
  expect_complaint({on, "spalling.depth_share=1.5"},
                   "--set: spalling.depth_share: found 1.5, expected");
  expect_complaint({on, "spalling.ahead_share=1"},
                   "--set: spalling.ahead_share: found 1, expected");
  expect_complaint({on, "spalling.up_to_pressure=-1"},
                   "--set: spalling.up_to_pressure: found -1, expected");
  expect_complaint({on, "spalling.material='chalk'"},
                   "--set: spalling.material: found \"chalk\", expected a rock of [rock]: "
                   "mancos-shale");
  expect_complaint({on, "measure.section=off"}, "spalling: found measure.section = \"off\", ");
}

TEST(CaseSpalling, rejects_areas_that_decide_nothing) {
  const std::string on = "spalling.angle='60 deg'";
  expect_complaint(
      {on, "spalling.areas.a={kind='chamfer', depth_share=0}"},
      "--set: spalling.areas.a: found cutter-1/chamfer, which is not the face of a cutter, "
      "expected criteria that select faces, because rock breaks out only beside them");
  expect_complaint({on, "spalling.areas.a={kind='face'}"},
                   "--set: spalling.areas.a: found no property, expected angle, depth_share or "
                   "ahead_share");
  expect_complaint(
      {on, "spalling.areas.a={kind='face', names='cutter-1/*', depth_share=0.5}",
       "spalling.areas.b={kind='face', names='*/face', depth_share=0.25}"},
      "--set: spalling.areas.b.depth_share: found 0.25 for cutter-1/face, expected 0.5, as ");
  expect_complaint({on},
                   "spalling: found a bit without faces of cutters, expected a bit with "
                   "cutters",
                   "bit-r-steady");
}

/// The cutters in the cone of bit B are at 15 degrees to the axis, along which they move rock.
TEST(CaseSpalling, rejects_cracks_that_the_update_direction_cannot_follow) {
  expect_complaint({"spalling.angle='12 deg'"},
                   "spalling.angle: found 12 degrees for cutter-1/face, which moves rock at 15.0 "
                   "degrees from the profile's normal, expected more than 17.9 degrees for it");
}

}  // namespace
}  // namespace tdbd::simulation::case_spalling_test
