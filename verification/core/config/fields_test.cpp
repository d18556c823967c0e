#include <gtest/gtest.h>

#include "core/config/config.hpp"
#include "core/config/field.hpp"
#include "core/config/key_table.hpp"
#include "core/error.hpp"
#include "core/temporary_file.hpp"

namespace tdbd::fields_test {

enum class Shape { round, square };

std::vector<std::string_view> steels() { return {"mild", "hard"}; }

/// One field of each kind.
struct Chuck {
  double length = 0.5, mass = 0.0;
  std::optional<double> wear;
  Vec3 place = Vec3::UnitZ();
  std::vector<double> angles{1.0};
  Mat3 inertia = Mat3::Identity();
  std::vector<std::pair<double, double>> profile;
  std::vector<std::string> owners;
  long turns = 0;
  int teeth = 3;
  std::uint64_t seed = 1;
  bool open = false;
  std::string label = "none", drawing, steel = "mild";
  Shape shape = Shape::square;
  std::optional<Shape> hole;

  static constexpr TableKey table{"drill.chuck", "a made-up table"};
  void visit(FieldVisitor& v) {
    v(length,
      {.name = "length", .unit = "m", .range = Range::positive(), .meaning = "of the chuck"});
    v(mass, {.name = "mass", .unit = "kg", .need = Need::required, .meaning = "of it"});
    v(wear, {.name = "wear", .unit = "m", .meaning = "of the jaws"});
    v(place, {.name = "place", .unit = "m", .meaning = "in the drill"});
    v(angles,
      {.name = "angles", .unit = "rad", .computed_default = "1 rad", .meaning = "of the jaws"});
    v(inertia,
      {.name = "inertia", .unit = "kg m2", .computed_default = "1", .meaning = "of the chuck"});
    v(profile,
      {.name = "profile", .unit = "m", .computed_default = "none", .meaning = "of the chuck"});
    v(owners, {.name = "owners", .computed_default = "none", .meaning = "by name"});
    v(turns, {.name = "turns",
              .need = Need::optional,
              .computed_default = "not counted",
              .meaning = "so far"});
    v(teeth, {.name = "teeth", .lo = 1, .hi = 9, .meaning = "how many"});
    v(seed, {.name = "seed", .meaning = "of chatter"});
    v(open, {.name = "open", .meaning = "whether it is"});
    v(label, {.name = "label", .meaning = "for the report"});
    v.path(drawing, {.name = "drawing",
                     .need = Need::optional,
                     .computed_default = "none",
                     .meaning = "a file"});
    v.name(
        steel,
        {.name = "steel", .names = &steels, .computed_default = "mild", .meaning = "its material"});
    v(shape, {.name = "shape",
              .values = {{{"round", Shape::round}, {"square", Shape::square}}},
              .meaning = "of the jaws"});
    v(hole, {.name = "hole", .values = {{{"round", Shape::round}}}, .meaning = "of the chuck"});
    v.any(AnyKey{
        .name = "KEY", .kind = "any", .computed_default = "none", .meaning = "of the drill"});
  }
};

Config config_of(const std::string& toml) {
  return Config::read_file(write_temporary(".toml", toml), {});
}

std::string problems_of(const Config& config) {
  try {
    config.finish();
  } catch (const InputError& e) {
    const std::string text = e.what();
    return text.substr(text.find(".toml:") + 6);
  }
  return "";
}

TEST(Fields, have_the_values_that_the_file_gives) {
  Config file = config_of(
      "[drill.chuck]\nlength = \"20 cm\"\nmass = 3\nwear = 0.1\nplace = [1, 2, 3]\nangles = [4, "
      "5]\n"
      "inertia = [[2, 0, 0], [0, 2, 0], [0, 0, 2]]\nprofile = [[1, 2]]\nowners = [\"a\"]\n"
      "turns = 7\nteeth = 5\nseed = 8\nopen = true\nlabel = \"a\"\ndrawing = \".\"\n"
      "steel = \"hard\"\nshape = \"round\"\nhole = \"round\"\n");
  Config drill = file.table("drill");
  const auto c = read_table<Chuck>(drill);
  EXPECT_EQ(problems_of(file), "");
  EXPECT_DOUBLE_EQ(c.length, 0.2);
  EXPECT_EQ(c.mass, 3.0);
  EXPECT_EQ(c.wear, 0.1);
  EXPECT_EQ(c.place, Vec3(1, 2, 3));
  EXPECT_EQ(c.angles, (std::vector<double>{4.0, 5.0}));
  EXPECT_EQ(c.inertia, 2.0 * Mat3::Identity());
  EXPECT_EQ(c.profile.size(), 1u);
  EXPECT_EQ(c.owners, std::vector<std::string>{"a"});
  EXPECT_EQ(c.turns, 7);
  EXPECT_EQ(c.teeth, 5);
  EXPECT_EQ(c.seed, 8u);
  EXPECT_TRUE(c.open);
  EXPECT_EQ(c.label, "a");
  EXPECT_NE(c.drawing, "");
  EXPECT_EQ(c.steel, "hard");
  EXPECT_EQ(c.shape, Shape::round);
  EXPECT_EQ(c.hole, Shape::round);
}

/// The resolved file states the defaults, but no optional key.
TEST(Fields, keep_their_initial_values_where_the_file_gives_none) {
  Config file = config_of("mass = 3\n");
  Chuck c;
  read_fields(file, c);
  EXPECT_EQ(problems_of(file), "");
  EXPECT_EQ(c.length, 0.5);
  EXPECT_FALSE(c.wear.has_value());
  EXPECT_FALSE(c.hole.has_value());
  EXPECT_EQ(c.shape, Shape::square);
  EXPECT_EQ(file.resolved(),
            "angles = [1]  # rad\ninertia = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]  # kg m2\n"
            "label = \"none\"\nlength = 0.5  # m\nmass = 3  # kg\nopen = false\nowners = []\n"
            "place = [0, 0, 1]  # m\nprofile = []  # m\nseed = 1\nshape = \"square\"\n"
            "steel = \"mild\"\nteeth = 3\n");
}

TEST(Fields, that_are_required_are_mistakes_where_the_file_gives_none) {
  Config file = config_of("");
  Chuck c;
  read_fields(file, c);
  EXPECT_EQ(problems_of(file), "1: mass: found nothing, expected mass in kg (the key is required)");
}

TEST(Fields, are_listed_with_their_initial_values_as_defaults) {
  const auto words = [](const KeyRow& r) {
    return r.name + "|" + r.kind + "|" + r.fallback + "|" + r.allowed + "|" + r.meaning;
  };
  const KeyTable table = table_of<Chuck>("run", Chuck::table);
  EXPECT_EQ(table.name, "drill.chuck");
  std::vector<std::string> rows;
  for (const KeyRow& r : table.rows) rows.push_back(words(r));
  EXPECT_EQ(
      rows,
      (std::vector<std::string>{
          "length|m|0.5 m|> 0|of the chuck", "mass|kg|required||of it", "wear|m|none||of the jaws",
          "place|three m|[0, 0, 1]||in the drill", "angles|list of rad|1 rad||of the jaws",
          "inertia|3 x 3 kg m2|1||of the chuck", "profile|pairs of m|none||of the chuck",
          "owners|list of texts|none||by name", "turns|whole number|not counted|>= 0|so far",
          "teeth|whole number|3|1 to 9|how many", "seed|whole number|1|>= 0|of chatter",
          "open|on or off|off||whether it is", "label|text|\"none\"||for the report",
          "drawing|file|none||a file", "steel|one of|mild|mild, hard|its material",
          "shape|one of|\"square\"|round, square|of the jaws",
          "hole|one of|none|round|of the chuck", "KEY|any|none||of the drill"}));
}

/// A group of each kind.
struct Drive {
  bool electric = false, geared = false;
  double voltage = 0.0, ratio = 1.0;

