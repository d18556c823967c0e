#include "bit/cutter/cutter_table_text.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "bit/cutter/cutter_columns.hpp"
#include "bit/generate_design.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::bit {
namespace {

std::vector<Cutter> written_and_read(const std::vector<Cutter>& cutters) {
  const std::string path = tdbd::temporary_folder() + "tdbd-cutter-table-text.csv";
  std::ofstream(path) << cutter_table_text("bit", cutters);
  std::vector<Cutter> again = read_cutter_table(path, {});
  std::filesystem::remove(path);
  return again;
}

/// To the last bit: labels, sizes and poses.
bool same(const Cutter& a, const Cutter& b) {
  for (const NumberColumn& column : number_columns())
    if (a.*column.member != b.*column.member) return false;
  return a.id == b.id && a.blade == b.blade && a.zone == b.zone && a.X_BC.p == b.X_BC.p &&
         a.X_BC.R == b.X_BC.R;
}

RC_GTEST_PROP(cutter_table_text, keeps_every_bit_of_a_generated_table, ()) {
  const std::vector<Cutter> cutters = laid_out(any_design());
  const std::vector<Cutter> again = written_and_read(cutters);
  RC_ASSERT(cutters.size() == again.size());
  for (std::size_t k = 0; k < cutters.size(); ++k) RC_ASSERT(same(cutters[k], again[k]));
}

/// Their lengths come from a default that no number of millimetres gives; the first table rounds
/// it.
TEST(cutter_table_text, keeps_every_bit_of_the_example_tables_once_written) {
  for (const char letter : {'a', 'b', 'c'}) {
    const std::vector<Cutter> cutters = written_and_read(table(letter));
    const std::vector<Cutter> again = written_and_read(cutters);
    ASSERT_EQ(cutters.size(), again.size());
    for (std::size_t k = 0; k < cutters.size(); ++k) EXPECT_TRUE(same(cutters[k], again[k])) << k;
  }
}

}  // namespace
}  // namespace tdbd::bit
