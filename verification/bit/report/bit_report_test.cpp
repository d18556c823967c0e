#include "bit/report/bit_report.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bit/bit.hpp"
#include "bit/body/bit_body.hpp"
#include "bit/cutter/cutter.hpp"
#include "bit/files/bit_reading.hpp"
#include "bit/files/mesh_bit.hpp"
#include "bit/generate.hpp"
#include "bit/profile/bit_analysis.hpp"
#include "bit/profile/exposure_profile.hpp"
#include "bit/report/bit_facts.hpp"
#include "bit/report/bit_output.hpp"
#include "bit/report/body_report.hpp"
#include "bit/report/cone_report.hpp"
#include "core/read_file.hpp"
#include "mesh/measures.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::bit::bit_report_test {

nlohmann::json analysis_of(const Bit& bit) {
  const std::filesystem::path folder = test_folder();
  write_analysis(folder, bit, {});
  return nlohmann::json::parse(std::ifstream(folder / "analysis.json"));
}

Vec3 vector_of(const nlohmann::json& j) {
  return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()};
}

/// Three cutters of bit B, of which no two have a number in common.
std::vector<Cutter> three_cutters() {
  std::vector<Cutter> three = table('b');
  three.resize(3);
  for (std::size_t k = 0; k < three.size(); ++k) {
    three[k].under_exposure = 1e-4 * static_cast<double>(k + 1);
    three[k].wear = 3e-4 * static_cast<double>(k + 1);
    three[k].side_rake = 0.02 * static_cast<double>(k + 1);
    three[k].diameter -= 1e-3 * static_cast<double>(k);
    three[k].X_BC = cutter_pose(three[k]);
  }
  return three;
}

TEST(BitReport, has_the_axes_of_every_cutter) {
  const Bit bit = pdc_bit("three", three_cutters(), {});
  const nlohmann::json cutters = analysis_of(bit).at("cutters");
  ASSERT_EQ(cutters.size(), bit.cutters.size());
  for (std::size_t k = 0; k < bit.cutters.size(); ++k) {
    const Pose& X_BC = bit.cutters[k].X_BC;
    EXPECT_EQ(vector_of(cutters[k].at("face_centre_m")), X_BC.p);
    EXPECT_EQ(vector_of(cutters[k].at("x_axis")), X_BC.R.col(0));
    EXPECT_EQ(vector_of(cutters[k].at("y_axis")), X_BC.R.col(1));
    EXPECT_EQ(vector_of(cutters[k].at("z_axis")), X_BC.R.col(2));
    EXPECT_EQ(vector_of(cutters[k].at("tip_m")), tip_B(bit.cutters[k]));
    EXPECT_EQ(vector_of(cutters[k].at("profile_normal")), profile_normal_B(bit.cutters[k]));
  }
}

/// Each number of a cutter's row in the table under its own key.
TEST(BitReport, has_every_number_of_every_cutter) {
  const Bit bit = pdc_bit("three", three_cutters(), {});
  const nlohmann::json cutters = analysis_of(bit).at("cutters");
  const std::vector<std::pair<const char*, double Cutter::*>> keys{
      {"diameter_m", &Cutter::diameter},
      {"tip_radius_m", &Cutter::tip_radius},
      {"tip_height_m", &Cutter::tip_height},
      {"azimuth_rad", &Cutter::azimuth},
      {"profile_angle_rad", &Cutter::profile_angle},
      {"back_rake_rad", &Cutter::back_rake},
      {"side_rake_rad", &Cutter::side_rake},
      {"under_exposure_m", &Cutter::under_exposure},
      {"wear_m", &Cutter::wear}};
  for (std::size_t k = 0; k < bit.cutters.size(); ++k) {
    const Cutter& c = bit.cutters[k];
    for (const auto& [key, number] : keys) EXPECT_EQ(cutters[k].at(key), c.*number) << key;
    EXPECT_EQ(cutters[k].at("name"), "cutter-" + std::to_string(c.id));
    EXPECT_EQ(cutters[k].at("blade"), c.blade);
    EXPECT_EQ(cutters[k].at("zone"), c.zone);
    const std::vector<Vec3> outline = turned_outline(c, 72);
    ASSERT_EQ(cutters[k].at("outline_rz_m").size(), outline.size());
    for (std::size_t i = 0; i < outline.size(); ++i) {
      EXPECT_EQ(cutters[k].at("outline_rz_m")[i].at(0), outline[i].x());
      EXPECT_EQ(cutters[k].at("outline_rz_m")[i].at(1), outline[i].z());
    }
  }
}

const Bit& bit_b() {
  static const Bit bit = read(TDBD_SOURCE_DIR "/cases/bits/bit-b.toml");
  return bit;
}

