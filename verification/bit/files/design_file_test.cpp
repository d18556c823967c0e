#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <vector>

#include "bit/files/bit_export.hpp"
#include "bit/files/bit_reading.hpp"
#include "bit/files/mesh_bit.hpp"
#include "bit/files/pdc_file.hpp"
#include "bit/report/body_report.hpp"
#include "core/error.hpp"
#include "mesh/check/check.hpp"

namespace tdbd::bit::design_file_test {

namespace fs = std::filesystem;

const std::string generated = TDBD_SOURCE_DIR "/cases/bits/generated.toml";

std::string text_of(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// The message of the generated bit after an edit, from the line's number on.
std::string message_after(const std::string& from, const std::string& to) {
  std::string text = text_of(generated);
  const auto place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  const std::string file =
      write_file(test_folder() / "bit.toml", text.replace(place, from.size(), to));
  try {
    read(file);
  } catch (const InputError& e) {
    const std::string message = e.what();
    EXPECT_EQ(message.rfind(file + ":", 0), 0u) << message;
    return message.substr(message.find(": ", file.size()) + 2);
  }
  return "";
}

TEST(DesignFile, gives_a_bit_of_its_gage) {
  const Bit b = read(generated);
  EXPECT_EQ(b.cutters.size(), 61u);
  EXPECT_NEAR(b.gage_radius, 107.95e-3, 1e-15);
  EXPECT_EQ(b.parts.size(), 61u * 3 + 6 + 1);
}

/// The same cutters and the same meshes, to the last bit, from the table that was written.
TEST(DesignFile, writes_a_table_that_gives_the_same_bit) {
  const fs::path folder = test_folder();
  const Bit original = read(generated);
  write_cutter_table(folder, original);
  const std::string text = text_of(generated);
  std::string with_table = text.substr(0, text.find("[design]"));
  with_table.insert(with_table.find("gage_diameter"), "table = \"cutters.csv\"\n");
  const Bit again = read(write_file(folder / "bit.toml", with_table));
  ASSERT_EQ(original.parts.size(), again.parts.size());
  for (std::size_t k = 0; k < original.parts.size(); ++k) {
    const Part &p = original.parts[k], &q = again.parts[k];
    EXPECT_EQ(p.name, q.name);
    EXPECT_EQ(p.mesh_P.positions, q.mesh_P.positions) << p.name;
    EXPECT_EQ(p.X_BP.p, q.X_BP.p) << p.name;
    EXPECT_EQ(p.X_BP.R, q.X_BP.R) << p.name;
  }
}

TEST(DesignFile, takes_the_shoulders_radius_instead_of_its_angle) {
  const std::string radius = "shoulder_radius = \"47.3 mm\"";
  EXPECT_EQ(message_after("shoulder_angle = \"35 deg\"", radius), "");
  EXPECT_EQ(message_after("shoulder_angle = \"35 deg\"", "shoulder_radius = \"40 mm\""),
            "design.profile.shoulder_radius: found 40 mm, no arc between nose and gage, expected "
            "at least 41.95 mm, what nose_place leaves to the gage");
  EXPECT_EQ(
      message_after("shoulder_angle", radius + "\nshoulder_angle"),
      "design.profile.shoulder_angle: found shoulder_radius as well, expected one of the two");
}

TEST(DesignFile, names_key_value_and_place_of_what_is_impossible) {
  EXPECT_EQ(message_after("nose_place = \"66 mm\"", "nose_place = \"166 mm\""),
            "design.profile.nose_place: found 166 mm from the axis, expected a nose between the "
            "axis and the gage at 107.95 mm");
  EXPECT_EQ(message_after("cone = \"13.44 mm\"", "cone = \"-13.44 mm\"").substr(0, 28),
            "design.diameter.cone: found ");
  EXPECT_EQ(message_after("behind = \"22 mm\"", "behind = \"5 mm\""),
            "design.backup.behind: found cutter 39 (cone, blade 2, radius 49.3297 mm) overlapping "
            "cutter 10 (cone, blade 2, radius 48.8662 mm), expected 0.5 mm of clearance");
  EXPECT_EQ(message_after("gage_diameter = \"8.5 in\"\n", ""),
            "gage_diameter: found nothing, expected length in m, in (0, 10] (the key is required)");
  EXPECT_EQ(message_after("gage_diameter", "table = \"cutters.csv\"\ngage_diameter"),
            "table: found design as well, expected one of the two");
}

TEST(DesignFile, rejects_a_key_without_effect) {
  const std::string message = message_after("spiral = ", "spirale = ");
  EXPECT_EQ(message.rfind("design.spirale: ", 0), 0u) << message;
}

constexpr const char* plain = "exposure = \"5 mm\"\nslot_depth = \"16 mm\"\n";

/// Bit B with a table [blades] of these lines; [blades] is in line 5.
std::string write_bit(const std::string& blades) {
  return write_file(test_folder() / "bit.toml",
                    "name = \"b\"\ntable = \"" TDBD_SOURCE_DIR
                    "/cases/bits/bit-b.csv\"\ngage_diameter = \"8.5 in\"\n\n[blades]\n" +
                        blades);
}

std::string message_of(const std::string& blades) {
  try {
    read(write_bit(blades));
  } catch (const InputError& e) {
    const std::string message = e.what();
    return message.substr(message.find("bit.toml:"));
  }
  return "";
}

TEST(BladeFile, gives_a_table_bit_blades_that_rub) {
  const Bit b = read(write_bit(plain));
  const Part& body = b.parts.back();
  EXPECT_EQ(body.name, "bit-body");
  EXPECT_EQ(body.cutting, Cutting::rubs);
  EXPECT_TRUE(mesh::check_closed(body.mesh_P).empty());
  ASSERT_TRUE(b.blades.has_value());
  EXPECT_EQ(b.blades->exposure, 5e-3);
  EXPECT_GT(b.blades->junk_slot_area, 3e-3);
  EXPECT_EQ(read(write_bit(std::string(plain) + "rubs = false")).parts.back().cutting,
            Cutting::never);
  EXPECT_EQ(read(write_bit(std::string(plain) + "cuts = true")).parts.back().cutting,
            Cutting::cuts);
}

TEST(BladeFile, takes_every_key) {
  struct Given {
    const char* key;
    double BladeOptions::*member;
    double value;
  };
  const std::vector<Given> all{{"exposure", &BladeOptions::exposure, 0.1875},
                               {"slot_depth", &BladeOptions::slot_depth, 0.25},
                               {"width", &BladeOptions::width, 0.3125},
                               {"wall", &BladeOptions::wall, 0.375},
                               {"gage_length", &BladeOptions::gage_length, 0.4375},
                               {"neck", &BladeOptions::neck, 0.5},
                               {"shank_radius", &BladeOptions::shank_radius, 0.5625},
                               {"shank_length", &BladeOptions::shank_length, 0.625},
                               {"edge", &BladeOptions::edge, 0.0078125},
                               {"density", &BladeOptions::density, 0.75}};
  std::string text = "[blades]\n";
  for (const Given& g : all) text += fmt::format("{} = {}\n", g.key, g.value);
  Config c = Config::read_text(text, "bit.toml");
  const std::optional<BladeOptions> b = read_blades(c);
  c.finish();
  ASSERT_TRUE(b);
  for (const Given& g : all) EXPECT_EQ(*b.*g.member, g.value) << g.key;
}

TEST(BladeFile, meshes_the_body_with_the_requested_edge_length) {
  const auto facets = [](const char* edge) {
    return read(write_bit(std::string(plain) + edge)).parts.back().mesh_P.triangles.size();
  };
  EXPECT_EQ(facets("edge = \"4 mm\""), facets(""));
  EXPECT_GT(facets("edge = \"4 mm\""), 2 * facets("edge = \"8 mm\""));
}

/// A body that rubs is none of the parts that cut: gage and profile are those of the cutters.
TEST(BladeFile, does_not_change_what_cuts) {
  const Bit with = read(write_bit(plain));
  const Bit without = read(TDBD_SOURCE_DIR "/cases/bits/bit-b.toml");
  EXPECT_EQ(with.gage_radius, without.gage_radius);
}

TEST(BladeFile, reports_what_is_impossible_with_its_line) {
  EXPECT_EQ(
      message_of("slot_depth = \"16 mm\""),
      "bit.toml:5: blades.exposure: found nothing, expected length in m, in (0, 10] (the key is "
      "required)");
  const std::string lifted = message_of("slot_depth = \"16 mm\"\nexposure = \"25 mm\"");
  EXPECT_EQ(
      lifted.rfind("bit.toml:7: blades.exposure: found 25 mm, which lifts cutter 1 (blade", 0), 0u)
      << lifted;
  const std::string deep = message_of("slot_depth = \"90 mm\"\nexposure = \"5 mm\"");
  EXPECT_EQ(deep.rfind("bit.toml:6: blades.slot_depth: found 90 mm, a floor that folds", 0), 0u)
      << deep;
  const std::string wide = message_of(std::string(plain) + "width = \"140 mm\"");
  EXPECT_EQ(wide.rfind("bit.toml:8: blades.width: found blades ", 0), 0u) << wide;
}

/// Two sources of a bit: one message, and nothing about keys of the other source.
TEST(BladeFile, two_sources_give_one_message) {
  const auto folder = test_folder();
  const auto message = [&](const std::string& text) {
    try {
      read(write_file(folder / "bit.toml", text));
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  const std::string both = message("name = \"b\"\n[design]\nspiral = 1\n[[parts]]\nname = \"p\"\n");
  EXPECT_EQ(both, (folder / "bit.toml").string() +
                      ":4: parts: found design as well, expected one of the two");
  const std::string cones = message("name = \"b\"\ntable = \"x.csv\"\n[[cones]]\nazimuth = 1\n");
  EXPECT_EQ(std::count(cones.begin(), cones.end(), '\n'), 0) << cones;
}

/// A file that weighs one part weighs them all.
TEST(BladeFile, a_forgotten_density_is_named) {
  const auto folder = test_folder();
  export_bit(folder, read(TDBD_SOURCE_DIR "/cases/bits/bit-b.toml"), {.parts = "ply"});
  std::ifstream in(folder / "bit.toml");
  std::string text((std::istreambuf_iterator<char>(in)), {});
  const auto at = text.find("density");
  text.erase(at, text.find('\n', at) - at);
  try {
    read(write_file(folder / "bit.toml", text));
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("parts[0].density: found none for cutter-1/face"),
              std::string::npos)
        << e.what();
  }
}

TEST(BladeFile, written_out_still_rubs) {
  const auto folder = test_folder() / "out";
  const Bit b = read(write_bit(plain));
  export_bit(folder, b, {.parts = "ply"});
  EXPECT_EQ(read(folder / "bit.toml").parts.back().cutting, Cutting::rubs);
}

TEST(BladeFile, is_reported_with_units) {
  const Bit b = read(write_bit(plain));
  const auto json = body_json(b, 5e-3);
  EXPECT_EQ(json["exposure_m"], 5e-3);
  EXPECT_GT(json["touches_at_m_per_rev"].get<double>(), 3e-3);
  EXPECT_NE(body_text(b, 5e-3).find("it touches the rock from"), std::string::npos);
}

}  // namespace tdbd::bit::design_file_test
