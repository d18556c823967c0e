#include "sweep/sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "bit/files/bit_file.hpp"
#include "bit/report/bit_report.hpp"
#include "core/error.hpp"
#include "core/read_file.hpp"
#include "io/whole_file.hpp"
#include "simulation/result/run.hpp"
#include "simulation/rotate/rotate_run.hpp"
#include "sweep/point/run_point.hpp"
#include "verification/sweep/small_design.hpp"

namespace tdbd::sweep::sweep_test {

namespace fs = std::filesystem;

const std::string rakes_and_rates =
    "[[factors]]\nkey = \"bit.set.adjust.back_rake\"\nvalues = [\"0 deg\", \"5 deg\"]\n"
    "[[factors]]\nkey = \"motion.rate_of_penetration\"\nfrom = \"10 m/h\"\nto = \"20 m/h\"\ncount "
    "= 2\n";

/// The table's figures are bitwise identical to those of the summary that `run` writes.
TEST(Sweep, figures_are_those_of_single_runs) {
  const fs::path folder = empty_folder("figures");
  const Design d = design_from(folder, small_hole(rakes_and_rates));
  ASSERT_TRUE(swept(d, folder / "t.nc").written);
  const Points points = points_of(d);
  const PointRecords records = read_journals(points_folder(folder / "t.nc"));
  const std::vector<std::string> keys = point_keys(d, points);
  for (long i = 0; i < points.count; ++i) {
    simulation::RunOptions options;
    options.folder = folder / std::to_string(i);
    simulation::run(simulation::read_case(d.case_file, overrides_at(d, points, i)), options);
    const auto summary = nlohmann::ordered_json::parse(text_of(options.folder / "summary.json"));
    const PointOutcome& point = records.at(keys[static_cast<std::size_t>(i)]).outcome;
    EXPECT_EQ(point.figures, summarize(summary, d.figures)) << i;
    EXPECT_EQ(point.case_hash, summary["case_hash"]) << i;
    EXPECT_GT(point.figures[0], 0.0);
  }
}

/// A level, an end of an interval, or a number of [set], in SI by mistake.
TEST(Sweep, doubts_numbers_without_a_unit_once_before_it_runs) {
  const fs::path folder = empty_folder("doubts");
  const Design d = design_from(
      folder, small_hole("[[factors]]\nkey = \"motion.rotary_speed\"\nvalues = [10, 60, 120]\n"
                         "[[factors]]\nkey = \"motion.rate_of_penetration\"\nfrom = 10\n"
                         "to = 20\ncount = 2\n"));
  std::vector<std::string> told;
  const std::atomic<bool> stop = true;
  SweepOptions options{.table = folder / "t.nc", .shard = {}, .interrupted = &stop};
  options.warn = [&](const std::string& doubt) {
    told.push_back(doubt.substr(doubt.find(": ") + 2));
  };
  EXPECT_EQ(run_sweep(d, options).done, 0);
  EXPECT_EQ(
      told,
      (std::vector<std::string>{
          "motion.rate_of_penetration: 10 without a unit is 10 m/s; did you mean \"10 m/h\" or "
          "\"10 "
          "ft/h\" or \"10 mm/s\"?",
          "motion.rate_of_penetration: 20 without a unit is 20 m/s; did you mean \"20 m/h\" or "
          "\"20 "
          "ft/h\" or \"20 mm/s\"?",
          "motion.rotary_speed: 120 without a unit is 120 rad/s; did you mean \"120 rpm\" or \"120 "
          "deg/s\"?"}));
}

TEST(Sweep, rotates_and_analyses_too) {
  const fs::path folder = empty_folder("commands");
  const Design top = design_from(folder, small_top());
  ASSERT_EQ(swept(top, folder / "top.nc").failed, 0);
  simulation::RotateOptions options;
  options.folder = folder / "single";
  simulation::rotate(
      simulation::read_rotate_case(top.case_file, overrides_at(top, points_of(top), 3)), options);
  const auto summary = nlohmann::ordered_json::parse(text_of(options.folder / "summary.json"));
  const PointRecords records = read_journals(points_folder(folder / "top.nc"));
  EXPECT_EQ(records.at(point_keys(top, points_of(top))[3]).outcome.figures,
            summarize(summary, top.figures));

  const Design deep =
      design_from(folder, "[sweep]\ncase = \"" TDBD_SOURCE_DIR
                          "/cases/bits/bit-b.toml\"\ncommand = \"bit\"\npenetration = \"3 mm\"\n"
                          "figures = [\"penetration_m_per_rev\"]\n"
                          "[[factors]]\nkey = \"adjust.blade.2.azimuth\"\nvalues = [\"5 deg\"]\n");
  swept(deep, folder / "deep.nc");
  EXPECT_EQ(
      read_journals(points_folder(folder / "deep.nc")).begin()->second.outcome.figures.front(),
      3e-3);

  const Design bits = design_from(
      folder, "[sweep]\ncase = \"" TDBD_SOURCE_DIR
              "/cases/bits/bit-b.toml\"\ncommand = \"bit\"\nfigures = [\"imbalance_of_unit_law\"]\n"
              "[[factors]]\nkey = \"adjust.blade.2.azimuth\"\nvalues = [\"0 deg\", \"5 deg\"]\n");
  ASSERT_EQ(swept(bits, folder / "bits.nc").failed, 0);
  const auto plain =
      bit::read_bit(bits.case_file, bit::DirectionRule::hybrid, bit::InsideRule::down);
  const auto analysis = nlohmann::ordered_json::parse(bit::analysis_json(plain.bit, {}));
  const PointRecords found = read_journals(points_folder(folder / "bits.nc"));
  const std::vector<std::string> keys = point_keys(bits, points_of(bits));
  EXPECT_EQ(found.at(keys[0]).outcome.figures[0], analysis["imbalance_of_unit_law"]);
  EXPECT_NE(found.at(keys[1]).outcome.figures[0], analysis["imbalance_of_unit_law"]);
}

/// The same records as those of a sweep, in the order of the list; found again afterwards.
TEST(Sweep, runs_a_list_of_points) {
  const fs::path folder = empty_folder("list");
  const Design d = design_from(folder, small_top());
  swept(d, folder / "t.nc");
  const PointRecords records = read_journals(points_folder(folder / "t.nc"));
  const std::vector<std::string> keys = point_keys(d, points_of(d));
  const std::vector<std::vector<std::string>> list{overrides_at(d, points_of(d), 4),
                                                   overrides_at(d, points_of(d), 1)};
  const auto found = run_listed(d, list, {folder / "l.nc", {}, 2});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0]->outcome.figures, records.at(keys[4]).outcome.figures);
  EXPECT_EQ(found[1]->outcome.figures, records.at(keys[1]).outcome.figures);
  std::atomic<bool> interrupted = true;
  SweepOptions options{folder / "l.nc", {}, 1, &interrupted};
  EXPECT_TRUE(run_listed(d, list, options)[0]);
  options.table = folder / "other.nc";
  EXPECT_FALSE(run_listed(d, list, options)[0]);
}