/// At a penetration of 3 mm.
const nlohmann::json& analysis_of_b() {
  static const nlohmann::json json = [] {
    ReportOptions options;
    options.advance = 3e-3;
    return nlohmann::json::parse(analysis_json(bit_b(), options));
  }();
  return json;
}

void expect_number(const nlohmann::json& found, double expected) {
  if (std::isnan(expected))
    EXPECT_TRUE(found.is_null());
  else
    EXPECT_EQ(found, expected);
}

/// What the cutters do together, at the requested penetration.
TEST(BitReport, has_what_the_cutters_share) {
  const Bit& bit = bit_b();
  const nlohmann::json& a = analysis_of_b();
  const Engagement e = engagement(bit.cutters, 3e-3, report_column_width);
  const std::vector<double> overlap = overlaps(bit.cutters), exposure = exposures(bit.cutters);
  ASSERT_EQ(a.at("cutters").size(), bit.cutters.size());
  for (std::size_t k = 0; k < bit.cutters.size(); ++k) {
    const nlohmann::json& cutter = a.at("cutters")[k];
    EXPECT_EQ(cutter.at("area_m2"), e.area[k]);
    EXPECT_EQ(cutter.at("volume_m3_per_rev"), e.volume[k]);
    expect_number(cutter.at("overlap_with_next"), overlap[k]);
    expect_number(cutter.at("exposure_m"), exposure[k]);
  }
  EXPECT_EQ(a.at("penetration_m_per_rev"), 3e-3);
  EXPECT_EQ(a.at("imbalance_of_unit_law"), imbalance(bit.cutters, e.area));
  EXPECT_EQ(vector_of(a.at("imbalance_vector_of_unit_law")), imbalance_vector(bit.cutters, e.area));
  EXPECT_EQ(a.at("mean_redundancy"), mean_redundancy(e.cutting));
  EXPECT_EQ(a.at("column_width_m"), e.column_width);
  EXPECT_EQ(a.at("cutters_cutting_at_radius"), e.cutting);
  EXPECT_EQ(a.at("cutters_in_body_m3"), cutters_in_body(bit));
}

TEST(BitReport, has_both_parts_of_the_balance) {
  const Bit bit = read(TDBD_SOURCE_DIR "/cases/bits/bit-b.toml");
  const ReportOptions options;
  const nlohmann::json found = nlohmann::json::parse(analysis_json(bit, options)).at("balance");
  const Engagement e = engagement(bit.cutters, options.advance, report_column_width);
  constexpr double rounding = 1e-14;
  EXPECT_NEAR(found.at("planar_over_weight").get<double>(),
              planar_imbalance(bit.cutters, e.area, report_normal_ratio), rounding);
  const Vec3 normal = vector_of(found.at("normal_part_vector_over_weight")),
             drag = vector_of(found.at("drag_part_vector_over_weight"));
  EXPECT_NEAR((vector_of(found.at("planar_vector_over_weight")) - normal - drag).norm(), 0.0,
              rounding);
  EXPECT_EQ(found.at("normal_part_over_weight"), normal.norm());
}

TEST(BitFacts, fit_on_a_screen_for_every_kind_of_bit) {
  for (const char* name : {"bit-a", "bit-c", "generated", "bit-r", "single-tooth", "outside"}) {
    const std::string text =
        facts_text(read(fmt::format(TDBD_SOURCE_DIR "/cases/bits/{}.toml", name)), 5e-3);
    EXPECT_LE(std::ranges::count(text, '\n'), 30) << text;
    EXPECT_NE(text.find(name), std::string::npos) << text;
  }
}

TEST(BitFacts, state_what_each_imbalance_is) {
  const std::string text = facts_text(read(TDBD_SOURCE_DIR "/cases/bits/bit-b.toml"), 5e-3);
  for (const char* words : {"28 cutters", "8.5 in across", "blades (number, cutters): 1 6, 2 5",
                            "zones (name, cutters): cone 8", "lateral force over the weight on bit",
                            "1.20 %  of the normal forces", "6.78 %  of the drag",
                            "6.87 %  of both (planar model", "A run (tdbd run) includes them"})
    EXPECT_NE(text.find(words), std::string::npos) << words << " is not in " << text;
}

