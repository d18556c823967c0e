#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "simulation/result/run.hpp"
#include "simulation/start/rock_start.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::simulation::estimate_test {

namespace fs = std::filesystem;

Case case_with(const std::vector<std::string>& overrides) {
  return read_case(TDBD_SOURCE_DIR "/cases/bit-b-6000psi.toml", overrides);
}

double bytes_in(const fs::path& folder) {
  double sum = 0.0;
  for (const auto& f : fs::recursive_directory_iterator(folder))
    if (f.is_regular_file()) sum += static_cast<double>(f.file_size());
  return sum;
}

/// Against runs with few and with many frames, and rows of one and of many steps.
TEST(RunEstimate, is_near_what_a_run_takes) {
  const std::vector<std::vector<std::string>> cases{
      {"rock.edge_length=0.006", "time.revolutions=0.4"},
      {"rock.edge_length=0.003", "time.revolutions=0.2", "output.frames_every=10"},
      {"rock.edge_length=0.006", "time.revolutions=0.4", "output.history_every=4"}};
  for (const auto& overrides : cases) {
    const Case c = case_with(overrides);
    Simulation tried = start(c);
    const RunEstimate e = estimate(c, tried);
    const fs::path folder = temporary_folder() + "tdbd_estimate";
    fs::remove_all(folder);
    RunOptions options;
    options.folder = folder;
    const RunSummary s = run(c, options);
    EXPECT_NEAR(e.triangles / static_cast<double>(s.rock_triangles_end), 1.0, 0.015);
    EXPECT_NEAR(e.disk_bytes / bytes_in(folder), 1.3, 0.3) << overrides.back();  // rather too much
    EXPECT_GT(e.steps_tried, 0);
  }
}

/// Half the edges: four times the triangles, and more memory.
TEST(RunEstimate, grows_with_triangles_and_frames) {
  const auto of = [](const std::vector<std::string>& overrides) {
    const Case c = case_with(overrides);
    Simulation s = start(c);
    return estimate(c, s);
  };
  const RunEstimate coarse = of({"rock.edge_length=0.008"}), fine = of({"rock.edge_length=0.004"});
  EXPECT_NEAR(fine.triangles / coarse.triangles, 4.0, 9e-3);
  EXPECT_GT(fine.memory_bytes, 2.0 * coarse.memory_bytes);
  // twice the frames, twice what they take, beside the bit's animation, which is there once
  const auto frames_of = [&](const std::string& every) {
    return of({"rock.edge_length=0.008", "output.frames_every=" + every}).disk_bytes;
  };
  EXPECT_NEAR((frames_of("5") - frames_of("10")) / (frames_of("10") - frames_of("20")), 2.0, 1e-12);
  EXPECT_GT(frames_of("20"), coarse.disk_bytes);
  // half the rows, half of what they take
  const auto rows_of = [&](const std::string& every) {
    return of({"rock.edge_length=0.008", "output.history_every=" + every}).disk_bytes;
  };
  EXPECT_NEAR((rows_of("2") - rows_of("4")) / (rows_of("4") - rows_of("8")), 2.0, 1e-12);
  EXPECT_GT(rows_of("2"), rows_of("4"));
}

/// Bytes of a triangle in a frame, in an animation, in the final surface, in each of two checkpoints;
/// of a number in a row of history.nc and of history.rows.
TEST(RunEstimate, adds_up_the_sizes_of_its_files) {
  for (const long frames_every : {0L, 7L})
    for (const long history_every : {1L, 5L}) {
      const Case c = case_with({"rock.edge_length=0.008",
                                "output.frames_every=" + std::to_string(frames_every),
                                "output.history_every=" + std::to_string(history_every)});
      Simulation s = start(c);
      s.state.steps_done = c.time.steps;
      const double steps = static_cast<double>(c.time.steps);
      const mesh::Surface& rock = s.state.rock.surface;
      const double triangles =
          static_cast<double>(rock.triangle_count()) + new_wall_requirements(c).triangles;
      double of_bit = 0.0;
      for (const bit::Part& p : c.bit.parts)
        of_bit += static_cast<double>(p.mesh_P.triangles.size());
      const double frames =
          frames_every > 0 ? 1.0 + steps / static_cast<double>(frames_every) : 1.0;
      const double numbers = 25.0 + 8.0 * static_cast<double>(c.bit.parts.size()) +
                             10.0 * static_cast<double>(c.bit.cutters.size());
      const double rows = steps / static_cast<double>(history_every);
      const double in_nc = history_every > 1 ? 2.0 * rows : 8.0 * 64.0 * std::ceil(rows / 64.0);
      const double expected = 43.0 * frames * triangles + (frames > 1.0 ? 63.0 : 43.0) * of_bit +
                              (25.0 + 2.0 * 55.0) * triangles + (in_nc + 8.0 * rows) * numbers +
                              18.0 * 25.0 * rows;
      const RunEstimate e = estimate(c, s);
      EXPECT_DOUBLE_EQ(e.triangles, triangles);
      EXPECT_NEAR(e.disk_bytes / expected, 1.0, 1e-14);
    }
}

/// Triangles at the end, the grid of the rock and that of the wall that will be made.
TEST(RunEstimate, adds_up_memory_of_triangles_and_cells) {
  const Case c = case_with({"rock.edge_length=0.008"});
  Simulation s = start(c);
  s.state.steps_done = c.time.steps;
  mesh::Box box;
  for (int v = 0; v < s.state.rock.surface.vertex_slots(); ++v)
    if (s.state.rock.surface.is_alive(v)) box.add(s.state.rock.surface.position(v));
  const double cells = rock_requirements(0.0, box, 0.008).cells + new_wall_requirements(c).cells;
  const RunEstimate e = estimate(c, s);
  EXPECT_NEAR(e.memory_bytes / (250.0 * e.triangles + 4.2 * cells), 1.0, 1e-14);
}

/// Nothing is left to be made.
TEST(RunEstimate, without_steps_to_try_has_no_seconds) {
  const Case c = case_with({"rock.edge_length=0.008"});
  Simulation s = start(c);
  s.state.steps_done = c.time.steps;
  const RunEstimate e = estimate(c, s);
  EXPECT_EQ(e.steps_tried, 0);
  EXPECT_EQ(e.seconds, 0.0);
}

}  // namespace tdbd::simulation::estimate_test
