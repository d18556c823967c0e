#include "bit/areas/bit_areas.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <numbers>

#include "bit/areas/area_rules.hpp"
#include "bit/bit.hpp"
#include "bit/files/bit_export.hpp"
#include "bit/files/bit_reading.hpp"
#include "bit/files/mesh_bit.hpp"
#include "bit/profile/bit_analysis.hpp"
#include "bit/report/bit_report.hpp"
#include "bit/report/body_report.hpp"
#include "mesh/measures.hpp"

namespace tdbd::bit::bit_areas_test {

const std::string bit_b = TDBD_SOURCE_DIR "/cases/bits/bit-b.toml";
const std::string bit_r = TDBD_SOURCE_DIR "/cases/bits/bit-r.toml";

/// A bit with settings below areas.
Bit with_areas(const std::string& file, const std::vector<std::string>& settings) {
  std::vector<std::string> all;
  for (const std::string& s : settings) all.push_back("areas." + s);
  return read_bit(file, DirectionRule::hybrid, InsideRule::down, Densities::as_given, all).bit;
}

std::string complaint(const std::string& file, const std::vector<std::string>& settings) {
  try {
    with_areas(file, settings);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

/// The mass changes by the volume of the parts that an area selects, times what their density
/// changes by. Relative to the whole mass; a sum of some 150 parts.
void expect_mass_follows(const std::string& file, const std::string& area, double density,
                         const std::function<bool(const Part&)>& selected) {
  constexpr double rounding = 1e-13;
  const Bit plain = with_areas(file, {}), changed = with_areas(file, {area});
  double more = 0.0;
  int parts = 0;
  for (const Part& part : plain.parts)
    if (selected(part) && part.density > 0.0) {
      more += mesh::enclosed_volume(part.mesh_P) * (density - part.density);
      ++parts;
    }
  ASSERT_GT(parts, 0);
  const double before = mass_properties(plain).mass, after = mass_properties(changed).mass;
  EXPECT_NEAR(after, before + more, rounding * before);
  EXPECT_GT(std::abs(after - before), 1e-6 * before);
}

TEST(BitAreas, change_the_mass_by_the_volume_of_their_parts) {
  expect_mass_follows(bit_b, "a={kind='cutter-body', density='10000 kg/m3'}", 10e3,
                      [](const Part& p) { return p.kind == PartKind::cutter_body; });
  expect_mass_follows(bit_r, "a={cone=1, row=2, density='8 g/cm3'}", 8e3,
                      [](const Part& p) { return p.cone == 0 && p.row == 1; });
}

/// The volume of a face is inside its chamfer: it keeps density 0.
/// A material is a density with a name.
TEST(BitAreas, give_materials_by_name) {
  for (const auto& [name, density] :
       {std::pair("steel", 7850.0), std::pair("tungsten-carbide", 14.9e3),
        std::pair("pdc-diamond", 3500.0)}) {
    const Bit named =
                  with_areas(bit_b, {fmt::format("a={{kind='cutter-body', material='{}'}}", name)}),
              given =
                  with_areas(bit_b, {fmt::format("a={{kind='cutter-body', density={}}}", density)});
    EXPECT_EQ(mass_properties(named).mass, mass_properties(given).mass);
    for (const Part& part : named.parts) {
      const bool selected = part.kind == PartKind::cutter_body;
      EXPECT_EQ(part.material, selected ? name : "");
      if (selected) {
        EXPECT_EQ(part.density, density);
      }
    }
    const auto properties = properties_json(named, {});
    EXPECT_EQ(
        std::ranges::count_if(properties, [&](const auto& p) { return p.contains("material"); }),
        std::ranges::count(named.parts, PartKind::cutter_body, &Part::kind));
    EXPECT_NE(areas_report(named).find(fmt::format("  {}: a\n", name)), std::string::npos);
  }
}

TEST(BitAreas, leave_the_density_of_parts_that_count_elsewhere) {
  const Bit bit = with_areas(bit_b, {"a={zone='nose', density=5000}"});
  for (const Part& part : bit.parts) {
    const bool selected = zone_of(bit, part) == "nose";
    if (selected && part.kind == PartKind::face) {
      EXPECT_EQ(part.density, 0.0);
    }
    if (selected && part.kind == PartKind::chamfer) {
      EXPECT_EQ(part.density, 5000.0);
    }
    EXPECT_EQ(part.density_area, selected && part.density > 0.0 ? "a" : "");
  }
  EXPECT_EQ(complaint(bit_b, {"a={kind='face', density=5000}"}),
            "bit.set: areas.a.density: found 5000 kg/m3 for cutter-1/face, whose volume counts "
            "elsewhere, expected criteria that select a part with a density");
}

TEST(BitAreas, determine_whether_parts_cut_and_when) {
  const Bit bit = with_areas(
      bit_b, {"pads={kind='gage-pad'}", "pads.removal={cutting='rubs', from_depth='2 m'}",
              "first={names='cutter-1/*'}", "first.removal.from_time='3 s'"});
  for (const Part& part : bit.parts) {
    if (part.kind == PartKind::gage_pad) {
      ASSERT_TRUE(part.start);
      EXPECT_EQ(part.start->event, StartEvent::depth);
      EXPECT_EQ(part.start->from, 2.0);
      EXPECT_EQ(part.start->then, Cutting::rubs);
      EXPECT_EQ(part.cutting, Cutting::never);
    } else if (part.cutter == 0) {
      ASSERT_TRUE(part.start);
      EXPECT_EQ(part.start->event, StartEvent::time);
      EXPECT_EQ(part.start->from, 3.0);
      EXPECT_EQ(part.start->then, Cutting::cuts);
      EXPECT_EQ(part.start_area, "first");
    } else {
      EXPECT_FALSE(part.start) << part.name;
    }
  }
}

/// The exported bit contains the settings of all areas.
TEST(BitAreas, are_in_the_exported_bit) {
  const std::vector<std::string> of_b{"pads={kind='gage-pad', density=7000}",
                                      "pads.removal={cutting='rubs', from_depth='2 m'}",
                                      "first={names='cutter-1/*', density=3000}",
                                      "first.removal.from_time='3 s'",
                                      "worn={names='cutter-2/*'}",
                                      "worn.removal={from_wear='1 mm', worn_names='cutter-5/*'}",
                                      "some={zone='shoulder'}",
                                      "some.removal.share=0.5"},
      of_r{"teeth={row=1, density=9000}",
           "hard={row=2}",
           "hard.removal.share=0.75",
           "teeth.removal.cutting=no",
           "cone={part='cone-2/row-2/tooth-3'}",
           "cone.removal.from_depth=1"};
  for (const auto& [file, settings] : {std::pair(bit_b, of_b), std::pair(bit_r, of_r)}) {
    const std::filesystem::path folder = test_folder();
    const Bit bit = with_areas(file, settings);
    export_bit(folder, bit, {.parts = "ply"});
    const Bit again = read((folder / "bit.toml").string());
    ASSERT_EQ(bit.parts.size(), again.parts.size());
    int waits = 0, shares = 0;
    for (std::size_t i = 0; i < bit.parts.size(); ++i) {
      const Part &p = bit.parts[i], &q = again.parts[i];
      EXPECT_EQ(p.density, q.density) << p.name;
      EXPECT_EQ(p.cutting, q.cutting) << p.name;
      EXPECT_EQ(p.share, q.share) << p.name;
      shares += p.share < 1.0;
      ASSERT_EQ(p.start.has_value(), q.start.has_value()) << p.name;
      if (!p.start) continue;
      ++waits;
      EXPECT_EQ(p.start->event, q.start->event);
      EXPECT_EQ(p.start->from, q.start->from);
      EXPECT_EQ(p.start->then, q.start->then);
      EXPECT_EQ(p.start->worn_names, q.start->worn_names);
    }
    EXPECT_GT(waits, 0);
    EXPECT_GT(shares, 0);
  }
}

TEST(BitAreas, give_shares_and_starts_by_wear) {
  const Bit bit = with_areas(
      bit_b, {"some={zone='shoulder'}", "some.removal.share=0.5", "worn={names='cutter-1/*'}",
              "worn.removal={from_wear='1.5 mm', worn_names='cutter-2/*'}"});
  for (const Part& part : bit.parts) {
    const bool some = zone_of(bit, part) == "shoulder";
    EXPECT_EQ(part.share, some ? 0.5 : 1.0) << part.name;
    EXPECT_EQ(part.share_area, some ? "some" : "");
    ASSERT_EQ(part.start.has_value(), part.cutter == 0) << part.name;
    if (!part.start) continue;
    EXPECT_EQ(part.start->event, StartEvent::wear);
    EXPECT_EQ(part.start->from, 1.5e-3);
    EXPECT_EQ(part.start->worn_names, "cutter-2/*");
  }
  EXPECT_EQ(complaint(bit_r, {"late={kind='tooth'}", "late.removal.from_wear='1 mm'"}),
            "bit.set: areas.late.removal.from_wear: found a bit without cutters, expected cutters, "
            "which wear");
}

/// What an area turns off, or what starts later, is in no analysis before drilling.
TEST(BitAreas, leave_what_does_not_cut_from_the_start_out_of_the_analysis) {
  const Bit plain = read(bit_b),
            bit = with_areas(bit_b,
                             {"off={zone='gage', kind='face'}", "off.removal.cutting=no",
                              "off2={zone='gage', kind='chamfer'}", "off2.removal.cutting=no",
                              "off3={zone='gage', kind='cutter-body'}", "off3.removal.cutting=no",
                              "pads={kind='gage-pad'}", "pads.removal.cutting=no",
                              "late={names='cutter-3/*'}", "late.removal.from_depth='1 m'"});
  const std::vector<int> counted = cutting_at_start(bit);
  EXPECT_EQ(cutting_at_start(plain).size(), plain.cutters.size());
  for (std::size_t i = 0; i < bit.cutters.size(); ++i)
    EXPECT_EQ(std::ranges::binary_search(counted, static_cast<int>(i)),
              bit.cutters[i].zone != "gage" && bit.cutters[i].id != 3)
        << bit.cutters[i].id;
  EXPECT_EQ(bit.gage_radius, largest_radius(bit.parts));
  EXPECT_LT(bit.gage_radius, plain.gage_radius);
  const auto analysis = nlohmann::json::parse(analysis_json(bit, {}));
  double volume = 0.0;
  for (const auto& c : analysis["cutters"]) {
    volume += c["volume_m3_per_rev"].get<double>();
    if (c.contains("counted")) {
      EXPECT_EQ(c["area_m2"], 0.0);
      EXPECT_TRUE(c["exposure_m"].is_null());
    }
  }
  const double advance = analysis["penetration_m_per_rev"];
  EXPECT_NEAR(volume / (std::numbers::pi * bit.gage_radius * bit.gage_radius * advance), 1.0, 2e-3);
  EXPECT_NE(
      areas_report(bit).find("leaves out what does not cut from the start: cutter-3, cutter-"),
      std::string::npos)
      << areas_report(bit);
}

TEST(BitAreas, that_turn_off_every_part_are_rejected) {
  EXPECT_EQ(complaint(bit_b, {"all.names='*'", "all.removal.cutting=no"}),
            bit_b + ":1: areas: found no part that cuts, expected at least one");
}

}  // namespace tdbd::bit::bit_areas_test