TEST(BitReport, has_the_mass_and_every_part) {
  const Bit& bit = bit_b();
  const nlohmann::json& a = analysis_of_b();
  const MassProperties mass = mass_properties(bit);
  EXPECT_EQ(a.at("schema"), 1);
  EXPECT_EQ(a.at("name"), bit.name);
  EXPECT_EQ(a.at("gage_radius_m"), bit.gage_radius);
  EXPECT_EQ(a.at("mass_kg"), mass.mass);
  EXPECT_EQ(vector_of(a.at("centre_m")), mass.centre);
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(vector_of(a.at("inertia_kg_m2").at(static_cast<std::size_t>(i))),
              Vec3(mass.inertia.row(i)));
  ASSERT_EQ(a.at("parts").size(), bit.parts.size());
  for (std::size_t k = 0; k < bit.parts.size(); ++k) {
    const Part& p = bit.parts[k];
    const nlohmann::json& found = a.at("parts")[k];
    EXPECT_EQ(found.at("name"), p.name);
    EXPECT_EQ(found.at("kind"), kind_name(p.kind));
    EXPECT_EQ(found.at("cuts"), p.cutting == Cutting::cuts);
    EXPECT_EQ(found.at("cutter"), p.cutter);
    EXPECT_EQ(found.at("cone"), p.cone);
    EXPECT_EQ(found.at("volume_m3"), mesh::enclosed_volume(p.mesh_P));
    EXPECT_EQ(found.at("density_kg_m3"), p.density);
    EXPECT_EQ(vector_of(found.at("origin_m")), p.X_BP.p);
    EXPECT_EQ(vector_of(found.at("update_direction")), p.update_direction_B);
  }
}

