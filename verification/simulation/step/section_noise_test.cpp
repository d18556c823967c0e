#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bit/pdc/pdc_bit.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation::section_noise_test {

/// The figures of the second revolution of the standard workload.
std::vector<FaceSummary> second_revolution(const Case& c) {
  const long steps = std::lround(2.0 * std::numbers::pi / c.motion.rotary_speed / c.time.step);
  Simulation s = start(c);
  while (s.state.steps_done <= 2 * steps) step(c, s);
  EXPECT_EQ(s.statistics.faces.refused_deep + s.statistics.faces.refused_over_the_top, 0);
  return summarize(c.bit, s.statistics.faces);
}

double median(std::vector<double> x) {
  std::ranges::sort(x);
  return x[x.size() / 2];
}

double ratio(const FaceSummary& f) { return f.mean_swept_by_section / f.mean_removed; }

Case standard_workload() {
  return read_case(TDBD_SOURCE_DIR "/cases/standard-workload.toml", {"measure.contact=off"});
}

/// The first cutter is beside the axis: the next test.
TEST(SectionNoise, is_small_and_the_mean_is_the_volume_removed) {
  std::vector<double> noise, noise_of_volumes, ratios;
  double swept = 0.0, removed = 0.0;
  for (const FaceSummary& f : second_revolution(standard_workload())) {
    noise.push_back(f.rms_swept_by_section);
    noise_of_volumes.push_back(f.rms_removed);
    ratios.push_back(ratio(f));
    swept += f.mean_swept_by_section;
    removed += f.mean_removed;
  }
  fmt::print("rms of one step: section {:.2f} % (worst {:.2f} %), volume {:.1f} %\n",
             100 * median(noise), 100 * std::ranges::max(noise), 100 * median(noise_of_volumes));
  fmt::print("section over volume: median {:.4f}, first cutter {:.4f}, others {:.4f} to {:.4f}\n",
             median(ratios), ratios[0], *std::min_element(ratios.begin() + 1, ratios.end()),
             *std::max_element(ratios.begin() + 1, ratios.end()));
  fmt::print("of all cutters: {:.4f}\n", swept / removed);
  EXPECT_NEAR(swept / removed, 1.0, 7.6e-3);
  EXPECT_LT(median(noise), 0.011);
  EXPECT_NEAR(median(ratios), 1.0, 8.4e-3);
  for (std::size_t i = 1; i < ratios.size(); ++i) EXPECT_NEAR(ratios[i], 1.0, 0.01) << i;
}

/// On a circle that is small beside its thickness, the disc's side runs into rock behind the face
/// and removes what no section of the face sees: 3 % of a disc of 2 mm, nothing of a thin one.
TEST(SectionNoise, beside_the_axis_the_side_behind_the_face_takes_what_is_missing) {
  Case c = standard_workload();
  std::vector<bit::Cutter> cutters = c.bit.cutters;
  for (bit::Cutter& cutter : cutters) {
    cutter.length = 0.2e-3;
    cutter.table_thickness = 0.1e-3;
  }
  bit::PdcOptions options;
  options.meshing.rim_segments = 32;
  c.bit = bit::pdc_bit("thin", cutters, options);
  const double thin = ratio(second_revolution(c)[0]);
  fmt::print("section over volume: first cutter, 0.2 mm thick: {:.4f}\n", thin);
  EXPECT_NEAR(thin, 1.0, 4.4e-3);
}

}  // namespace tdbd::simulation::section_noise_test
