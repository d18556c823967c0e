#include <gtest/gtest.h>

#include "core/config/config.hpp"
#include "core/error.hpp"

namespace tdbd::config_words_test {

Config config_of(const std::string& text) { return Config::read_text(text, "words.toml"); }

std::string problems_of(const Config& c) {
  try {
    c.finish();
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(ConfigScalars, keep_kind_and_digits) {
  Config c = config_of("a = [\"60 rpm\", 0.1, 3, true, \"7\"]\nb = 2.5\n");
  const std::vector<ConfigScalar> words = c.words("a");
  ASSERT_EQ(words.size(), 5u);
  EXPECT_EQ(words[0].text, "60 rpm");
  EXPECT_EQ(words[0].toml, "\"60 rpm\"");
  EXPECT_EQ(words[1].toml, "0.1");
  EXPECT_EQ(words[2].toml, "3");
  EXPECT_EQ(words[3].toml, "true");
  EXPECT_EQ(words[4].toml, "\"7\"");
  EXPECT_EQ(c.word("b", {}).toml, "2.5");
  EXPECT_EQ(c.word("c", ConfigScalar{"x", "\"x\""}).text, "x");
  EXPECT_EQ(problems_of(c), "");
}

TEST(ConfigScalars, reject_tables_and_empty_values) {
  Config c = config_of("a = [[1]]\nb = {x = 1}\nd = []\n");
  c.words("a");
  c.word("b", {});
  c.word("e", {});
  c.words("d");
  EXPECT_EQ(problems_of(c),
            "words.toml:1: a: found an array of 1, expected a text, a number, or true or false\n"
            "words.toml:1: e: found nothing, expected a text, a number, or true or false (the key "
            "is required)\n"
            "words.toml:2: b: found a table, expected a text, a number, or true or false\n"
            "words.toml:3: d: found no value, expected an array of at least one value, each a "
            "text, a number, or true or "
            "false");
}

/// Settings that one file makes for another, as overrides with the same meaning there.
TEST(ConfigScalars, of_a_table_are_overrides) {
  Config c = config_of("[set]\nx.y = \"2 mm\"\nn = 3\nl = [1.5, [\"a\"]]\n");
  const std::vector<std::string> all = c.table("set").assignments();
  EXPECT_EQ(all, (std::vector<std::string>{"l=[1.5, [\"a\"]]", "n=3", "x.y=\"2 mm\""}));
  EXPECT_EQ(problems_of(c), "");
  EXPECT_NE(c.resolved().find("y = \"2 mm\""), std::string::npos);
}

/// A name with a dot in it cannot be said as an override: it is an unknown key, and the others are read.
TEST(ConfigScalars, of_a_table_leave_out_names_that_are_no_keys) {
  Config c = config_of("[set]\n\"a.b\" = 1\nz = 2\n");
  EXPECT_EQ(c.table("set").assignments(), std::vector<std::string>{"z=2"});
  EXPECT_EQ(problems_of(c).rfind("words.toml:1: set.a.b: found an unknown key", 0), 0u)
      << problems_of(c);
}

}  // namespace tdbd::config_words_test
