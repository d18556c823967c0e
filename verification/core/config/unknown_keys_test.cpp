#include <fmt/format.h>

#include "verification/core/config/config_mistakes.hpp"

namespace tdbd::unknown_keys_test {

TEST(UnknownKeys, an_unknown_table_lists_the_known_ones) {
  const auto read = [](Config& c) { c.quantity("bit.mass", "kg", 1.0); };
  expect_message({"[rock]\nedge = 1\n", read,
                  "FILE:2: rock.edge: found an unknown key, expected one of bit in place of rock"});
  expect_message({"[bit.cones.one]\nq = 1\n", read,
                  "FILE:2: bit.cones.one.q: found an unknown key, expected one of mass in place of "
                  "cones"});
}

TEST(UnknownKeys, name_the_nearest) {
  expect_message({"[a]\nradius = 1\nraduis = 2\n",
                  [](Config& c) { c.quantity("a.radius", "m", {}); },
                  "FILE:3: a.raduis: found an unknown key, expected radius"});
  expect_message({"radius = 1\n[a]\n", [](Config& c) { c.quantity("radius", "m", {}); },
                  "FILE:2: a: found an unknown key, expected one of radius"});
  expect_message({"[[l]]\nx = 1\n[[l]]\ny = 1\n",
                  [](Config& c) {
                    for (Config l : c.tables("l")) l.quantity("x", "m", 0.0);
                  },
                  "FILE:4: l[1].y: found an unknown key, expected x"});
}

/// Tables of an array are looked into; what is no table, or not all tables, is one wrong value.
TEST(UnknownKeys, an_unknown_array_is_told_once) {
  const auto read = [](Config& c) { c.quantity("radius", "m", 1.0); };
  for (const std::string array : {"[1, 2]", "[{y = 1}, 2]", "[]"})
    expect_message({"radios = " + array + "\n", read,
                    "FILE:1: radios: found an unknown key, expected radius"});
  expect_message({"a = [{b = 1}]\n", read,
                  "FILE:1: a[0].b: found an unknown key, expected one of radius in place of a"});
}

TEST(UnknownKeys, a_bracket_that_none_opens_belongs_to_a_name) {
  const auto read = [](Config& c) { c.quantity("a.d", "m", 1.0); };
  expect_message(
      {"[a]\n\"x]\" = 1\n", read, "FILE:1: a.x]: found an unknown key, expected one of d"});
  expect_message(
      {"[a]\n", read, "--set: a.x]: found an unknown key, expected one of d", {"a.x]=1"}});
}

TEST(UnknownKeys, beyond_a_thousand_get_no_advice) {
  std::string toml;
  for (int i = 1000; i <= 2000; ++i) toml += fmt::format("key{} = 1\n", i);
  Config config = Config::read_text(toml, "many.toml");
  config.quantity("key", "m", 1.0);
  const std::string message = finish_message(config);
  EXPECT_NE(message.find("many.toml:1000: key1999: found an unknown key, expected one of key\n"),
            std::string::npos);
  EXPECT_NE(message.find("many.toml:1001: key2000: found an unknown key, expected a known one"),
            std::string::npos);
}

TEST(UnknownKeys, a_name_with_a_dot_is_no_path) {
  expect_message({"\"a.b\" = 1\n", [](Config& c) { c.quantity("a.b", "m", 0.0); },
                  "FILE:1: a.b: found an unknown key, expected b"});
}

TEST(UnknownKeys, a_byte_that_ends_a_text_ends_no_message) {
  expect_message({"b = 1\n\"c\\u0000d\" = 1\n", [](Config& c) { c.integer("b", {}, 0, 9); },
                  "FILE:2: c\\u0000d: found an unknown key, expected one of b"});
}

}  // namespace tdbd::unknown_keys_test
