#include <gtest/gtest.h>

#include "app/small_case.hpp"

namespace tdbd::app::bad_bit_areas_test {

/// Areas of a bit file, from its line 6 on, and what is said of them.
struct BadArea {
  const char* name;
  const char* areas;
  const char* message;
};
void PrintTo(const BadArea& m, std::ostream* out) { *out << m.name; }

SmallCase with_areas(const std::string& areas) {
  SmallCase c;
  c.edit("bit.toml", "rim_segments = 24\n", "rim_segments = 24\n" + areas);
  return c;
}

TEST(BitAreasCase, that_areas_of_a_bit_are_right) {
  const SmallCase c = with_areas(
      "[areas.a]\nzone = \"nose\"\ndensity = \"5 g/cm3\"\nremoval.cutting = \"yes\"\n"
      "removal.from_depth = \"0.1 mm\"\n");
  EXPECT_EQ(c.check().exit_code, 0) << c.check().err;
  EXPECT_EQ(c.run().exit_code, 0) << c.run().err;
}

class BadBitAreas : public ::testing::TestWithParam<BadArea> {};

TEST_P(BadBitAreas, are_rejected_with_their_place_and_reason) {
  const SmallCase c = with_areas(GetParam().areas);
  std::string message = GetParam().message;
  for (auto at = message.find('%'); at != std::string::npos; at = message.find('%'))
    message.replace(at, 1, c.path("").string());
  expect_refused(c, "bit.toml:" + message);
}

const BadArea mistakes[] = {
    {"an_area_without_criteria", "[areas.a]\ndensity = 5000\n",
     "6: areas.a: found no parts selected, expected at least one of kind, zone, blade, cone, row, "
     "names and part"},
    {"a_zone_that_the_bit_has_not", "[areas.a]\nzone = \"gage\"\ndensity = 5000\n",
     "6: areas.a: found zone = \"gage\", which no part of the bit small meets, expected one of its "
     "zones: cone, nose, shoulder"},
    {"an_area_that_gives_nothing", "[areas.a]\nzone = \"nose\"\n",
     "6: areas.a: found no property, expected density, material, removal.cutting, removal.share, "
     "removal.from_depth, removal.from_time or removal.from_wear"},
    {"a_misspelt_property",
     "[areas.a]\nzone = \"nose\"\ndensity = 5000\nremoval.from_deph = \"1 m\"\n",
     "9: areas.a.removal.from_deph: found an unknown key, expected cutting, share, "
     "from_depth, from_time, from_wear or worn_names"},
    {"a_share_of_0", "[areas.a]\nzone = \"nose\"\nremoval.share = 0\n",
     "8: areas.a.removal.share: found 0, expected a plain number, in (0, 1]"},
    {"a_share_above_1", "[areas.a]\nzone = \"nose\"\nremoval.share = 1.1\n",
     "8: areas.a.removal.share: found 1.1, expected a plain number, in (0, 1]"},
    {"a_share_of_what_removes_nothing", "[areas.a]\nkind = \"bit-body\"\nremoval.share = 0.5\n",
     "8: areas.a.removal.share: found a share of 0.5 for bit-body, which removes no rock, expected "
     "removal.cutting = \"yes\" for it, or criteria without it"},
    {"a_share_of_a_body",
     "[areas.a]\nkind = \"bit-body\"\nremoval.share = 0.5\nremoval.cutting = \"yes\"\n",
     "8: areas.a.removal.share: found a share of 0.5 for bit-body, a bit body, which rock beside "
     "it "
     "never leaves, expected criteria that select parts of cutters, gage pads or teeth"},
    {"two_shares_that_disagree",
     "[areas.a]\nblade = 1\nremoval.share = 0.5\n[areas.b]\nblade = 1\nremoval.share = 0.6\n",
     "11: areas.b.removal.share: found a share of 0.6 for cutter-1/face, expected a share of 0.5, "
     "as "
     "%bit.toml:6: areas.a gives with the same criteria, or a more particular area that decides"},
    {"a_start_at_wear_0", "[areas.a]\nzone = \"nose\"\nremoval.from_wear = 0\n",
     "8: areas.a.removal.from_wear: found 0, expected length in m, > 0"},
    {"a_pattern_that_no_cutter_matches",
     "[areas.a]\nzone = \"nose\"\nremoval.from_wear = \"1 mm\"\nremoval.worn_names = "
     "\"bit-body\"\n",
     "9: areas.a.removal.worn_names: found \"bit-body\", which no part of a cutter matches, "
     "expected a pattern of names of parts of cutters, as bit.json lists them"},
    {"a_pattern_without_a_start",
     "[areas.a]\nzone = \"nose\"\ndensity = 5000\nremoval.worn_names = \"cutter-1/*\"\n",
     "9: areas.a.removal.worn_names: found no removal.from_wear, expected removal.from_wear beside "
     "it"},
    {"starts_by_wear_and_time",
     "[areas.a]\nzone = \"nose\"\nremoval.from_time = 1\nremoval.from_wear = \"1 mm\"\n",
     "9: areas.a.removal.from_wear: found removal.from_time as well, expected one of the two"},
    {"an_unknown_material", "[areas.a]\nzone = \"nose\"\nmaterial = \"stel\"\n",
     "8: areas.a.material: found \"stel\", expected one of steel, tungsten-carbide, pdc-diamond "
     "(did "
     "you mean steel?)"},
    {"a_material_and_a_density",
     "[areas.a]\nzone = \"nose\"\nmaterial = \"steel\"\ndensity = 7000\n",
     "9: areas.a.density: found material as well, expected one of the two"},
    {"a_negative_density", "[areas.a]\nzone = \"nose\"\ndensity = -1\n",
     "8: areas.a.density: found -1, expected density in kg/m3, in [0, 30000]"},
    {"an_unknown_cutting", "[areas.a]\nzone = \"nose\"\nremoval.cutting = \"rub\"\n",
     "8: areas.a.removal.cutting: found \"rub\", expected one of yes, rubs, no (did you mean "
     "rubs?)"},
    {"a_face_that_rubs", "[areas.a]\nzone = \"nose\"\nremoval.cutting = \"rubs\"\n",
     "8: areas.a.removal.cutting: found \"rubs\" for cutter-3/face, expected \"yes\" or \"no\" for "
     "a "
     "face, whose force comes from what the face cuts"},
    {"a_start_at_depth_0", "[areas.a]\nzone = \"nose\"\nremoval.from_depth = 0\n",
     "8: areas.a.removal.from_depth: found 0, expected length in m, > 0"},
    {"a_start_at_a_negative_time", "[areas.a]\nzone = \"nose\"\nremoval.from_time = \"-1 s\"\n",
     "8: areas.a.removal.from_time: found \"-1 s\", expected time in s, > 0"},
    {"two_starts", "[areas.a]\nzone = \"nose\"\nremoval.from_depth = 1\nremoval.from_time = 1\n",
     "9: areas.a.removal.from_time: found removal.from_depth as well, expected one of the two"},
    {"a_start_of_a_part_that_never_cuts", "[areas.a]\nkind = \"bit-body\"\nremoval.from_time = 1\n",
     "6: areas.a: found a start at 1 s for bit-body, which never cuts or rubs, expected "
     "removal.cutting = \"yes\" or \"rubs\" for it, or criteria without it"},
    {"two_areas_that_disagree",
     "[areas.a]\nblade = 1\ndensity = 5000\n[areas.b]\nblade = 1\ndensity = 6000\n",
     "11: areas.b.density: found 6000 kg/m3 for cutter-1/face, expected 5000 kg/m3, as "
     "%bit.toml:6: areas.a gives with the same criteria, or a more particular area that decides"},
    {"two_starts_that_disagree",
     "[areas.a]\nblade = 1\nremoval.from_time = 1\n[areas.b]\nblade = 1\nremoval.from_depth = 1\n",
     "11: areas.b.removal.from_depth: found a start at 1 m for cutter-1/face, expected a start at "
     "1 "
     "s, as %bit.toml:6: areas.a gives with the same criteria, or a more particular area that "
     "decides"},
    {"no_part_that_cuts", "[areas.a]\nnames = \"*\"\nremoval.cutting = \"no\"\n",
     "6: areas: found no part that cuts, expected at least one"},
};

INSTANTIATE_TEST_SUITE_P(One, BadBitAreas, ::testing::ValuesIn(mistakes),
                         [](const auto& m) { return std::string(m.param.name); });

/// Of a bit whose cutters do not wear.
TEST(BitAreasCase, that_start_by_wear_need_wear_in_the_case) {
  const SmallCase c = with_areas("[areas.late]\nzone = \"nose\"\nremoval.from_wear = \"1 mm\"\n");
  expect_refused(c, "case.toml:1: wear: found no table, but " + c.path("bit.toml").string() +
                        ":6: areas.late gives cutter-3/face removal.from_wear, expected [wear], or "
                        "another start");
}

/// At the top of the file, where a table would be.
TEST(BitAreasCase, areas_that_are_no_table) {
  const SmallCase c;
  c.edit("bit.toml", "name = \"small\"\n", "name = \"small\"\nareas = 3\n");
  expect_refused(c, "bit.toml:2: areas: found 3, expected a table");
}

}  // namespace tdbd::app::bad_bit_areas_test
