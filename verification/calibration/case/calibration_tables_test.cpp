#include <gtest/gtest.h>

#include "calibration/case/calibration_case.hpp"
#include "calibration/laboratory/laboratory.hpp"
#include "core/read_file.hpp"

namespace tdbd::calibration::calibration_tables_test {

/// `tdbd keys --markdown` makes the page of them and of those of cases.
TEST(CalibrationTables, are_on_the_page_of_keys) {
  const std::string page = read_file(TDBD_SOURCE_DIR "/src/simulation/case/KEYS.md", "a page");
  for (const auto& tables : {calibration_tables(), laboratory_tables()})
    for (const KeyTable& table : tables)
      EXPECT_NE(page.find(keys_as_markdown(std::vector{table})), std::string::npos) << table.name;
}

}  // namespace tdbd::calibration::calibration_tables_test