/// Bitwise identical on one thread and on two, in one process and in three shards.
TEST(Sweep, table_has_the_same_bytes_however_it_is_made) {
  const fs::path folder = empty_folder("bytes");
  const Design d = design_from(folder, small_hole(rakes_and_rates));
  swept(d, folder / "one.nc");
  swept(d, folder / "two.nc", 2);
  for (long i = 3; i >= 1; --i) {
    const SweepResult r = swept(d, folder / "shards.nc", 1, {i, 3});
    EXPECT_EQ(r.of_shard, i == 1 ? 2 : 1);
    EXPECT_EQ(r.written, i == 1);
    EXPECT_EQ(fs::exists(folder / "shards.nc"), i == 1);
  }
  for (const char* kind : {".nc", ".csv"}) {
    EXPECT_EQ(text_of(folder / (std::string("one") + kind)),
              text_of(folder / (std::string("two") + kind)));
    EXPECT_EQ(text_of(folder / (std::string("one") + kind)),
              text_of(folder / (std::string("shards") + kind)));
  }
}

/// The process that finds all points done writes the table, also if several do at the same time.
TEST(Sweep, shards_that_end_together_all_write_the_table) {
  const fs::path folder = empty_folder("together");
  const Design d = design_from(folder, small_top());
  swept(d, folder / "t.nc");
  const std::string table = text_of(folder / "t.csv");
  constexpr int shards = 4, times = 50;
  std::atomic<int> written = 0;
  {
    std::vector<std::jthread> running;
    for (int i = 1; i <= shards; ++i)
      running.emplace_back([&, i] {
        for (int k = 0; k < times; ++k) try {
            written += swept(d, folder / "t.nc", 1, {i, shards}).written ? 1 : 0;
          } catch (const std::exception& e) {
            ADD_FAILURE() << e.what();
          }
      });
  }
  EXPECT_EQ(written, shards * times);
  EXPECT_EQ(text_of(folder / "t.csv"), table);
}

/// Points whose runs end before output.means_from have no means. The command warns about them.
TEST(Sweep, counts_points_without_values) {
  std::string text = small_hole(
      "[[factors]]\nkey = \"output.means_from\"\nvalues = [\"0.01 s\", \"1 s\", \"2 s\"]\n");
  const std::string fixed = "output.means_from = \"0.01 s\"\n";
  text.erase(text.find(fixed), fixed.size());
  const fs::path folder = empty_folder("without_values");
  const SweepResult r = swept(design_from(folder, text), folder / "t.nc");
  EXPECT_EQ(r.done, 3);
  EXPECT_EQ(r.without_values, 2);
}

