#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/whole_file.hpp"
#include "simulation/result/run.hpp"
#include "sweep/point/run_point.hpp"
#include "sweep/sweep.hpp"
#include "sweep/table/journal.hpp"
#include "verification/sweep/small_design.hpp"

namespace tdbd::sweep::filtered_sweep_test {

namespace fs = std::filesystem;

/// The planar model judges all points; those with the best results are run, by any process, with a
/// sample of the others and the unchanged case.
TEST(FilteredSweep, runs_what_the_planar_model_finds_best) {
  const fs::path folder = empty_folder("filter");
  const std::string turned =
      "[[factors]]\nkey = \"bit.set.adjust.blade.2.azimuth\"\nfrom = \"-6 deg\"\nto = \"6 deg\"\n"
      "count = 7\n";
  const std::string filter = "[filter]\nfigure = \"imbalance\"\nkeep = 2\n";
  const Design d = design_from(folder, small_hole(turned + filter));
  const SweepResult whole = swept(d, folder / "t.nc");
  EXPECT_EQ(whole.points, 4);
  ASSERT_TRUE(whole.filter);
  EXPECT_EQ(whole.filter->figure, "wob_mean_n");
  EXPECT_EQ(whole.filter->points, 4);
  EXPECT_TRUE(std::isfinite(whole.filter->of_all));
  std::string judge = small_hole(turned);
  judge.replace(judge.find("figures = [") + 11,
                judge.find("]\n[set]") - judge.find("figures = [") - 11, "\"imbalance\"");
  judge.insert(judge.find("figures"), "command = \"planar\"\n");
  const Design planar = design_from(folder, judge);
  swept(planar, folder / "p.nc");
  const PointRecords found = read_journals(points_folder(folder / "p.nc"));
  std::vector<double> figure;
  for (const std::string& key : point_keys(planar, points_of(planar)))
    figure.push_back(found.at(key).outcome.figures[0]);
  const std::vector<KeptAs> kept = judged_by(*d.filter, figure).kept;
  EXPECT_EQ(std::ranges::count(kept, KeptAs::sample), 1);
  const PointRecords records = read_journals(points_folder(folder / "t.nc"));
  const std::vector<std::string> keys = point_keys(d, points_of(d));
  for (std::size_t i = 0; i < keys.size(); ++i)
    EXPECT_EQ(records.contains(keys[i]), kept[i] != KeptAs::left_out) << i;
  swept(d, folder / "s.nc", 1, {2, 2});
  EXPECT_FALSE(fs::exists(folder / "s.nc"));
  swept(d, folder / "s.nc", 1, {1, 2});
  EXPECT_EQ(text_of(folder / "s.nc"), text_of(folder / "t.nc"));
  EXPECT_EQ(text_of(folder / "s.csv"), text_of(folder / "t.csv"));
  EXPECT_NE(text_of(folder / "t.csv").find(",left-out,"), std::string::npos);
  EXPECT_EQ(text_of(folder / "s_filter.csv"), text_of(folder / "t_filter.csv"));
}

/// The case without the factors is run although no point is it, and its results are those of a run.
TEST(FilteredSweep, runs_the_unchanged_case) {
  const fs::path folder = empty_folder("unchanged");
  const std::string factor =
      "[[factors]]\nkey = \"bit.set.adjust.blade.2.azimuth\"\nvalues = [\"5 deg\", \"6 deg\"]\n";
  const Design d = design_from(
      folder, small_hole(factor + "[filter]\nfigure = \"imbalance\"\nkeep = 1\nsamples = 0\n"));
  const SweepResult r = swept(d, folder / "t.nc");
  EXPECT_EQ(r.points, 2);
  simulation::RunOptions options;
  options.folder = folder / "single";
  simulation::run(simulation::read_case(d.case_file, d.fixed), options);
  const auto summary = nlohmann::ordered_json::parse(text_of(options.folder / "summary.json"));
  ASSERT_TRUE(r.filter);
  EXPECT_EQ(r.filter->unchanged_figure, summary["wob_mean_n"]);
  EXPECT_EQ(r.filter->unchanged_message, "");
}

/// A factor that the case cannot do without: the sweep continues, and the report states why.
TEST(FilteredSweep, states_why_the_unchanged_case_fails) {
  const fs::path folder = empty_folder("no_unchanged");
  std::string text = small_hole(
      "[[factors]]\nkey = \"time.step\"\nvalues = [\"1 ms\"]\n"
      "[filter]\nfigure = \"imbalance\"\nkeep = 1\nsamples = 0\n");
  const fs::path own = folder / "case.toml";
  std::string shipped = text_of(TDBD_SOURCE_DIR "/cases/bit-b-6000psi.toml");
  shipped.replace(shipped.find("bits/bit-b.toml"), 15, TDBD_SOURCE_DIR "/cases/bits/bit-b.toml");
  shipped.replace(shipped.find("step = \"1 ms\""), 13, "step = \"-1 ms\"");
  write_text(own, shipped);
  const std::string old = TDBD_SOURCE_DIR "/cases/bit-b-6000psi.toml";
  text.replace(text.find(old), old.size(), own.string());
  const SweepResult r = swept(design_from(folder, text), folder / "t.nc");
  EXPECT_TRUE(r.written);
  EXPECT_EQ(r.failed, 0);
  ASSERT_TRUE(r.filter);
  EXPECT_NE(r.filter->unchanged_message.find("time.step"), std::string::npos);
}

}  // namespace tdbd::sweep::filtered_sweep_test
