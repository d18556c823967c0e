#include "verification/core/config/config_mistakes.hpp"

namespace tdbd::config_overrides_test {

TEST(ConfigOverrides, are_named_as_such) {
  const auto read = [](Config& c) { c.quantity("a.d", "m", 1.0); };
  expect_message({"", read, "--set: a.e: found an unknown key, expected d", {"a.e=1"}});
  expect_message({"",
                  read,
                  "--set: a.d: found \"1 s\" (s is time), expected length in m or in another unit",
                  {"a.d=1 s"}});
  expect_message({"", read, "--set: a.d: found no key=value, expected key=value", {"a.d"}});
  expect_message(
      {"b = 1\n",
       [](Config& c) { c.integer("b", {}, 0, 9); },
       "--set: b.c: found a value where its table should be, expected a key inside a table",
       {"b.c=1"}});
  const auto read_list = [](Config& c) {
    for (Config l : c.tables("l")) l.quantity("x", "m", 0.0);
  };
  for (const std::string beyond : {"l[1]", "l[0].m[0]"})
    expect_message(
        {"[[l]]\nx = 1\n",
         read_list,
         "--set: " + beyond +
             ".x: found a value where its table should be, expected a key inside a table",
         {beyond + ".x=5"}});
}

TEST(ConfigOverrides, are_named_for_what_they_bring_along) {
  const auto read = [](Config& c) {
    for (Config l : c.tables("l")) l.quantity("x", "m", {});
  };
  expect_message({"[[l]]\nx = 1\n",
                  read,
                  "--set: l[1].x: found \"s\" (does not start with a "
                  "number), expected length in m or in another unit",
                  {"l=[{x=1}, {x='s'}]"}});
}

/// A table that an override makes has no line of its own.
TEST(ConfigOverrides, a_table_that_an_override_made_is_at_the_start_of_the_file) {
  expect_message({"b = 1\n",
                  [](Config& c) {
                    c.integer("b", {}, 0, 9);
                    c.quantity("new", "m", 1.0);
                  },
                  "FILE:1: new: found a table, expected length in m, or a text with a unit",
                  {"new.sub=1"}});
}

TEST(ConfigOverrides, and_files_of_keys_without_a_name) {
  const auto read = [](Config& c) { c.integer("b", {}, 0, 9); };
  expect_message(
      {"\"\" = 1\nb = 1\n", read, "FILE:1: \"\": found an unknown key, expected one of b"});
  for (const std::string key : {".", "a.", ".a", "a..b"})
    expect_message({"b = 1\n",
                    read,
                    "--set: " + key + "=1: found no key=value, expected key=value",
                    {key + "=1"}});
}

}  // namespace tdbd::config_overrides_test