/// What is done is done: nothing is run again, of a larger design only what is new.
TEST(Sweep, continues_with_existing_points) {
  const fs::path folder = empty_folder("again");
  swept(design_from(folder, small_top()), folder / "t.nc");
  const SweepResult again = swept(design_from(folder, small_top()), folder / "t.nc");
  EXPECT_EQ(again.found, 6);
  std::string more = small_top();
  more.replace(more.find("[2, 8]"), 6, "[2, 4, 8]");
  const SweepResult larger = swept(design_from(folder, more), folder / "t.nc");
  EXPECT_EQ(larger.points, 9);
  EXPECT_EQ(larger.found, 6);
}

/// A case or bit that changed makes all points new.
TEST(Sweep, detects_changed_files) {
  const fs::path folder = empty_folder("content");
  const fs::path own = folder / "top.toml";
  fs::copy_file(TDBD_SOURCE_DIR "/cases/slow-top.toml", own);
  std::string text = small_top();
  const std::string shipped = TDBD_SOURCE_DIR "/cases/slow-top.toml";
  text.replace(text.find(shipped), shipped.size(), own.string());
  swept(design_from(folder, text), folder / "t.nc");
  std::ofstream(own, std::ios::app) << "# another byte\n";
  EXPECT_EQ(swept(design_from(folder, text), folder / "t.nc").found, 0);
}

/// A file that only the second level of a factor names, whichever factor that is.
TEST(Sweep, detects_changed_files_of_every_factor) {
  const fs::path folder = empty_folder("factor_content");
  const std::string shipped = TDBD_SOURCE_DIR "/cases/bits/bit-a.toml";
  const fs::path own = folder / "own.toml";
  fs::copy_file(TDBD_SOURCE_DIR "/cases/bits/bit-a.csv", folder / "bit-a.csv");
  const std::string rate =
      "[[factors]]\nkey = \"motion.rate_of_penetration\"\nvalues = [\"10 m/h\"]\n";
  const std::string bits =
      "[[factors]]\nkey = \"bit.file\"\nvalues = [\"" + shipped + "\", \"" + own.string() + "\"]\n";
  for (const std::string& factors : {rate + bits, bits + rate}) {
    write_text(own, text_of(shipped));
    swept(design_from(folder, small_hole(factors)), folder / "t.nc");
    EXPECT_EQ(swept(design_from(folder, small_hole(factors)), folder / "t.nc").found, 2);
    std::ofstream(own, std::ios::app) << "# another byte\n";
    EXPECT_EQ(swept(design_from(folder, small_hole(factors)), folder / "t.nc").found, 0);
  }
}

TEST(Sweep, continues_if_the_first_point_fails) {
  const fs::path folder = empty_folder("first_fails");
  const Design d = design_from(
      folder, small_hole("[[factors]]\nkey = \"time.step\"\nvalues = [\"1 s\", \"1 ms\"]\n"));
  EXPECT_EQ(swept(d, folder / "t.nc").failed, 1);
}

/// The filter's points are judged in silence: what is counted are those that are run.
TEST(Sweep, reports_progress_in_points_that_are_run) {
  const fs::path folder = empty_folder("progress");
  const Design d =
      design_from(folder, small_hole("[[factors]]\nkey = \"bit.set.adjust.blade.2.azimuth\"\n"
                                     "values = [\"0 deg\", \"2 deg\", \"4 deg\", \"6 deg\"]\n"
                                     "[filter]\nfigure = \"imbalance\"\nkeep = 2\n"));
  std::vector<std::pair<long, long>> told;
  SweepOptions options{folder / "t.nc", {}, 1};
  options.progress = [&told](long done, long total) { told.emplace_back(done, total); };
  run_sweep(d, options);
  EXPECT_EQ(told, (std::vector<std::pair<long, long>>{{1, 4}, {2, 4}, {3, 4}, {4, 4}}));
}

TEST(Sweep, keeps_a_point_that_fails_with_its_message) {
  const fs::path folder = empty_folder("fails");
  const Design d = design_from(
      folder, small_hole("[[factors]]\nkey = \"time.step\"\nvalues = [\"1 ms\", \"1 s\"]\n"));
  const SweepResult r = swept(d, folder / "t.nc");
  EXPECT_TRUE(r.written);
  EXPECT_EQ(r.failed, 1);
  EXPECT_NE(r.first_failure.find("time.step"), std::string::npos);
  EXPECT_NE(text_of(folder / "t.csv").find(",failed,"), std::string::npos);
  EXPECT_EQ(swept(d, folder / "t.nc").found, 2);
}

