#include <gtest/gtest.h>

#include "app/mistake.hpp"
#include "app/small_case.hpp"

namespace tdbd::app::bad_areas_test {

/// `%` in a message stands for the folder of the case.
class ForceAreasCase : public SmallCaseWithForces {
 public:
  using SmallCaseWithForces::SmallCaseWithForces;

  std::string in_folder(std::string message) const {
    for (auto at = message.find('%'); at != std::string::npos; at = message.find('%'))
      message.replace(at, 1, path("").string());
    return message;
  }
};

TEST(ForceAreasResult, that_areas_of_forces_are_right) {
  const ForceAreasCase c("[forces.areas.a]\nkind = \"face\"\nzone = \"nose\"\neps = 4e7\n");
  EXPECT_EQ(c.check().exit_code, 0) << c.check().err;
  EXPECT_EQ(c.run().exit_code, 0);
}

struct BadArea {
  const char* name;
  const char* areas;
  const char* message;
};
void PrintTo(const BadArea& m, std::ostream* out) { *out << m.name; }

class BadForceAreas : public ::testing::TestWithParam<BadArea> {};

TEST_P(BadForceAreas, are_rejected_with_their_place_and_reason) {
  const ForceAreasCase c(GetParam().areas);
  expect_refused(c, c.in_folder(std::string("case.toml:") + GetParam().message));
}

const BadArea mistakes[] = {
    {"an_area_without_criteria", "[forces.areas.a]\neps = 2\n",
     "18: forces.areas.a: found no parts selected, expected at least one of kind, zone, blade, "
     "cone, row, names and part"},
    {"a_zone_that_the_bit_has_not", "[forces.areas.a]\nzone = \"sholder\"\neps = 2\n",
     "18: forces.areas.a: found zone = \"sholder\", which no part of small of %bit.toml meets, "
     "expected one of its zones: cone, nose, shoulder"},
    {"a_blade_that_the_bit_has_not", "[forces.areas.a]\nblade = 3\neps = 2\n",
     "18: forces.areas.a: found blade = 3, which no part of small of %bit.toml meets, expected one "
     "of its blades: 1, 2"},
    {"a_kind_that_the_bit_has_not", "[forces.areas.a]\nkind = \"tooth\"\nratio = 2\n",
     "18: forces.areas.a: found kind = tooth, which no part of small of %bit.toml meets, expected "
     "one of its kinds of part: bit-body, cutter-body, face"},
    {"a_cone_of_a_bit_without_cones", "[forces.areas.a]\ncone = 1\neps = 2\n",
     "18: forces.areas.a: found cone = 1, which no part of small of %bit.toml meets, expected no "
     "cone: the bit has none"},
    {"a_row_of_a_bit_without_rows", "[forces.areas.a]\nrow = 1\neps = 2\n",
     "18: forces.areas.a: found row = 1, which no part of small of %bit.toml meets, expected a row "
     "of a cone of the bit"},
    {"a_misspelt_part", "[forces.areas.a]\npart = \"cutter-3/fac\"\neps = 2\n",
     "18: forces.areas.a: found part = \"cutter-3/fac\", which no part of small of %bit.toml "
     "meets, expected cutter-3/face"},
    {"a_pattern_that_no_part_matches", "[forces.areas.a]\nnames = \"x*\"\neps = 2\n",
     "18: forces.areas.a: found names = \"x*\", which no part of small of %bit.toml meets, "
     "expected "
     "a pattern of part names, as bit.json lists them"},
    {"criteria_that_no_part_meets_together",
     "[forces.areas.a]\nkind = \"bit-body\"\nblade = 1\neps = 2\n",
     "18: forces.areas.a: found kind = bit-body, blade = 1, which no part of small of %bit.toml "
     "meets, expected criteria that one part meets together"},
    {"a_misspelt_kind", "[forces.areas.a]\nkind = \"fase\"\neps = 2\n",
     "19: forces.areas.a.kind: found \"fase\", expected one of face, chamfer, cse, cutter-body, "
     "gage-pad, bit-body, cone, tooth (did you mean face?)"},
    {"a_blade_below_zero", "[forces.areas.a]\nblade = -1\neps = 2\n",
     "19: forces.areas.a.blade: found -1, expected a whole number from 0 to 2147483647"},
    {"a_name_with_a_dot", "[forces.areas.\"a.b\"]\n",
     "18: forces.areas: found an area named \"a.b\", expected names of letters, digits, - and _"},
    {"an_area_that_is_no_table", "[forces.areas]\nx = 3\n",
     "19: forces.areas.x: found 3, expected a table"},
    {"a_law_that_does_not_know_a_part",
     "[forces.areas.a]\nzone = \"nose\"\nlaw = \"friction\"\nstress = 1e6\nmu = 0.1\n",
     "20: forces.areas.a.law: found \"friction\" for cutter-3/face of small of %bit.toml, expected "
     "a law for a face, or criteria without it: the law \"friction\" does not apply to face; it "
     "applies to: "
     "chamfer, cse, cutter body, gage pad, bit body, cone"},
    {"an_unknown_law", "[forces.areas.a]\nzone = \"nose\"\nlaw = \"frictoin\"\n",
     "20: forces.areas.a.law: found \"frictoin\", expected one of none, hanson-hansen, detournay, "
     "depth-of-cut, glowka, thin-cut, friction, indentation (did you mean friction?)"},
    {"a_coefficient_for_parts_of_several_laws", "[forces.areas.a]\nzone = \"nose\"\neps = 3e7\n",
     "18: forces.areas.a.law: found none, and parts of several laws: detournay, friction, expected "
     "a law, or criteria that select parts of one law"},
    {"an_area_that_gives_nothing", "[forces.areas.a]\nkind = \"face\"\nzone = \"nose\"\n",
     "18: forces.areas.a: found neither a law nor a coefficient of the law of its parts, "
     "detournay, "
     "expected law, coefficients, or a coefficient"},
    {"an_area_that_another_one_replaces",
     "[forces.areas.a]\nkind = \"face\"\neps = 3e7\n"
     "[forces.areas.b]\nnames = \"*/face\"\nlaw = \"detournay\"\neps = 3e7\nzeta = 0.5\n",
     "18: forces.areas.a: found coefficients of parts whose laws all come from more specific "
     "areas, expected a law, or the coefficients in those areas"},
    {"a_coefficient_out_of_its_range", "[forces.areas.a]\nkind = \"face\"\neps = \"-2 MPa\"\n",
     "20: forces.areas.a.eps: found \"-2 MPa\", expected pressure in Pa, > 0"},
    {"a_coefficient_of_another_law", "[forces.areas.a]\nkind = \"face\"\nA1 = 2\neps = 3e7\n",
     "20: forces.areas.a.A1: found an unknown key, expected forces.areas.a.eps"},
    {"two_areas_that_disagree",
     "[forces.areas.a]\nkind = \"face\"\nzone = \"nose\"\neps = 2e7\n"
     "[forces.areas.b]\nkind = \"face\"\nzone = \"nose\"\neps = 3e7\n",
     "25: forces.areas.b.eps: found 3e+07 for cutter-3/face, expected 2e+07, as %case.toml:18: "
     "forces.areas.a gives with the same criteria, or a more particular area that decides"},
};

INSTANTIATE_TEST_SUITE_P(One, BadForceAreas, ::testing::ValuesIn(mistakes),
                         [](const auto& m) { return std::string(m.param.name); });

/// Except for the stamp of the rock, which names the case.
TEST(ForceAreasResult, of_all_faces_is_bitwise_that_of_a_table_of_the_kind) {
  const std::string law = "law = \"detournay\"\neps = 4e7\nzeta = 0.5\nmu = 0.3\n";
  const ForceAreasCase c("[forces.face]\n" + law);
  ASSERT_EQ(c.run({}, "by_kind").exit_code, 0);
  c.edit("case.toml", "[forces.face]\n", "[forces.areas.all]\nkind = \"face\"\n");
  ASSERT_EQ(c.run({}, "by_area").exit_code, 0);
  for (const std::string file : {"history.nc", "history.csv"})
    EXPECT_TRUE(read(c.path("by_kind/" + file)) == read(c.path("by_area/" + file))) << file;
  EXPECT_TRUE(read_unstamped(c.path("by_kind/rock_final.ply")) ==
              read_unstamped(c.path("by_area/rock_final.ply")));
}

}  // namespace tdbd::app::bad_areas_test
