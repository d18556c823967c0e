#include "bit/files/design_file.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "bit/files/bit_export.hpp"
#include "bit/files/bit_reading.hpp"
#include "bit/files/mesh_bit.hpp"
#include "core/error.hpp"

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

TEST(DesignFile, refuses_a_key_that_means_nothing) {
  const std::string message = message_after("spiral = ", "spirale = ");
  EXPECT_EQ(message.rfind("design.spirale: ", 0), 0u) << message;
}

}  // namespace tdbd::bit::design_file_test
