#include "battery/run_tdbd.hpp"

#include <gtest/gtest.h>

namespace tdbd::battery::run_tdbd_test {

TEST(RunTdbd, captures_both_streams_and_the_exit_code) {
  const Outcome help = run_tdbd({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_NE(help.out.find("Usage: tdbd"), std::string::npos) << help.out;
  EXPECT_EQ(help.err, "");
  const Outcome wrong = run_tdbd({"run"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.err, "");
}

TEST(RunTdbd, arguments_keep_their_spaces) {
  const Outcome o = run_tdbd({"check", "no such file.toml"});
  EXPECT_EQ(o.err, "tdbd: no such file.toml: found no such file, expected a TOML file\n");
}

}  // namespace tdbd::battery::run_tdbd_test
