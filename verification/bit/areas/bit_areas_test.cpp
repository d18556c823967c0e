#include "bit/areas/bit_areas.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "bit/areas/area_rules.hpp"
#include "bit/files/bit_export.hpp"
#include "bit/files/bit_reading.hpp"
#include "bit/files/mesh_bit.hpp"
#include "bit/mass_properties.hpp"
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

TEST(BitAreas, say_whether_parts_cut_and_when) {
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

/// Whatever the areas say of a part, the exported bit says it too.
TEST(BitAreas, are_in_the_exported_bit) {
  const std::vector<std::string> of_b{
      "pads={kind='gage-pad', density=7000}", "pads.removal={cutting='rubs', from_depth='2 m'}",
      "first={names='cutter-1/*', density=3000}", "first.removal.from_time='3 s'"},
      of_r{"teeth={row=1, density=9000}", "teeth.removal.cutting=no",
           "cone={part='cone-2/row-2/tooth-3'}", "cone.removal.from_depth=1"};
  for (const auto& [file, settings] : {std::pair(bit_b, of_b), std::pair(bit_r, of_r)}) {
    const std::filesystem::path folder = test_folder();
    const Bit bit = with_areas(file, settings);
    export_bit(folder, bit, "ply");
    const Bit again = read((folder / "bit.toml").string());
    ASSERT_EQ(bit.parts.size(), again.parts.size());
    int waits = 0;
    for (std::size_t i = 0; i < bit.parts.size(); ++i) {
      const Part &p = bit.parts[i], &q = again.parts[i];
      EXPECT_EQ(p.density, q.density) << p.name;
      EXPECT_EQ(p.cutting, q.cutting) << p.name;
      ASSERT_EQ(p.start.has_value(), q.start.has_value()) << p.name;
      if (!p.start) continue;
      ++waits;
      EXPECT_EQ(p.start->event, q.start->event);
      EXPECT_EQ(p.start->from, q.start->from);
      EXPECT_EQ(p.start->then, q.start->then);
    }
    EXPECT_GT(waits, 0);
  }
}

TEST(BitAreas, that_turn_off_every_part_are_refused) {
  EXPECT_EQ(complaint(bit_b, {"all.names='*'", "all.removal.cutting=no"}),
            bit_b + ":1: areas: found no part that cuts, expected at least one");
}

}  // namespace tdbd::bit::bit_areas_test
