#include <gtest/gtest.h>

#include <algorithm>

#include "app/small_case.hpp"

/// The first minute with the program: words that are no command, files of another kind, units.
namespace tdbd::app::first_words_test {

const std::string cases = TDBD_SOURCE_DIR "/cases/";

void expect_told(const std::vector<std::string>& words, const std::string& message) {
  const auto o = battery::run_tdbd(words);
  EXPECT_EQ(o.exit_code, 2) << words.front();
  EXPECT_EQ(o.out, "");
  EXPECT_EQ(o.err, "tdbd: " + message + "\n");
}

TEST(FirstWords, none_show_every_command_with_an_example) {
  const auto alone = battery::run_tdbd({}), help = battery::run_tdbd({"help"});
  EXPECT_EQ(alone.exit_code, 0);
  EXPECT_EQ(alone.out, help.out);
  for (const char* command : {"run", "rotate", "string", "converge", "calibrate", "check", "keys",
                              "bit", "laboratory", "mesh"}) {
    EXPECT_NE(alone.out.find("\n" + std::string(command) + " "), std::string::npos) << command;
    EXPECT_NE(alone.out.find("\n            tdbd " + std::string(command) + " "), std::string::npos)
        << command;
  }
}

/// Two lines for each command, beside the first, the last two and empty ones between.
TEST(FirstWords, none_show_an_example_that_is_one_line) {
  const std::string shown = battery::run_tdbd({}).out, before = "\n            tdbd ";
  long commands = 0;
  for (auto at = shown.find(before); at != std::string::npos; at = shown.find(before, at + 1))
    ++commands;
  EXPECT_GE(commands, 11);
  EXPECT_EQ(std::ranges::count(shown, '\n'), 2 * commands + 5) << shown;
}

TEST(FirstWords, help_of_a_command_is_the_commands_help) {
  const auto o = battery::run_tdbd({"help", "run"});
  EXPECT_EQ(o.exit_code, 0);
  EXPECT_EQ(o.out, battery::run_tdbd({"run", "--help"}).out);
  EXPECT_NE(o.out.find("--set KEY=VALUE "), std::string::npos);
  EXPECT_EQ(o.out.find("..."), std::string::npos);
}

TEST(FirstWords, a_wrong_one_names_the_right_one) {
  expect_told({"rnu"}, "found the command rnu, expected run? (tdbd without a command lists all)");
  expect_told({"help", "convrge"},
              "found the command convrge, expected converge? (tdbd without a command lists all)");
  expect_told(
      {"drill"},
      "found the command drill, expected one of new, run, rotate, string, converge, calibrate, "
      "check, keys, bit, laboratory, sweep, curve, mesh, draw, page, report, compare");
  // three slips are too many, and none of its letters may be right by chance
  for (const std::string word : {"q", "r", "rx", "rotaxxx"})
    expect_told(
        {word},
        "found the command " + word +
            ", expected one of new, run, rotate, string, converge, calibrate, "
            "check, keys, bit, laboratory, sweep, curve, mesh, draw, page, report, compare");
}

/// Options that no command follows are no way to do nothing.
TEST(FirstWords, without_a_command_are_rejected) {
  for (const std::string word : {"--", "--quiet"})
    expect_told({word}, "found no command, expected one; tdbd COMMAND --help lists its arguments");
}

TEST(FirstWords, a_command_without_its_case_names_the_missing_argument) {
  for (const std::string command : {"run", "rotate"})
    expect_told({command}, "found no case, expected a case file, or --resume FOLDER");
}

TEST(FirstWords, wrong_words_are_reported_as_found_and_expected) {
  struct Refused {
    std::vector<std::string> words;
    std::string message;
  };
  const std::string top = cases + "slow-top.toml";
  const std::vector<Refused> all{
      {{"check"}, "found no case, expected one"},
      {{"converge", top, "--over", "time.step"}, "found no --levels, expected one"},
      {{"converge", top, "--levels", "3", "--over"}, "--over: found nothing, expected KEY"},
      {{"converge", top, "--levels", "1", "--over", "time.step"},
       "--levels: found 1, expected 2 to 60"},
      {{"converge", top, "--levels", "3", "--over", "time.step", "--factor", "two"},
       "--factor: found two, expected a number"},
      {{"run", top, "--threads", "some"}, "--threads: found some, expected 1 to 1024"},
      {{"run", top, "--threads"}, "--threads: found nothing, expected INT in [1 - 1024]"},
      {{"run", top, "--threads", "1", "--threads", "2"}, "--threads: found 2 times, expected once"},
      {{"run", top, "--resume", "results"}, "found case and --resume, expected one of them"},
      {{"bit", top, "--format", "jpg"}, "--format: found jpg, expected {ply,off,obj,stl}"}};
  for (const Refused& r : all)
    expect_told(r.words, r.message + "; tdbd COMMAND --help lists its arguments");
}

/// A file that is given to a command of another kind.
struct Mistaken {
  std::vector<std::string> words;  ///< the second is the file
  std::string found, table, expected, command;
};

TEST(FirstWords, a_file_of_another_kind_names_its_command) {
  const std::string top = cases + "slow-top.toml", drill = cases + "bit-b-steady.toml",
                    bit = cases + "bits/bit-b.toml",
                    fit = TDBD_SOURCE_DIR "/validation/cases/lab-bc-a.toml";
  const std::string body = "a body to rotate", hole = "a case to drill";
  const std::string both = hole + " or " + body;
  const std::vector<Mistaken> all{
      {{"run", top}, body, "body", hole, "rotate"},
      {{"rotate", drill}, hole, "motion", body, "run"},
      {{"run", bit}, "a bit", "cutters", hole, "bit"},
      {{"bit", drill}, hole, "motion", "a bit", "run"},
      {{"check", fit}, "a calibration", "calibration", both + " or a drill string", "calibrate"},
      {{"calibrate", top}, body, "body", "a calibration", "rotate"},
      {{"laboratory", top, "-o", "none.csv"}, body, "body", "a synthetic laboratory", "rotate"},
      {{"converge", bit, "--over", "time.step", "--levels", "3"}, "a bit", "cutters", both, "bit"}};
  for (const Mistaken& m : all)
    expect_told(m.words, m.words[1] + ": found " + m.found + ", with a table [" + m.table +
                             "], expected " + m.expected + "; try: tdbd " + m.command + " " +
                             m.words[1]);
}

TEST(FirstWords, a_setting_without_its_option_is_reported) {
  const std::string drill = cases + "bit-b-steady.toml";
  expect_told({"check", drill, "--set", "time.revolutions=2", "time.step=1 ms"},
              "found time.step=1 ms without --set, expected --set 'time.step=1 ms'");
  for (const std::string word : {"more", "--more=1"})
    expect_told(
        {"check", drill, word},
        "found " + word +
            ", which is not an argument of the command; tdbd COMMAND --help lists its arguments");
  const auto o = battery::run_tdbd(
      {"check", "--set", "time.revolutions=2", drill, "--set", "rock.edge_length=8 mm"});
  EXPECT_EQ(o.exit_code, 0) << o.err;
}

TEST(FirstWords, a_number_a_thousand_times_too_large_suggests_its_unit) {
  expect_told({"check", cases + "bit-b-steady.toml", "--set", "rock.edge_length=2.5"},
              "--set: rock.edge_length: found 2.5, expected length in m, in [1e-05, 0.1]; without "
              "a unit it is in m: did you mean \"2.5 mm\" or \"2.5 in\"?");
  // no question if a unit was given or a thousandth is out of range too
  expect_told({"check", cases + "bit-b-steady.toml", "--set", "rock.edge_length=2.5 m"},
              "--set: rock.edge_length: found \"2.5 m\", expected length in m, in [1e-05, 0.1]");
  expect_told({"check", cases + "bit-b-steady.toml", "--set", "rock.edge_length=-2.5"},
              "--set: rock.edge_length: found -2.5, expected length in m, in [1e-05, 0.1]");
}

TEST(FirstWords, help_of_an_unknown_option_is_an_error) {
  expect_told(
      {"help", "--mna"},
      "found the command --mna, expected one of new, run, rotate, string, converge, calibrate, "
      "check, keys, bit, laboratory, sweep, curve, mesh, draw, page, report, compare");
}

TEST(FirstWords, version_has_the_provenance_of_a_summary) {
  const auto o = battery::run_tdbd({"--version"});
  EXPECT_EQ(o.exit_code, 0);
  for (const char* line : {"tdbd 1", "\ncommit ", "\ncompiler ", "\nflags "})
    EXPECT_NE(o.out.find(line), std::string::npos) << o.out;
}

}  // namespace tdbd::app::first_words_test
