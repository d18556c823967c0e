#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sstream>

#include "core/config/config.hpp"
#include "core/error.hpp"
#include "core/temporary_file.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::config_errors_test {

enum class Motion { axial, whirl };
const std::vector<std::pair<std::string, Motion>> motions{{"axial", Motion::axial},
                                                          {"whirl", Motion::whirl}};

/// One test: a file's text, what a program reads of it, the one line of message this must give
/// (FILE stands for the path).
struct Mistake {
  std::string toml;
  void (*read)(Config&);
  std::string message;
  std::vector<std::string> overrides = {};
};

std::string finish_message(const Config& config) {
  try {
    config.finish();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

void expect_message(const Mistake& mistake) {
  const std::string path = write_temporary(".toml", mistake.toml);
  std::string expected = mistake.message;
  if (expected.rfind("FILE", 0) == 0) expected.replace(0, 4, path);
  Config config = Config::read_file(path, mistake.overrides);
  mistake.read(config);
  EXPECT_EQ(finish_message(config), expected);
}

std::string read_failure(const std::string& path) {
  try {
    Config::read_file(path, {});
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ConfigErrors, quantity) {
  const auto read = [](Config& c) { c.quantity("a.d", "m", {}, Range::positive()); };
  expect_message({"[a]\nd = \"8 kg\"\n", read,
                  "FILE:2: a.d: found \"8 kg\" (kg is mass), expected length in m or another unit "
                  "of it"});
  expect_message({"[a]\n\nd = -1\n", read, "FILE:3: a.d: found -1, expected length in m, > 0"});
  expect_message(
      {"[a]\nd = \"0 m\"\n", read, "FILE:2: a.d: found \"0 m\", expected length in m, > 0"});
  expect_message({"[a]\nd = nan\n", read,
                  "FILE:2: a.d: found nan, expected length in m, or a text with a unit"});
  expect_message({"[a]\nd = [1]\n", read,
                  "FILE:2: a.d: found an array of 1, expected length in m, or a text with a unit"});
  expect_message({"[a]\nd = true\n", read,
                  "FILE:2: a.d: found true, expected length in m, or a text with a unit"});
  expect_message({"\n[a]\n", read,
                  "FILE:2: a.d: found nothing, expected length in m, > 0 (the key is required)"});
}

TEST(ConfigErrors, vector) {
  const auto read = [](Config& c) { c.vector("v", "m", {}); };
  expect_message({"v = [1, 2]\n", read,
                  "FILE:1: v: found an array of 2, expected an array of three: length in m"});
  expect_message(
      {"v = [1, 2, \"3 s\"]\n", read,
       "FILE:1: v: found \"3 s\" (s is time), expected length in m or another unit of it"});
}

TEST(ConfigErrors, list) {
  const auto read = [](Config& c) { c.list("l", "m", {}); };
  expect_message({"l = 1\n", read, "FILE:1: l: found 1, expected an array: length in m"});
  expect_message({"l = [1, \"3 s\"]\n", read,
                  "FILE:1: l: found \"3 s\" (s is time), expected length in m or another unit of "
                  "it"});
  expect_message(
      {"\n", read,
       "FILE:1: l: found nothing, expected an array: length in m (the key is required)"});
}

TEST(ConfigErrors, pairs) {
  const auto read = [](Config& c) { c.pairs("p", "m", {}); };
  expect_message({"p = \"1 mm\"\n", read,
                  "FILE:1: p: found \"1 mm\", expected an array of pairs: length in m"});
  expect_message({"p = [[1, 2], [3]]\n", read,
                  "FILE:1: p: found an array of 1, expected an array of pairs: length in m"});
  expect_message({"p = [[1, true]]\n", read,
                  "FILE:1: p: found true, expected length in m, or a text with a unit"});
}

TEST(ConfigErrors, matrix) {
  const auto read = [](Config& c) { c.matrix("m", "1", {}); };
  expect_message({"m = [[1, 2, 3]]\n", read,
                  "FILE:1: m: found an array of 1, expected three rows of three: a plain number"});
  expect_message({"m = [[1, 2, 3], [1, 2], [1, 2, 3]]\n", read,
                  "FILE:1: m: found an array of 2, expected three rows of three: a plain number"});
}

TEST(ConfigErrors, integer) {
  const auto read = [](Config& c) { c.integer("n", {}, 1, 9); };
  expect_message({"n = 10\n", read, "FILE:1: n: found 10, expected a whole number from 1 to 9"});
  expect_message({"n = 2.0\n", read, "FILE:1: n: found 2.0, expected a whole number from 1 to 9"});
  expect_message(
      {"n = \"2\"\n", read, "FILE:1: n: found \"2\", expected a whole number from 1 to 9"});
}

TEST(ConfigErrors, flag_text_and_path) {
  expect_message({"f = \"yes\"\n", [](Config& c) { c.flag("f", {}); },
                  "FILE:1: f: found \"yes\", expected true, false, \"on\" or \"off\""});
  expect_message({"t = 3\n", [](Config& c) { c.text("t", {}); },
                  "FILE:1: t: found 3, expected a text in quotes"});
  expect_message({"p = \"/no/such.csv\"\n", [](Config& c) { c.path("p", {}); },
                  "FILE:1: p: found \"/no/such.csv\" (there is no /no/such.csv), expected the path "
                  "of an existing file, from the case file's folder"});
}

TEST(ConfigErrors, choice) {
  const auto read = [](Config& c) { c.choice<Motion>("kind", motions, {}); };
  expect_message(
      {"kind = \"wirl\"\n", read,
       "FILE:1: kind: found \"wirl\", expected one of axial, whirl (did you mean whirl?)"});
  expect_message({"kind = \"spiral\"\n", read,
                  "FILE:1: kind: found \"spiral\", expected one of axial, whirl"});
  expect_message({"kind = 1\n", read, "FILE:1: kind: found 1, expected one of axial, whirl"});
}

TEST(ConfigErrors, tables) {
  expect_message(
      {"a = 1\n", [](Config& c) { c.table("a"); }, "FILE:1: a: found 1, expected a table"});
  expect_message({"a = [1, {}]\n", [](Config& c) { c.tables("a"); },
                  "FILE:1: a: found an array of 2, expected an array of tables, [[a]]"});
  expect_message({"[a]\n", [](Config& c) { c.tables("a"); },
                  "FILE:1: a: found a table, expected an array of tables, [[a]]"});
  expect_message({"[a]\nx = 1\n", [](Config& c) { c.tables("a"); },
                  "FILE:1: a: found a table, expected an array of tables, [[a]]"});
}

TEST(ConfigErrors, a_table_that_nobody_knows_names_those_that_are_known) {
  const auto read = [](Config& c) { c.quantity("bit.mass", "kg", 1.0); };
  expect_message({"[rock]\nedge = 1\n", read,
                  "FILE:2: rock.edge: found an unknown key, expected one of bit in place of rock"});
  expect_message({"[bit.cones.one]\nq = 1\n", read,
                  "FILE:2: bit.cones.one.q: found an unknown key, expected one of mass in place of "
                  "cones"});
}

TEST(ConfigErrors, unknown_keys_name_the_nearest) {
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
TEST(ConfigErrors, an_unknown_array_is_told_once) {
  const auto read = [](Config& c) { c.quantity("radius", "m", 1.0); };
  for (const std::string array : {"[1, 2]", "[{y = 1}, 2]", "[]"})
    expect_message({"radios = " + array + "\n", read,
                    "FILE:1: radios: found an unknown key, expected radius"});
  expect_message({"a = [{b = 1}]\n", read,
                  "FILE:1: a[0].b: found an unknown key, expected one of radius in place of a"});
}

/// A thousandth is asked for where it would do, and no unit was given.
TEST(ConfigErrors, a_length_or_time_out_of_its_range_asks_for_its_unit) {
  const auto told = [](const std::string& unit, const std::string& value) {
    Config c = Config::read_text("x = " + value + "\n", "x.toml");
    c.quantity("x", unit, {}, Range::within(1e-5, 0.1));
    return finish_message(c);
  };
  const std::string metres = "expected length in m, in [1e-05, 0.1]";
  EXPECT_EQ(told("m", "2.5"), "x.toml:1: x: found 2.5, " + metres +
                                  "; without a unit it counts in m: is \"2.5 mm\" meant?");
  EXPECT_EQ(told("s", "100"),
            "x.toml:1: x: found 100, expected time in s, in [1e-05, 0.1]; without a unit it counts "
            "in s: is \"100 ms\" meant?");
  for (const std::string other : {"101", "-2.5", "\"2.5 m\""})
    EXPECT_EQ(told("m", other), "x.toml:1: x: found " + other + ", " + metres);
  EXPECT_EQ(told("kg", "2.5"), "x.toml:1: x: found 2.5, expected mass in kg, in [1e-05, 0.1]");
}

/// A table that an override makes has no line of its own.
TEST(ConfigErrors, a_table_that_an_override_made_is_at_the_start_of_the_file) {
  expect_message({"b = 1\n",
                  [](Config& c) {
                    c.integer("b", {}, 0, 9);
                    c.quantity("new", "m", 1.0);
                  },
                  "FILE:1: new: found a table, expected length in m, or a text with a unit",
                  {"new.sub=1"}});
}

TEST(ConfigErrors, a_bracket_that_none_opens_belongs_to_a_name) {
  const auto read = [](Config& c) { c.quantity("a.d", "m", 1.0); };
  expect_message(
      {"[a]\n\"x]\" = 1\n", read, "FILE:1: a.x]: found an unknown key, expected one of d"});
  expect_message(
      {"[a]\n", read, "--set: a.x]: found an unknown key, expected one of d", {"a.x]=1"}});
}

TEST(ConfigErrors, unknown_keys_beyond_a_thousand_get_no_advice) {
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

TEST(ConfigErrors, a_name_with_a_dot_is_no_path) {
  expect_message({"\"a.b\" = 1\n", [](Config& c) { c.quantity("a.b", "m", 0.0); },
                  "FILE:1: a.b: found an unknown key, expected b"});
}

TEST(ConfigErrors, what_an_override_brings_along_is_named_as_such) {
  const auto read = [](Config& c) {
    for (Config l : c.tables("l")) l.quantity("x", "m", {});
  };
  expect_message({"[[l]]\nx = 1\n",
                  read,
                  "--set: l[1].x: found \"s\" (does not start with a "
                  "number), expected length in m or another unit of it",
                  {"l=[{x=1}, {x='s'}]"}});
}

TEST(ConfigErrors, a_wrong_value_leaves_the_caller_a_harmless_one) {
  Config config = Config::read_file(write_temporary(".toml", "a = 'x'\n"), {});
  EXPECT_GT(config.quantity("a", "m", {}, Range::positive()), 0.0);
  EXPECT_EQ(config.quantity("b", "m", {}, Range::within(2, 3)), 2.0);
  EXPECT_EQ(config.vector("c", "m", {}).norm(), 1.0);
  EXPECT_EQ(config.integer("d", {}, 5, 9), 5);
  EXPECT_THROW(config.finish(), InputError);
}

TEST(ConfigErrors, overrides_are_named_as_such) {
  const auto read = [](Config& c) { c.quantity("a.d", "m", 1.0); };
  expect_message({"", read, "--set: a.e: found an unknown key, expected d", {"a.e=1"}});
  expect_message({"",
                  read,
                  "--set: a.d: found \"1 s\" (s is time), expected length in m or another "
                  "unit of it",
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

TEST(ConfigErrors, the_callers_own_checks_are_located) {
  expect_message({"[a]\n\nb = 1\n",
                  [](Config& c) {
                    Config a = c.table("a");
                    a.quantity("b", "m", {});
                    a.problem("b", "a pad outside the hole", "a pad inside it");
                  },
                  "FILE:3: a.b: found a pad outside the hole, expected a pad inside it"});
}

TEST(ConfigErrors, all_mistakes_of_a_file_come_together_sorted_by_line) {
  const std::string path = write_temporary(".toml", "z = 1\nb = \"x\"\na = \"1 s\"\n");
  Config config = Config::read_file(path, {});
  EXPECT_EQ(config.quantity("a", "m", 5.0), 5.0);
  config.integer("b", {}, 0, 1);
  config.integer("b", {}, 0, 1);  // read twice, reported once
  std::istringstream lines(finish_message(config));
  std::string line;
  for (const std::string expected : {":1: z: ", ":2: b: ", ":3: a: "}) {
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_EQ(line.rfind(path + expected, 0), 0u) << line;
  }
  EXPECT_FALSE(std::getline(lines, line));
}

TEST(ConfigErrors, files_that_are_missing_or_no_toml) {
  EXPECT_EQ(read_failure("/no/such.toml"),
            "/no/such.toml: found no such file, expected a TOML file");
  EXPECT_EQ(read_failure(tdbd::temporary_folder()),
            tdbd::temporary_folder() + ": found a folder, expected a TOML file");
  EXPECT_EQ(read_failure("/dev/null"), "/dev/null: found no regular file, expected a TOML file");
  const std::string path = write_temporary(".toml", "a = 1\nb = = 2\n");
  EXPECT_EQ(read_failure(path).rfind(path + ":2:5: found a syntax error, expected TOML: ", 0), 0u)
      << read_failure(path);
  const std::string twice = write_temporary(".toml", "a = 1\na = 2\n");
  EXPECT_EQ(read_failure(twice).rfind(twice + ":2:", 0), 0u) << read_failure(twice);
}

/// "a.a.a = 1" with so many names.
std::string key_of(int names) {
  std::string key = "a";
  for (int k = 1; k < names; ++k) key += ".a";
  return key;
}

/// A table a name: 16 000 of them exhausted the stack.
TEST(ConfigErrors, of_keys_and_tables_without_end) {
  for (const std::string start : {"", "["}) {
    const std::string path = write_temporary(
        ".toml", "# 1\n" + start + key_of(16000) + (start.empty() ? " = 1\n" : "]\n"));
    EXPECT_EQ(read_failure(path), path + ":2: found a key of more names, expected at most 32");
  }
  std::string nested = "1";
  for (int k = 0; k < 200; ++k) nested = "{" + key_of(30) + " = " + nested + "}";
  const std::string path = write_temporary(".toml", "b = " + nested + "\n");
  EXPECT_EQ(read_failure(path), path + ":1: found a value in more tables, expected at most 256");
  expect_message({"b = 1\n",
                  [](Config& c) { c.integer("b", {}, 0, 9); },
                  "--set: " + key_of(33) + ": found a key of more names, expected at most 32",
                  {key_of(33) + "=1"}});
}

/// Each line counts for itself, the first one too.
TEST(ConfigErrors, of_keys_count_the_names_of_a_line) {
  const std::string longest = key_of(32), beyond = key_of(33);
  EXPECT_EQ(read_failure(write_temporary(".toml", "[" + longest + "]\n" + longest + " = 1\n")),
            "no error");
  EXPECT_EQ(read_failure(write_temporary(".toml", longest + " = 1\n")), "no error");
  const std::string path = write_temporary(".toml", beyond + " = 1\n");
  EXPECT_EQ(read_failure(path), path + ":1: found a key of more names, expected at most 32");
}

/// Arrays count as tables do.
TEST(ConfigErrors, of_arrays_within_arrays) {
  std::string nested = "1";
  for (int k = 0; k < 50; ++k) nested = "[{" + key_of(5) + " = " + nested + "}]";
  const std::string path = write_temporary(".toml", "b = " + nested + "\n");
  EXPECT_EQ(read_failure(path), path + ":1: found a value in more tables, expected at most 256");
}

/// A table for each name of a key, one for each array and each of its tables: 1 + 42 x 6 + 3 is as deep as may be.
TEST(ConfigErrors, of_values_that_are_one_table_too_deep) {
  const auto failure_of = [](int names_of_the_last) {
    std::string nested = "[{" + key_of(names_of_the_last) + " = 1}]";
    for (int k = 0; k < 42; ++k) nested = "[{" + key_of(5) + " = " + nested + "}]";
    return read_failure(write_temporary(".toml", "b = " + nested + "\n"));
  };
  EXPECT_EQ(failure_of(1), "no error");
  EXPECT_EQ(failure_of(2), "no error");
  EXPECT_NE(failure_of(3).find(":1: found a value in more tables, expected at most 256"),
            std::string::npos)
      << failure_of(3);
}

TEST(ConfigErrors, of_texts) {
  expect_message({"t = [\"a\", 3]\n",
                  [](Config& c) { c.texts("t", {}); },
                  "FILE:1: t: found 3, expected an array of texts",
                  {}});
}

TEST(ConfigErrors, dots_in_texts_comments_and_numbers_are_none_of_a_key) {
  const std::string dots(100, '.');
  const std::string path =
      write_temporary(".toml", "# " + dots + "\na = \"" + dots + "\"  # \"" + dots +
                                   "\nb = [1.0, 2.0]\n\"" + dots + "\" = 1\n");
  EXPECT_EQ(read_failure(path), "no error");
}

TEST(ConfigErrors, of_keys_without_a_name) {
  const auto read = [](Config& c) { c.integer("b", {}, 0, 9); };
  expect_message(
      {"\"\" = 1\nb = 1\n", read, "FILE:1: \"\": found an unknown key, expected one of b"});
  for (const std::string key : {".", "a.", ".a", "a..b"})
    expect_message({"b = 1\n",
                    read,
                    "--set: " + key + "=1: found no key=value, expected key=value",
                    {key + "=1"}});
}

TEST(ConfigErrors, a_byte_that_ends_a_text_ends_no_message) {
  expect_message({"b = 1\n\"c\\u0000d\" = 1\n", [](Config& c) { c.integer("b", {}, 0, 9); },
                  "FILE:2: c\\u0000d: found an unknown key, expected one of b"});
}

RC_GTEST_PROP(ConfigErrors, any_bytes_are_a_file_or_an_input_error, (const std::string& bytes)) {
  const std::string path = tdbd::temporary_folder() + "config_errors_bytes.toml";
  std::ofstream(path) << "a = 1\n" << bytes;
  try {
    Config config = Config::read_file(path, {bytes, "b=" + bytes, bytes + "=1"});
    config.quantity("a", "m", {});
    config.finish();
  } catch (const InputError& error) {
    RC_ASSERT(std::string(error.what()).find("found") != std::string::npos);
  }
}

}  // namespace tdbd::config_errors_test