/// The profile of the body is what it would touch if it cut; a shank above cones has none.
TEST(BitReport, has_the_profile_of_a_body_below_no_cones) {
  const Bit& bit = bit_b();
  std::vector<Part> body;
  for (const Part& p : bit.parts)
    if (p.kind == PartKind::bit_body) body.push_back(p);
  ASSERT_FALSE(body.empty());
  for (Part& p : body) p.cutting = Cutting::cuts;
  const std::vector<ProfilePoint> profile = exposure_profile(body, 1e-3);
  const nlohmann::json found = analysis_of_b().at("body_profile_rz_m");
  ASSERT_EQ(found.size(), profile.size());
  for (std::size_t k = 0; k < profile.size(); ++k) {
    EXPECT_EQ(found[k].at(0), profile[k].r);
    EXPECT_EQ(found[k].at(1), profile[k].z);
  }
  Bit bare = pdc_bit("three", three_cutters(), {});
  std::erase_if(bare.parts, [](const Part& p) { return p.kind == PartKind::bit_body; });
  EXPECT_FALSE(analysis_of(bare).contains("body_profile_rz_m"));
  EXPECT_FALSE(
      analysis_of(read(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml")).contains("body_profile_rz_m"));
}

/// "body" is of blades, and absent without them.
TEST(BitReport, has_a_body_where_the_bit_has_blades) {
  PdcOptions options;
  options.blades.emplace().edge = 12e-3;
  const Bit with = pdc_bit("bladed", table('b'), options);
  ASSERT_TRUE(with.blades);
  EXPECT_EQ(analysis_of(with).at("body"), nlohmann::json(body_json(with, ReportOptions{}.advance)));
  EXPECT_FALSE(analysis_of(pdc_bit("three", three_cutters(), {})).contains("body"));
}

/// Cones with their rows, their tracking and what is assumed of them; none of a bit without.
TEST(BitReport, has_cones_where_the_bit_has_some) {
  const Bit bit = read(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml");
  const nlohmann::json a = analysis_of(bit);
  ASSERT_EQ(a.at("cones").size(), bit.cones.size());
  EXPECT_EQ(a.at("cones")[0].at("rows").size(), bit.cones[0].layout.rows.size());
  EXPECT_TRUE(a.contains("tracking"));
  EXPECT_TRUE(a.at("cones")[0].contains("assumptions"));
  EXPECT_FALSE(a.contains("cutters_in_body_m3"));
  const nlohmann::json without = analysis_of(pdc_bit("three", three_cutters(), {}));
  EXPECT_FALSE(without.contains("cones"));
  EXPECT_FALSE(without.contains("clearances"));
  EXPECT_FALSE(without.contains("tracking"));
}

nlohmann::json bit_json(const Bit& bit) {
  const std::filesystem::path folder = test_folder();
  write_bit_files(folder, bit);
  return nlohmann::json::parse(read_file(folder / "bit.json", "a bit"));
}

/// Each number of a cutter under its own key; cones where there are some.
TEST(BitJson, has_every_number_of_every_cutter) {
  std::vector<Cutter> three = table('b');
  three.resize(3);
  for (Cutter& c : three) c.side_rake = 0.02 * c.id;
  const Bit bit = pdc_bit("three", three, {});
  const nlohmann::json found = bit_json(bit);
  EXPECT_EQ(found.at("schema"), 1);
  EXPECT_EQ(found.at("name"), "three");
  EXPECT_EQ(found.at("gage_radius_m"), bit.gage_radius);
  EXPECT_FALSE(found.contains("cones"));
  const std::vector<std::pair<const char*, double Cutter::*>> keys{
      {"tip_radius_m", &Cutter::tip_radius}, {"azimuth_rad", &Cutter::azimuth},
      {"tip_height_m", &Cutter::tip_height}, {"profile_angle_rad", &Cutter::profile_angle},
      {"back_rake_rad", &Cutter::back_rake}, {"side_rake_rad", &Cutter::side_rake},
      {"diameter_m", &Cutter::diameter},     {"chamfer_m", &Cutter::chamfer}};
  ASSERT_EQ(found.at("cutters").size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    const nlohmann::json& cutter = found.at("cutters")[k];
    for (const auto& [key, number] : keys) EXPECT_EQ(cutter.at(key), bit.cutters[k].*number) << key;
    EXPECT_EQ(cutter.at("name"), "cutter-" + std::to_string(bit.cutters[k].id));
    EXPECT_EQ(cutter.at("blade"), bit.cutters[k].blade);
    EXPECT_EQ(cutter.at("zone"), bit.cutters[k].zone);
  }
}

TEST(BitJson, has_the_cones_of_a_bit_with_some) {
  const Bit bit = read(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml");
  const nlohmann::json found = bit_json(bit);
  EXPECT_EQ(found.at("cones"), nlohmann::json(cones_json(bit)));
  EXPECT_EQ(found.at("cutters").size(), 0U);
}

/// Three boxes apart, of which the second and third belong to a cutter and a cone.
Bit boxes() {
  Bit bit;
  for (int i = 0; i < 3; ++i) {
    Part& part = bit.parts.emplace_back();
    part.name = "box-" + std::to_string(i + 1);
    part.mesh_P = battery::box({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0});
    part.X_BP.p = Vec3(3.0 * i, 0.0, 0.0);
    part.density = 1.0;
  }
  bit.parts[1].kind = PartKind::face;
  bit.parts[1].cutter = 7;
  bit.parts[2].kind = PartKind::cone;
  bit.parts[2].cone = 0;
  return bit;
}

TEST(MergedMesh, has_every_part_in_its_place_and_the_part_of_each_triangle) {
  const Bit bit = boxes();
  const Pose X_WB{Eigen::AngleAxisd(0.7, Vec3(0.6, 0.0, 0.8)).toRotationMatrix(), Vec3(1, 2, 3)};
  std::vector<int> owner;
  const mesh::TriangleMesh all = merged_mesh(bit, X_WB, &owner);
  ASSERT_EQ(owner.size(), all.triangles.size());
  std::size_t t = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (const mesh::Triangle& own : bit.parts[i].mesh_P.triangles) {
      EXPECT_EQ(owner[t], static_cast<int>(i));
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 place = X_WB * (bit.parts[i].X_BP *
                                   bit.parts[i].mesh_P.positions[static_cast<std::size_t>(own[k])]);
        EXPECT_EQ(all.positions[static_cast<std::size_t>(all.triangles[t][k])], place);
      }
      ++t;
    }
  EXPECT_EQ(t, all.triangles.size());
  EXPECT_EQ(merged_mesh(bit, X_WB, nullptr).triangles, all.triangles);
}

/// Part, kind and cutter of every triangle; the cone where the bit has some. Small whole numbers fill their bytes.
TEST(BitVtp, names_the_fields_of_its_triangles) {
  Bit bit = boxes();
  const std::filesystem::path file = test_folder() / "bit.vtp";
  const auto text = [&] {
    write_bit_vtp(file, bit, Pose{});
    return read_file(file, "a bit");
  };
  const std::string without = text();
  for (const char* name : {"\"part\"", "\"kind\"", "\"cutter\""})
    EXPECT_NE(without.find(name), std::string::npos) << name;
  EXPECT_EQ(without.find("\"cone\""), std::string::npos);
  bit.cones.emplace_back();
  EXPECT_NE(text().find("\"cone\""), std::string::npos);
}

/// A part inside another is named with what encloses it, if both are weighed.
TEST(EnclosedText, names_what_lies_inside_what) {
  Bit bit = boxes();
  EXPECT_EQ(enclosed_text(bit), "");
  bit.parts[1].mesh_P = battery::box({0.2, 0.2, 0.2}, {0.8, 0.8, 0.8});
  bit.parts[1].X_BP.p.setZero();
  EXPECT_EQ(enclosed_text(bit),
            "warning: box-2 lies inside box-1, so its volume counts twice in the mass\n");
  bit.parts[0].density = 0.0;
  EXPECT_EQ(enclosed_text(bit), "");
}

}  // namespace tdbd::bit::bit_report_test
