#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.hpp"
#include "simulation/case/case.hpp"
#include "simulation/case/force_settings.hpp"

namespace tdbd::simulation::case_wear_test {
namespace {

Case wearing(std::vector<std::string> settings, const std::string& file = "wear-bit-b") {
  settings.emplace_back("rock.edge_length='4 mm'");
  return read_case(TDBD_SOURCE_DIR "/cases/" + file + ".toml", settings);
}

/// The message of a case with these settings; "none" if it is read.
std::string complaint(const std::vector<std::string>& settings,
                      const std::string& file = "wear-bit-b") {
  try {
    wearing(settings, file);
  } catch (const InputError& e) {
    return e.what();
  }
  return "none";
}

void expect_complaint(const std::vector<std::string>& settings, const std::string& expected,
                      const std::string& file = "wear-bit-b") {
  const std::string found = complaint(settings, file);
  EXPECT_NE(found.find(expected), std::string::npos) << found << "\nexpected: " << expected;
}

TEST(CaseWear, has_the_law_of_the_table_on_all_parts_of_cutters_and_no_other) {
  const Case c = wearing({});
  ASSERT_EQ(c.wear.part_laws.size(), c.bit.parts.size());
  for (std::size_t p = 0; p < c.bit.parts.size(); ++p) {
    const bit::WearLaw expected = c.bit.parts[p].cutter < 0
                                      ? bit::WearLaw{bit::NoWear{}}
                                      : bit::WearLaw{bit::ThermalWear{{1e-5, 50e9}, 623.15, 50.0}};
    EXPECT_EQ(c.wear.part_laws[p], expected) << c.bit.parts[p].name;
  }
}

TEST(CaseWear, does_not_wear_without_the_table) {
  EXPECT_FALSE(wears(wearing({}, "bit-b-3000psi").wear));
}

/// Teeth by the law of the table; gage pads by an area alone.
TEST(CaseWear, has_laws_on_teeth_and_on_pads_of_an_area) {
  const Case teeth =
      wearing({"wear={law='sliding', coefficient=1e-6, hardness='50 GPa'}"}, "drill-bit-m");
  for (std::size_t p = 0; p < teeth.bit.parts.size(); ++p)
    EXPECT_EQ(std::holds_alternative<bit::SlidingWear>(teeth.wear.part_laws[p]),
              teeth.bit.parts[p].kind == bit::PartKind::tooth);
  const Case pads = wearing(
      {"wear.areas.pads={kind='gage-pad', law='sliding', coefficient=1e-6, hardness='9 GPa'}"});
  for (std::size_t p = 0; p < pads.bit.parts.size(); ++p) {
    if (pads.bit.parts[p].kind != bit::PartKind::gage_pad) continue;
    EXPECT_EQ(pads.wear.part_laws[p], (bit::WearLaw{bit::SlidingWear{1e-6, 9e9}}));
  }
}

TEST(CaseWear, areas_decide_by_rank) {
  const Case c = wearing({"wear.areas.faces={kind='face', law='none'}",
                          "wear.areas.nose={zone='nose', kind='face', law='sliding', "
                          "coefficient=2e-6, hardness='40 GPa'}"});
  int none = 0, sliding = 0;
  for (std::size_t p = 0; p < c.bit.parts.size(); ++p) {
    const bit::Part& part = c.bit.parts[p];
    if (part.kind != bit::PartKind::face) continue;
    const bool nose = c.bit.cutters[static_cast<std::size_t>(part.cutter)].zone == "nose";
    const bit::WearLaw expected =
        nose ? bit::WearLaw{bit::SlidingWear{2e-6, 40e9}} : bit::WearLaw{bit::NoWear{}};
    EXPECT_EQ(c.wear.part_laws[p], expected) << part.name;
    ++(nose ? sliding : none);
  }
  EXPECT_GT(none, 0);
  EXPECT_GT(sliding, 0);
}

TEST(CaseWear, rejects_meaningless_values_with_their_key) {
  expect_complaint({"wear.coefficient=-1e-6"}, "wear.coefficient: found -1e-06, expected");
  expect_complaint({"wear.hardness=0"}, "wear.hardness: found 0, expected");
  expect_complaint({"wear.acceleration=-2"}, "wear.acceleration: found -2, expected");
  expect_complaint(
      {"wear.law='table'", "wear.temperatures=[300, 400]", "wear.rates=[1e-17, -1e-17]"},
      "wear.rates: found -1e-17, expected rates, >= 0");
  expect_complaint({"wear.law='table'", "wear.temperatures=[300, 400]", "wear.rates=[1e-17]"},
                   "wear.rates: found 1 rates for 2 temperatures, expected");
  expect_complaint({"wear.law='table'", "wear.temperatures=[400, 300]", "wear.rates=[1, 2]"},
                   "wear.temperatures: found 300 K after 400 K, expected rising temperatures");
  expect_complaint({"wear.law='archard'"}, "wear.law: found \"archard\", expected");
}

/// With the file and the line of the table, which is there.
TEST(CaseWear, rejects_a_thermal_law_without_its_temperature_limit) {
  expect_complaint({"wear={law='thermal', coefficient=1e-6, hardness='50 GPa'}"}, "wear.threshold");
  expect_complaint({"wear={law='sliding', coefficient=1e-6}"}, "wear.hardness");
}

TEST(CaseWear, rejects_bits_and_areas_that_cannot_wear) {
  expect_complaint({"wear={law='sliding', coefficient=1e-6, hardness='50 GPa'}"},
                   "found a bit whose cutters come from meshes, expected a bit with a cutter table",
                   "carbide-edge-bit");
  expect_complaint({"wear={law='sliding', coefficient=1e-6, hardness='50 GPa'}"},
                   "no table [forces]", "bit-b-steady");
  expect_complaint({"wear.areas.body={kind='bit-body', law='none'}"},
                   "found bit-body, which is none of these, expected criteria that select parts of "
                   "cutters, teeth or gage pads");
  expect_complaint({"wear.areas.a={kind='face', law='none'}",
                    "wear.areas.b={kind='face', law='sliding', coefficient=1, hardness=1}"},
                   "wear.areas.b.law");
}

}  // namespace
}  // namespace tdbd::simulation::case_wear_test
