#include <sstream>

#include "core/config/number_doubts.hpp"
#include "verification/core/config/config_mistakes.hpp"

namespace tdbd::config_errors_test {

enum class Motion { axial, whirl };
const std::vector<std::pair<std::string, Motion>> motions{{"axial", Motion::axial},
                                                          {"whirl", Motion::whirl}};

TEST(ConfigErrors, quantity) {
  const auto read = [](Config& c) { c.quantity("a.d", "m", {}, Range::positive()); };
  expect_message(
      {"[a]\nd = \"8 kg\"\n", read,
       "FILE:2: a.d: found \"8 kg\" (kg is mass), expected length in m or in another unit"});
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
  expect_message({"v = [1, 2, \"3 s\"]\n", read,
                  "FILE:1: v: found \"3 s\" (s is time), expected length in m or in another unit"});
}

TEST(ConfigErrors, list) {
  const auto read = [](Config& c) { c.list("l", "m", {}); };
  expect_message({"l = 1\n", read, "FILE:1: l: found 1, expected an array: length in m"});
  expect_message({"l = [1, \"3 s\"]\n", read,
                  "FILE:1: l: found \"3 s\" (s is time), expected length in m or in another unit"});
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

struct Bare {
  const char* unit;
  const char* value;
  const char* doubt;  ///< empty: none
};

TEST(ConfigDoubts, are_about_numbers_that_are_usual_in_another_unit_only) {
  for (const Bare& b : std::vector<Bare>{
           {"rad/s", "120",
            "120 without a unit is 120 rad/s; did you mean \"120 rpm\" or \"120 deg/s\"?"},
           {"rad/s", "30", ""},
           {"rad/s", "\"120 rad/s\"", ""},
           {"rad", "-20", "-20 without a unit is -20 rad; did you mean \"-20 deg\"?"},
           {"rad", "6.28", ""},
           {"N", "0", ""},
           {"N", "15", "15 without a unit is 15 N; did you mean \"15 klbf\" or \"15 kN\"?"},
           {"N", "5e4", ""},
           {"Pa", "200",
            "200 without a unit is 200 Pa; did you mean \"200 psi\" or \"200 bar\" or "
            "\"200 MPa\" or \"200 GPa\"?"},
           {"kg/m3", "7.85",
            "7.85 without a unit is 7.85 kg/m3; did you mean \"7.85 g/cm3\" or "
            "\"7.85 ppg\"?"},
           {"K", "60", "60 without a unit is 60 K; did you mean \"60 degC\"?"},
           {"1", "1000", ""}}) {
    Config c = Config::read_text(std::string("x = ") + b.value + "\n", "x.toml");
    c.quantity("x", b.unit, {});
    const std::vector<ConfigDoubt> doubts = c.doubts();
    const std::string doubt = b.doubt;
    ASSERT_EQ(doubts.size(), doubt.empty() ? 0u : 1u) << b.value << " " << b.unit;
    if (doubt.empty()) continue;
    EXPECT_EQ(doubts[0].text, doubt);
    EXPECT_EQ(doubts[0].place, "x.toml:1: x");
  }
}

TEST(ConfigDoubts, are_about_the_first_such_number_of_an_array) {
  Config c = Config::read_text("a = [0, 90]\nv = [0.1, 15, 0]\np = [[1, 2], [300, 4]]\n", "x.toml");
  c.list("a", "rad", {});
  c.vector("v", "m/s", {});
  c.pairs("p", "m", {}, Range::within(0.0, 10.0));
  const std::vector<ConfigDoubt> doubts = c.doubts();
  ASSERT_EQ(doubts.size(), 3u);
  EXPECT_EQ(doubts[0].text, "90 without a unit is 90 rad; did you mean \"90 deg\"?");
  EXPECT_EQ(doubts[1].text, "300 without a unit is 300 m; did you mean \"300 mm\" or \"300 in\"?");
  EXPECT_TRUE(doubts[2].text.starts_with("15 without a unit is 15 m/s;"));
}

/// The numbers of a resolved case are in SI.
TEST(ConfigDoubts, are_not_about_a_resolved_case) {
  for (const std::string head : {"", resolved_head}) {
    Config c = Config::read_text(head + "\na = 15\n", "x.toml");
    c.quantity("a", "N", {});
    EXPECT_EQ(c.doubts().empty(), !head.empty());
  }
}

/// The message suggests the units in which the number is in range, if no unit was given.
TEST(ConfigErrors, a_length_or_time_out_of_range_suggests_its_unit) {
  const auto told = [](const std::string& unit, const std::string& value) {
    Config c = Config::read_text("x = " + value + "\n", "x.toml");
    c.quantity("x", unit, {}, Range::within(1e-5, 0.1));
    return finish_message(c);
  };
  const std::string metres = "expected length in m, in [1e-05, 0.1]";
  EXPECT_EQ(told("m", "2.5"),
            "x.toml:1: x: found 2.5, " + metres +
                "; without a unit it is in m: did you mean \"2.5 mm\" or \"2.5 in\"?");
  EXPECT_EQ(told("s", "100"),
            "x.toml:1: x: found 100, expected time in s, in [1e-05, 0.1]; without a unit it is "
            "in s: did you mean \"100 ms\"?");
  for (const std::string other : {"101", "-2.5", "\"2.5 m\""})
    EXPECT_EQ(told("m", other), "x.toml:1: x: found " + other + ", " + metres);
  EXPECT_EQ(told("kg", "2.5"), "x.toml:1: x: found 2.5, expected mass in kg, in [1e-05, 0.1]");
}

TEST(ConfigErrors, a_wrong_value_returns_the_default) {
  Config config = Config::read_file(write_temporary(".toml", "a = 'x'\n"), {});
  EXPECT_GT(config.quantity("a", "m", {}, Range::positive()), 0.0);
  EXPECT_EQ(config.quantity("b", "m", {}, Range::within(2, 3)), 2.0);
  EXPECT_EQ(config.vector("c", "m", {}).norm(), 1.0);
  EXPECT_EQ(config.integer("d", {}, 5, 9), 5);
  EXPECT_FALSE(config.flag("a", {}));
  EXPECT_FALSE(config.flag("e", {}));
  EXPECT_THROW(config.finish(), InputError);
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

TEST(ConfigErrors, of_texts) {
  expect_message({"t = [\"a\", 3]\n",
                  [](Config& c) { c.texts("t", {}); },
                  "FILE:1: t: found 3, expected an array of texts",
                  {}});
}

}  // namespace tdbd::config_errors_test
