#include <gtest/gtest.h>

#include "core/config/key_table.hpp"
#include "core/read_file.hpp"
#include "simulation/case/case_kind.hpp"

namespace tdbd::simulation::key_tables_test {

/// The documentation has every key of a case in its table and in its place.
TEST(KeyTables, are_those_of_the_documentation) {
  const std::string pages =
      read_file(TDBD_SOURCE_DIR "/src/simulation/case/KEYS.md", "the documentation of the keys");
  EXPECT_NE(pages.find(keys_as_markdown(all_tables())), std::string::npos);
}

}  // namespace tdbd::simulation::key_tables_test
