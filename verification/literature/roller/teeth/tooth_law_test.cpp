#include "reference/literature/roller/teeth/tooth_law.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::reference::tooth_law_test {
namespace {

/// A worked table: mm, kN, mm.
ToothTable worked() {
  return {{0, 0.5e-3, 1e-3, 1.5e-3, 2e-3, 2.5e-3},
          {0, 2e3, 5e3, 9e3, 14e3, 20e3},
          {0, 1.5e-3, 2.6e-3, 3.5e-3, 4.3e-3, 5e-3}};
}

std::string message_of(const ToothLaw& law) {
  try {
    check_tooth_law(law, "Huang and Cawthorne");
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

/// A file that goes when the test ends.
struct TableFile {
  std::filesystem::path path;
  explicit TableFile(const std::string& text)
      : path(std::filesystem::temp_directory_path() /
             (std::string("tooth-law-") +
              testing::UnitTest::GetInstance()->current_test_info()->name() + ".csv")) {
    std::ofstream(path) << text;
  }
  ~TableFile() { std::filesystem::remove(path); }
  TableFile(const TableFile&) = delete;
  TableFile& operator=(const TableFile&) = delete;

  std::string message() const {
    try {
      read_tooth_table(path.string(), "Huang and Cawthorne");
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  }
};

TEST(ToothLaw, a_table_is_its_rows_and_straight_between_them) {
  const ToothLaw law = worked();
  EXPECT_EQ(tooth_force(law, 1.5e-3), 9e3);
  EXPECT_NEAR(tooth_force(law, 1.75e-3), 11.5e3, 1e-9);
  EXPECT_NEAR(crater_radius(law, 0.25e-3), 0.75e-3, 1e-15);
  EXPECT_EQ(tooth_force(law, -1e-3), 0.0);
  EXPECT_EQ(crater_radius(law, 0.0), 0.0);
  EXPECT_EQ(tooth_force(law, 9e-3), 20e3);
  EXPECT_EQ(deepest_known(law), 2.5e-3);
}

TEST(ToothLaw, a_power_is_a_power_and_its_crater_a_cap) {
  const ToothLaw law = PowerTooth{5000.0 / std::pow(1e-3, 1.5), 1.5, 6e-3};
  EXPECT_NEAR(tooth_force(law, 1e-3), 5000.0, 1e-9);
  EXPECT_NEAR(tooth_force(law, 4e-3), 40000.0, 1e-8);
  EXPECT_NEAR(crater_radius(law, 6e-3), 6e-3, 1e-15);
  EXPECT_NEAR(crater_radius(law, 1e-3), std::sqrt(11.0) * 1e-3, 1e-15);
  const ToothLaw slow = PowerTooth{5000.0 / std::pow(1e-3, 1.25), 1.25, 6e-3};
  EXPECT_NEAR(tooth_force(slow, 16e-3), 5000.0 * 32.0, 1e-6);
}

RC_GTEST_PROP(ToothLaw, neither_force_nor_crater_falls_with_depth, ()) {
  const ToothLaw law =
      *rc::gen::arbitrary<bool>() ? ToothLaw(worked()) : ToothLaw(PowerTooth{1e8, 1.5, 6e-3});
  const double a = *battery::number(-1.0, 8.0), b = *battery::number(0.0, 1.0);
  RC_ASSERT(tooth_force(law, (a + b) * 1e-3) >= tooth_force(law, a * 1e-3));
  RC_ASSERT(crater_radius(law, (a + b) * 1e-3) >= crater_radius(law, a * 1e-3));
}

TEST(ToothLaw, says_which_row_is_not_monotone) {
  ToothTable table = worked();
  EXPECT_EQ(message_of(table), "");
  table.force[3] = 4e3;
  EXPECT_EQ(
      message_of(table),
      "Huang and Cawthorne: table of single-tooth tests: row 4: force: found 4000 after 5000, "
      "expected a monotone table");
  table = worked();
  table.depth[2] = table.depth[1];
  EXPECT_NE(message_of(table).find("row 3: depth: found 0.0005 after 0.0005, expected depths that"),
            std::string::npos);
  table = worked();
  table.radius[0] = 1e-3;
  EXPECT_NE(message_of(table).find("row 1: crater_radius: found 0.001, expected 0"),
            std::string::npos);
  table.depth.pop_back();
  EXPECT_NE(message_of(table).find("found 5 depths, 6 forces and 6 radii"), std::string::npos);
  EXPECT_NE(message_of(PowerTooth{-1.0, 1.5, 6e-3}).find("the law's factor: found -1"),
            std::string::npos);
}

TEST(ToothLaw, is_read_in_the_units_of_its_header) {
  const TableFile file(
      "# synthetic\nforce [kN], depth [mm], crater_radius [in]\n0, 0, 0\n2, 0.5, 0.1\n");
  const ToothTable table = read_tooth_table(file.path.string(), "Huang and Cawthorne");
  EXPECT_EQ(table.depth[1], 0.5e-3);
  EXPECT_EQ(table.force[1], 2000.0);
  EXPECT_NEAR(table.radius[1], 2.54e-3, 1e-15);
  EXPECT_EQ(table.lines[1], 4);
}

TEST(ToothLaw, says_where_a_file_is_wrong) {
  const std::string header = "depth [mm], force [kN], crater_radius [mm]\n";
  EXPECT_NE(TableFile(header + "0, 0, 0\n1, 5, 2\n2, 4, 3\n")
                .message()
                .find(".csv:4: force: found 4000 after 5000, expected a monotone table"),
            std::string::npos);
  EXPECT_NE(TableFile(header + "0, 0, 0\n1, x, 2\n").message().find(":3: force: found x, expected"),
            std::string::npos);
  EXPECT_NE(TableFile(header + "0, 0\n").message().find(":2: crater_radius: found nothing"),
            std::string::npos);
  EXPECT_NE(TableFile("depth, force [kN], crater_radius [mm]\n0,0,0\n1,1,1\n")
                .message()
                .find(":1: depth: found"),
            std::string::npos);
  EXPECT_NE(TableFile("depth [mm], force [kN]\n0,0\n")
                .message()
                .find("crater_radius: found no such column"),
            std::string::npos);
  EXPECT_EQ(TableFile("").message().substr(0, 21), "Huang and Cawthorne: ");
}

}  // namespace
}  // namespace tdbd::reference::tooth_law_test