/// A message names files from the design's folder, wherever that lies.
TEST(Sweep, fails_with_the_same_words_in_any_folder) {
  const auto table_in = [](const std::string& name) {
    const fs::path folder = empty_folder(name);
    fs::copy_file(TDBD_SOURCE_DIR "/cases/bit-b-6000psi.toml", folder / "case.toml");
    std::ofstream(folder / "wrong.toml") << "no = \"bit\"\n";
    std::string text = small_hole("[[factors]]\nkey = \"bit.file\"\nvalues = [\"" TDBD_SOURCE_DIR
                                  "/cases/bits/bit-b.toml\", \"wrong.toml\"]\n");
    const std::string shipped = TDBD_SOURCE_DIR "/cases/bit-b-6000psi.toml";
    text.replace(text.find(shipped), shipped.size(), "case.toml");
    EXPECT_EQ(swept(design_from(folder, text), folder / "t.nc").failed, 1);
    return text_of(folder / "t.csv");
  };
  const std::string text = table_in("here");
  EXPECT_EQ(text, table_in("a_folder_of_a_longer_name"));
  EXPECT_NE(text.find("wrong.toml:1: no: "), std::string::npos) << text;
  EXPECT_EQ(text.find("tdbd_sweep_here"), std::string::npos) << text;
}

/// A design that no point can obey is refused before anything is written.
TEST(Sweep, rejects_a_key_or_figure_that_the_case_does_not_have) {
  const fs::path folder = empty_folder("refuses");
  const auto message_of = [&](const std::string& text) -> std::string {
    try {
      swept(design_from(folder, text), folder / "t.nc");
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_NE(message_of(small_hole("[[factors]]\nkey = \"rock.edge\"\nvalues = [\"1 mm\"]\n"))
                .find("--set: rock.edge: found an unknown key"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(folder / "t.points"));
  std::string wrong = small_hole(rakes_and_rates);
  wrong.replace(wrong.find("wob_mean_n"), 10, "wob_men_n");
  EXPECT_NE(message_of(wrong).find(
                "found wob_men_n, expected a number of the summary, such as wob_mean_n"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(folder / "t.nc"));
}

TEST(Sweep, gives_up_points_under_way_when_interrupted) {
  const fs::path folder = empty_folder("interrupted");
  const Design d = design_from(folder, small_top());
  std::atomic<bool> stop = false;
  SweepOptions options;
  options.table = folder / "t.nc";
  options.interrupted = &stop;
  options.progress = [&](long done, long) { stop = done == 2; };
  const SweepResult r = run_sweep(d, options);
  EXPECT_TRUE(r.interrupted);
  EXPECT_FALSE(r.written);
  EXPECT_EQ(r.done, 2);
  EXPECT_EQ(swept(d, folder / "t.nc").found, 2);
}

/// While the first thread reports its point for a while, others would take the next ones.
TEST(Sweep, works_with_no_more_threads_than_told) {
  const fs::path folder = empty_folder("threads");
  std::set<std::thread::id> seen;
  SweepOptions options;
  options.table = folder / "t.nc";
  options.threads = 1;
  options.progress = [&](long done, long) {
    seen.insert(std::this_thread::get_id());
    if (done == 1) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  };
  EXPECT_TRUE(run_sweep(design_from(folder, small_top()), options).written);
  EXPECT_EQ(seen.size(), 1u);
}

/// In the middle of a point that would last for days.
TEST(Sweep, gives_up_a_long_point_when_interrupted) {
  const fs::path folder = empty_folder("long");
  std::string text = small_top();
  text.replace(text.find("time.duration = 2000"), 20, "time.duration = 2e9");
  std::atomic<bool> stop = false;
  SweepOptions options;
  options.table = folder / "t.nc";
  options.interrupted = &stop;
  std::jthread later([&stop] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    stop = true;
  });
  const SweepResult r = run_sweep(design_from(folder, text), options);
  EXPECT_TRUE(r.interrupted);
  EXPECT_EQ(r.done, 0);
  EXPECT_TRUE(read_journals(points_folder(folder / "t.nc")).empty());
}

TEST(Sweep, runs_to_its_end_without_an_interrupt) {
  const fs::path folder = empty_folder("not_interrupted");
  const std::atomic<bool> stop = false;
  SweepOptions options{folder / "t.nc", {}, 1};
  options.interrupted = &stop;
  EXPECT_TRUE(run_sweep(design_from(folder, small_hole(rakes_and_rates)), options).written);
}

}  // namespace tdbd::sweep::sweep_test
