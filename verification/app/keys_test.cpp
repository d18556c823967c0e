#include <gtest/gtest.h>

#include <algorithm>

#include "app/case_folder.hpp"

namespace tdbd::app::keys_test {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(KeysCommand, prints_every_table) {
  const battery::Outcome o = battery::run_tdbd({"keys"});
  EXPECT_EQ(o.exit_code, 0);
  EXPECT_EQ(o.err, "");
  for (const char* table :
       {"[bit] of tdbd run", "[rock] of tdbd run", "[[rock.layers]] of tdbd run",
        "[motion.whirl] of tdbd run", "[time] of tdbd run", "[forces.KIND] of tdbd run",
        "coefficients of the law \"hanson-hansen\"", "[string] of tdbd run",
        "[body] of tdbd rotate", "[[load.harmonics]] of tdbd rotate", "[time] of tdbd rotate"})
    EXPECT_TRUE(has(o.out, table)) << table;
}

TEST(KeysCommand, prints_one_table_with_those_inside_it) {
  const battery::Outcome o = battery::run_tdbd({"keys", "motion"});
  EXPECT_EQ(o.exit_code, 0);
  EXPECT_EQ(o.out.rfind("[motion] of tdbd run: how the bit moves\n", 0), 0u) << o.out;
  EXPECT_TRUE(has(o.out, "[motion.tilt]")) << o.out;
  EXPECT_FALSE(has(o.out, "[rock]")) << o.out;
  EXPECT_TRUE(has(o.out, "\"steady\"")) << o.out;
}

TEST(KeysCommand, suggests_the_nearest_words) {
  expect_refusal(battery::run_tdbd({"keys", "motoin"}),
                 "WORD: found \"motoin\", expected a table, or a word of a key or of its meaning, "
                 "such as motion, motor");
  expect_refusal(battery::run_tdbd({"keys", "qqqq"}),
                 "WORD: found \"qqqq\", expected a table, or a word of a key or of its meaning");
  expect_refusal(battery::run_tdbd({"keys", "edge_length weight_on_bit"}),
                 "WORD: found \"edge_length weight_on_bit\", expected words that one key has; try "
                 "fewer");
  expect_refusal(battery::run_tdbd({"keys", "motoin", "--markdown"}),
                 "TABLE: found \"motoin\", expected motion");
}

/// Keys of cases, bit files, calibrations and designs, whatever the spelling; the keys that have the
/// word in their name first.
TEST(KeysCommand, searches_the_keys_of_all_files) {
  const battery::Outcome o = battery::run_tdbd({"keys", "back rake"});
  EXPECT_EQ(o.exit_code, 0);
  EXPECT_TRUE(has(o.out, "of tdbd bit: ")) << o.out;
  EXPECT_TRUE(has(o.out, "  back_rake")) << o.out;
  EXPECT_EQ(battery::run_tdbd({"keys", "BACK-rake"}).out, o.out);
  EXPECT_TRUE(has(battery::run_tdbd({"keys", "normal ratio"}).out, "[sweep] of tdbd sweep"));
  EXPECT_TRUE(has(battery::run_tdbd({"keys", "unconfined"}).out, "of tdbd calibrate"));
  const battery::Outcome weight = battery::run_tdbd({"keys", "weight on bit"});
  EXPECT_EQ(weight.out.rfind("[motion] of tdbd run: ", 0), 0u) << weight.out;
  EXPECT_TRUE(has(weight.out, "  weight_on_bit  N  in place of rate_of_penetration  "))
      << weight.out;
}

TEST(KeysCommand, searches_abbreviations_of_the_field) {
  for (const auto& [word, key] : {std::pair("rop", "  rate_of_penetration  "),
                                  {"WOB", "  weight_on_bit  "},
                                  {"rpm", "  rotary_speed  "}})
    EXPECT_TRUE(has(battery::run_tdbd({"keys", word}).out, key)) << word;
}

TEST(KeysCommand, prints_at_most_60_lines_of_a_search) {
  const battery::Outcome o = battery::run_tdbd({"keys", "of"});
  EXPECT_EQ(std::ranges::count(o.out, '\n'), 60) << o.out;
  EXPECT_TRUE(has(o.out, " more lines; add a word to the search\n"));
  EXPECT_EQ(battery::run_tdbd({"keys", "motion"}).out.rfind("[motion] of tdbd run: ", 0), 0u);
  EXPECT_TRUE(has(battery::run_tdbd({"keys", "motion", "--search"}).out, "[motion.whirl]"));
}

/// `tdbd keys --markdown > src/simulation/case/KEYS.md` makes it right again.
TEST(KeysCommand, made_the_tables_of_the_documentation) {
  const battery::Outcome o = battery::run_tdbd({"keys", "--markdown"});
  EXPECT_EQ(o.exit_code, 0);
  EXPECT_EQ(o.out, read(TDBD_SOURCE_DIR "/src/simulation/case/KEYS.md"));
}

/// `tdbd keys --design --markdown > src/sweep/design/KEYS.md` makes it right again.
TEST(KeysCommand, made_the_tables_of_designs) {
  const battery::Outcome o = battery::run_tdbd({"keys", "--design", "--markdown"});
  EXPECT_EQ(o.exit_code, 0);
  EXPECT_EQ(o.out, read(TDBD_SOURCE_DIR "/src/sweep/design/KEYS.md"));
}

TEST(KeysCommand, prints_the_tables_of_designs_alone) {
  const battery::Outcome all = battery::run_tdbd({"keys", "--design"});
  EXPECT_EQ(all.exit_code, 0);
  for (const char* table : {"top of the file of tdbd sweep", "[sweep] of tdbd sweep", "\n[set] of",
                            "[[factors]] of", "[[goals]] of", "[filter] of"})
    EXPECT_TRUE(has(all.out, table)) << table;
  EXPECT_FALSE(has(all.out, "[rock]"));
  const battery::Outcome one = battery::run_tdbd({"keys", "--design", "filter"});
  EXPECT_EQ(one.out.rfind("[filter] of tdbd sweep: ", 0), 0u) << one.out;
  EXPECT_FALSE(has(one.out, "[sweep]")) << one.out;
  const battery::Outcome rock = battery::run_tdbd({"keys", "--design", "rock"});
  EXPECT_EQ(rock.exit_code, 2);
  EXPECT_TRUE(has(rock.err, "tdbd: WORD: found \"rock\", expected a table, or a word of"))
      << rock.err;
}

/// Also where a file names its own keys.
TEST(KeysCommand, describes_every_table) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"keys", "--markdown"}, {"keys", "--design", "--markdown"}}) {
    const std::string page = battery::run_tdbd(words).out;
    EXPECT_EQ(page.find("|---|---|---|---|---|\n\n"), std::string::npos)
        << page.substr(0, page.find("|---|---|---|---|---|\n\n"));
    EXPECT_FALSE(page.ends_with("|---|\n"));
  }
}

}  // namespace tdbd::app::keys_test