  void visit(FieldVisitor& v) {
    v(electric, {.name = "electric", .meaning = "m"});
    v(geared, {.name = "geared", .meaning = "m"});
    v.only(electric, {"a voltage without a motor", "electric = true"},
           [&] { v(voltage, {.name = "voltage", .need = Need::required, .meaning = "m"}); });
    if (v.when(geared)) v(ratio, {.name = "ratio", .meaning = "m"});
  }
};

std::string problems_of_drive(const std::string& toml) {
  Config file = config_of(toml);
  Drive d;
  read_fields(file, d);
  return problems_of(file);
}

TEST(Fields, of_a_group_that_does_not_apply_are_rejected_or_unknown) {
  EXPECT_EQ(problems_of_drive(""), "");
  EXPECT_EQ(problems_of_drive("electric = true\nvoltage = 3\ngeared = true\nratio = 2\n"), "");
  EXPECT_EQ(problems_of_drive("voltage = 3\n"),
            "1: voltage: found a voltage without a motor, expected electric = true");
  EXPECT_NE(problems_of_drive("electric = true\n").find("the key is required"), std::string::npos);
  EXPECT_NE(problems_of_drive("ratio = 3\n").find("an unknown key"), std::string::npos);
  EXPECT_EQ(table_of<Drive>("run", {"drive", "m"}).rows.size(), 4u);
}

TEST(Fields, can_all_be_rejected) {
  Config file = config_of("electric = true\nratio = 2\n");
  refuse_fields<Drive>(file, {"a drive", "none"});
  EXPECT_EQ(problems_of(file).find("1: electric: found a drive, expected none\n"), 0u);
}

}  // namespace tdbd::fields_test
