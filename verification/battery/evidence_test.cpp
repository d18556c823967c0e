#include "battery/evidence.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "verification/core/temporary_folder.hpp"

namespace tdbd::battery::evidence_test {

namespace fs = std::filesystem;

/// Evidence of these tests goes into a folder of their own and away with it.
class EvidenceFile : public ::testing::Test {
 protected:
  EvidenceFile() {
    fs::remove_all(folder);
    setenv("TDBD_EVIDENCE", folder.c_str(), 1);
  }
  ~EvidenceFile() override {
    unsetenv("TDBD_EVIDENCE");
    fs::remove_all(folder);
  }

  std::string text(const std::string& file) const {
    std::ifstream in(folder / file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  const fs::path folder = tdbd::temporary_folder() + "tdbd_evidence_" +
                          ::testing::UnitTest::GetInstance()->current_test_info()->name();
  Evidence example{"chapter5/second-order",
                   "Order of the attitude, slow top (h = 0.01 s)",
                   1.0 / 3.0,
                   "1",
                   "2 +- 0.05",
                   Verdict::holds_with_limits};
};

TEST_F(EvidenceFile, contains_the_measurement_and_its_test) {
  record(example);
  const auto read = nlohmann::json::parse(
      text("chapter5/second-order/order-of-the-attitude-slow-top-h-0-01-s.json"));
  EXPECT_EQ(read["claim"], example.claim);
  EXPECT_EQ(read["what"], example.what);
  EXPECT_EQ(read["measured"].get<double>(), example.measured);  // bit for bit
  EXPECT_EQ(read["unit"], "1");
  EXPECT_EQ(read["limit"], "2 +- 0.05");
  EXPECT_EQ(read["verdict"], "holds with limits");
  EXPECT_EQ(read["test"], "EvidenceFile.contains_the_measurement_and_its_test");
  EXPECT_EQ(read["program"], "verification/battery/verify_evidence");
}

TEST_F(EvidenceFile, is_reproducible_and_leaves_no_other_file) {
  record(example);
  const std::string file = "chapter5/second-order/order-of-the-attitude-slow-top-h-0-01-s.json";
  const std::string first = text(file);
  record(example);
  EXPECT_EQ(first, text(file));
  EXPECT_FALSE(first.empty());
  const auto entries = fs::directory_iterator(folder / "chapter5/second-order");
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 1);
}

TEST_F(EvidenceFile, holds_a_table_row_by_row) {
  record_table("defect", {{{"drift", "split"}, {"h", 0.1}}, {{"drift", "lie-mean"}, {"h", 0.2}}});
  const auto read = nlohmann::json::parse(text("tables/defect.json"));
  EXPECT_EQ(read["test"], "EvidenceFile.holds_a_table_row_by_row");
  ASSERT_EQ(read["rows"].size(), 2u);
  EXPECT_EQ(read["rows"][1]["drift"], "lie-mean");
  EXPECT_EQ(read["rows"][1]["h"], 0.2);
}

TEST_F(EvidenceFile, is_rejected_without_content) {
  for (const std::string claim : {"", "Chapter 5", "../out", "chapter5/", "/chapter5", "a//b"}) {
    Evidence e = example;
    e.claim = claim;
    EXPECT_THROW(record(e), std::invalid_argument) << claim;
    EXPECT_THROW(record_table(claim, {}), std::invalid_argument) << claim;
  }
  Evidence nameless = example, infinite = example;
  nameless.what = " - ";
  EXPECT_THROW(record(nameless), std::invalid_argument);
  infinite.measured = std::numeric_limits<double>::infinity();
  EXPECT_THROW(record(infinite), std::invalid_argument);
  EXPECT_FALSE(fs::exists(folder));
}

TEST_F(EvidenceFile, is_an_error_when_it_cannot_be_written) {
  fs::create_directories(folder /
                         "chapter5/second-order/order-of-the-attitude-slow-top-h-0-01-s.json");
  EXPECT_THROW(record(example), std::runtime_error);
  const auto entries = fs::directory_iterator(folder / "chapter5/second-order");
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 1);  // nothing half-written stays
}

}  // namespace tdbd::battery::evidence_test
