#include <gtest/gtest.h>

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

TEST(KeysCommand, tells_the_nearest_table) {
  expect_refusal(battery::run_tdbd({"keys", "motoin"}), "TABLE: found \"motoin\", expected motion");
  expect_refusal(battery::run_tdbd({"keys", "zzz"}),
                 "TABLE: found \"zzz\", expected a table that `tdbd keys` lists");
}

/// `tdbd keys --markdown > src/simulation/case/KEYS.md` makes it right again.
TEST(KeysCommand, made_the_tables_of_the_documentation) {
  const battery::Outcome o = battery::run_tdbd({"keys", "--markdown"});
  EXPECT_EQ(o.exit_code, 0);
  EXPECT_EQ(o.out, read(TDBD_SOURCE_DIR "/src/simulation/case/KEYS.md"));
}

}  // namespace tdbd::app::keys_test
