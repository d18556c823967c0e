#include <gtest/gtest.h>

#include "core/config/config.hpp"
#include "core/config/field.hpp"
#include "core/config/key_table.hpp"
#include "core/error.hpp"
#include "core/temporary_file.hpp"

namespace tdbd::key_test {

enum class Shape { round, square };

constexpr TableKey table{"drill.chuck", "a made-up table", Repeats::no};
constexpr QuantityKey length{.name = "length",
                             .unit = "m",
                             .fallback = 0.5,
                             .range = Range::positive(),
                             .meaning = "of the chuck"};
constexpr QuantityKey mass{.name = "mass", .unit = "kg", .meaning = "of it"};
constexpr QuantityKey ramp{
    .name = "ramp", .unit = "s", .computed_default = "one turn", .meaning = "until full"};
constexpr VectorKey place{.name = "place", .unit = "m", .fallback = {{0.0, 0.0, 1.0}}};
constexpr ListKey angles{.name = "angles", .unit = "rad", .computed_default = "none"};
constexpr IntegerKey teeth{.name = "teeth", .fallback = 3, .lo = 1, .hi = 9, .meaning = "how many"};
constexpr FlagKey open{.name = "open", .fallback = false, .meaning = "whether it is"};
constexpr TextKey label{.name = "label", .fallback = "none", .meaning = "for the report"};
constexpr ChoiceKey<Shape> shape{.name = "shape",
                                 .values = {{{"round", Shape::round}, {"square", Shape::square}}},
                                 .fallback = Shape::square,
                                 .meaning = "of the jaws"};

std::vector<std::string_view> steel_names() { return {"mild", "hard"}; }
constexpr NameKey steel{.name = "steel", .names = &steel_names, .meaning = "what it is made of"};

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

TEST(Key, reads_what_the_file_gives) {
  Config file = config_of(
      "[drill.chuck]\nlength = \"20 cm\"\nmass = 3\nramp = 2\nplace = [1, 2, 3]\nangles = [1, 2]\n"
      "teeth = 5\nopen = true\nlabel = \"a\"\nshape = \"round\"\nsteel = \"hard\"\n");
  Config c = file.table("drill").table(table);
  EXPECT_DOUBLE_EQ(c.read(length), 0.2);
  EXPECT_EQ(c.read(mass), 3.0);
  EXPECT_EQ(c.read(ramp, 7.0), 2.0);
  EXPECT_EQ(c.read(place), Vec3(1, 2, 3));
  EXPECT_EQ(c.read(angles), (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(c.read(teeth), 5);
  EXPECT_TRUE(c.read(open));
  EXPECT_EQ(c.read(label), "a");
  EXPECT_EQ(c.read(shape), Shape::round);
  EXPECT_EQ(c.read(steel), "hard");
  EXPECT_EQ(problems_of(file), "");
}

TEST(Key, has_the_default_of_its_declaration) {
  Config c = config_of("");
  EXPECT_EQ(c.read(length), 0.5);
  EXPECT_EQ(c.read(ramp, 7.0), 7.0);
  EXPECT_EQ(c.read(place), Vec3::UnitZ());
  EXPECT_EQ(c.read(teeth), 3);
  EXPECT_FALSE(c.read(open));
  EXPECT_EQ(c.read(label), "none");
  EXPECT_EQ(c.read(shape), Shape::square);
  EXPECT_EQ(problems_of(c), "");
  EXPECT_EQ(c.resolved(),
            "label = \"none\"\nlength = 0.5  # m\nopen = false\nplace = [0, 0, 1]  # m\n"
            "ramp = 7  # s\nshape = \"square\"\nteeth = 3\n");
}

TEST(Key, is_required_without_a_default) {
  Config c = config_of("");
  c.read(mass);
  EXPECT_EQ(problems_of(c), "1: mass: found nothing, expected mass in kg (the key is required)");
  Config other = config_of("");
  other.read(steel);
  EXPECT_EQ(problems_of(other),
            "1: steel: found nothing, expected one of mild, hard (the key is required)");
}

TEST(Key, is_described_in_words) {
  const auto words = [](const KeyRow& r) {
    return r.name + "|" + r.kind + "|" + r.fallback + "|" + r.allowed + "|" + r.meaning;
  };
  EXPECT_EQ(words(row(length)), "length|m|0.5 m|> 0|of the chuck");
  EXPECT_EQ(words(row(mass)), "mass|kg|required||of it");
  EXPECT_EQ(words(row(ramp)), "ramp|s|one turn||until full");
  EXPECT_EQ(words(row(place)), "place|three m|[0, 0, 1]||");
  EXPECT_EQ(words(row(angles)), "angles|list of rad|none||");
  EXPECT_EQ(words(row(teeth)), "teeth|whole number|3|1 to 9|how many");
  EXPECT_EQ(words(row(open)), "open|on or off|off||whether it is");
  EXPECT_EQ(words(row(label)), "label|text|\"none\"||for the report");
  EXPECT_EQ(words(row(shape)), "shape|one of|\"square\"|round, square|of the jaws");
  EXPECT_EQ(words(row(steel)), "steel|one of|required|mild, hard|what it is made of");
  EXPECT_EQ(words(row(ScalarKey{
                .name = "from", .computed_default = "none", .meaning = "where it begins"})),
            "from|value with unit|none||where it begins");
  EXPECT_EQ(words(row(ScalarsKey{.name = "levels", .meaning = "all of them"})),
            "levels|list of values|required||all of them");
  EXPECT_EQ(words(row(AnyKey{"KEY", "as in the drill", "the drill's", "any of its keys"})),
            "KEY|as in the drill|the drill's||any of its keys");
}

TEST(Key, without_a_default_is_described_as_required) {
  const auto words = [](const KeyRow& r) {
    return r.name + "|" + r.kind + "|" + r.fallback + "|" + r.allowed + "|" + r.meaning;
  };
  EXPECT_EQ(words(row(QuantityKey{.name = "x", .unit = "m", .meaning = "y"})), "x|m|required||y");
  EXPECT_EQ(words(row(VectorKey{.name = "x", .unit = "m", .meaning = "y"})),
            "x|three m|required||y");
  EXPECT_EQ(words(row(ListKey{.name = "x", .unit = "m", .meaning = "y"})),
            "x|list of m|required||y");
  EXPECT_EQ(words(row(PairsKey{.name = "x", .unit = "m", .meaning = "y"})),
            "x|pairs of m|required||y");
  EXPECT_EQ(words(row(MatrixKey{.name = "x", .unit = "m", .meaning = "y"})),
            "x|3 x 3 m|required||y");
  EXPECT_EQ(words(row(TextsKey{.name = "x", .meaning = "y"})), "x|list of texts|required||y");
  EXPECT_EQ(words(row(IntegerKey{.name = "x", .lo = 2, .meaning = "y"})),
            "x|whole number|required|>= 2|y");
  EXPECT_EQ(words(row(FlagKey{.name = "x", .meaning = "y"})), "x|on or off|required||y");
  EXPECT_EQ(words(row(TextKey{.name = "x", .meaning = "y"})), "x|text|required||y");
  EXPECT_EQ(words(row(PathKey{.name = "x", .meaning = "y"})), "x|file|required||y");
}

TEST(Key, is_listed_in_its_table) {
  const std::vector<KeyTable> all{key_table("run", table, {row(teeth)}),
                                  key_table("run", {"drill", "the drill"}, {row(mass)})};
  EXPECT_EQ(keys_as_text(all),
            "[drill.chuck] of tdbd run: a made-up table\n"
            "  teeth  whole number  3  how many (1 to 9)\n"
            "\n"
            "[drill] of tdbd run: the drill\n"
            "  mass  kg  required  of it\n");
  // every column is as wide as its widest cell
  EXPECT_EQ(
      keys_as_text(std::vector{key_table("run", table, {row(teeth), row(length), row(mass)})}),
      "[drill.chuck] of tdbd run: a made-up table\n"
      "  teeth   whole number  3         how many (1 to 9)\n"
      "  length  m             0.5 m     of the chuck (> 0)\n"
      "  mass    kg            required  of it\n");
  EXPECT_EQ(tables_named(all, "drill").size(), 2u);
  EXPECT_EQ(tables_named(all, "drill.chuck").size(), 1u);
  try {
    tables_named(all, "dril");
    FAIL() << "not refused";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "TABLE: found \"dril\", expected drill");
  }
}

}  // namespace tdbd::key_test
