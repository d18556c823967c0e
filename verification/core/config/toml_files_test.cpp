#include <rapidcheck/gtest.h>

#include <fstream>

#include "verification/core/config/config_mistakes.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::toml_files_test {

TEST(TomlFiles, that_are_missing_or_no_toml) {
  EXPECT_EQ(read_failure("/no/such.toml"),
            "/no/such.toml: found no such file, expected a TOML file");
  EXPECT_EQ(read_failure(tdbd::temporary_folder()),
            tdbd::temporary_folder() + ": found a folder, expected a TOML file");
  EXPECT_EQ(read_failure("/dev/null"), "/dev/null: found no regular file, expected a TOML file");
  const std::string path = write_temporary(".toml", "a = 1\nb = = 2\n");
  EXPECT_EQ(read_failure(path).rfind(path + ":2:5: found a syntax error, expected TOML: ", 0), 0u)
      << read_failure(path);
  const auto hint_of = [](const std::string& line) {
    const std::string failure = read_failure(write_temporary(".toml", "a = 1\n" + line + "\n"));
    const std::size_t at = failure.rfind("; ");
    return at == std::string::npos ? "" : failure.substr(at);
  };
  EXPECT_EQ(hint_of("edge_length = 5 mm"),
            "; texts and values with a unit have quotes: edge_length = \"5 mm\"");
  EXPECT_EQ(hint_of("kind = steady"),
            "; texts and values with a unit have quotes: kind = \"steady\"");
  EXPECT_EQ(hint_of("step = \"2 ms"), "; a text has a quote at both ends");
  EXPECT_EQ(hint_of("b = 1 2"), "");
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
TEST(TomlFiles, of_keys_and_tables_without_end) {
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
TEST(TomlFiles, of_keys_count_the_names_of_a_line) {
  const std::string longest = key_of(32), beyond = key_of(33);
  EXPECT_EQ(read_failure(write_temporary(".toml", "[" + longest + "]\n" + longest + " = 1\n")),
            "no error");
  EXPECT_EQ(read_failure(write_temporary(".toml", longest + " = 1\n")), "no error");
  const std::string path = write_temporary(".toml", beyond + " = 1\n");
  EXPECT_EQ(read_failure(path), path + ":1: found a key of more names, expected at most 32");
}

/// Arrays count as tables do.
TEST(TomlFiles, of_arrays_within_arrays) {
  std::string nested = "1";
  for (int k = 0; k < 50; ++k) nested = "[{" + key_of(5) + " = " + nested + "}]";
  const std::string path = write_temporary(".toml", "b = " + nested + "\n");
  EXPECT_EQ(read_failure(path), path + ":1: found a value in more tables, expected at most 256");
}

/// A table for each name of a key, one for each array and each of its tables: 1 + 42 x 6 + 3 is as deep as may be.
TEST(TomlFiles, of_values_that_are_one_table_too_deep) {
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

TEST(TomlFiles, dots_in_texts_comments_and_numbers_are_none_of_a_key) {
  const std::string dots(100, '.');
  const std::string path =
      write_temporary(".toml", "# " + dots + "\na = \"" + dots + "\"  # \"" + dots +
                                   "\nb = [1.0, 2.0]\n\"" + dots + "\" = 1\n");
  EXPECT_EQ(read_failure(path), "no error");
}

RC_GTEST_PROP(TomlFiles, any_bytes_are_a_file_or_an_input_error, (const std::string& bytes)) {
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

}  // namespace tdbd::toml_files_test
