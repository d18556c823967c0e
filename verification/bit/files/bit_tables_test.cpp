#include "bit/files/bit_tables.hpp"

#include <gtest/gtest.h>

#include "core/read_file.hpp"

namespace tdbd::bit::bit_tables_test {
namespace {

/// `tdbd keys --markdown` makes the page of them and of those of cases.
TEST(BitTables, are_on_the_page_of_keys_in_its_order) {
  const std::string page = read_file(TDBD_SOURCE_DIR "/src/simulation/case/KEYS.md", "a page");
  std::size_t before = 0;
  for (const KeyTable& table : bit_tables()) {
    const std::size_t at = page.find(keys_as_markdown(std::vector{table}), before);
    EXPECT_NE(at, std::string::npos) << table.name;
    if (at != std::string::npos) before = at;
  }
}

}  // namespace
}  // namespace tdbd::bit::bit_tables_test
