#include "bit/report/tracking_report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bit/cone/tracking.hpp"
#include "bit/files/bit_reading.hpp"

namespace tdbd::bit::tracking_report_test {

/// Of each cone by its own rows, and of them alone.
TEST(TrackingReport, gives_each_cone_the_shares_of_its_rows) {
  const Bit bit = read(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml");
  const ConeOperation operation = cone_operation(bit, {}, 5e-3);
  nlohmann::ordered_json file = {{"cones", nlohmann::ordered_json::array()}};
  for (const Cone& cone : bit.cones)
    file["cones"].push_back(
        {{"rows", std::vector<nlohmann::ordered_json>(cone.layout.rows.size(),
                                                      nlohmann::ordered_json::object())}});
  add_tracking(bit, operation, file);
  const auto rows = bit_rows(bit, operation.penetration);
  const auto shares =
      tracking(rows, operation.cone_speeds, {.penetration = operation.penetration, .lags = 6});
  for (std::size_t k = 0; k < bit.cones.size(); ++k) {
    std::vector<TrackingShare> own;
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (rows[i].cone == static_cast<int>(k)) own.push_back(shares[i]);
    const TrackingShare expected = combined(own);
    EXPECT_EQ(file["cones"][k]["tracking_share_by_lag"].get<std::vector<double>>(), expected.share);
    EXPECT_EQ(file["cones"][k]["tracking_share_random_phase"].get<double>(), expected.random_phase);
  }
}

}  // namespace tdbd::bit::tracking_report_test
