#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/error.hpp"
#include "mesh/measures.hpp"
#include "simulation/result/run.hpp"
#include "simulation/start/rock_start.hpp"
#include "simulation/step/step.hpp"

namespace tdbd::simulation {
namespace {

// Bytes per item in files of TDBD (checked by `RunEstimate.is_near_what_a_run_takes`).
constexpr double frame_per_triangle = 43.0, animation_per_triangle = 20.0,
                 final_per_triangle = 25.0;
constexpr double checkpoint_per_triangle = 55.0;
constexpr double csv_per_number = 18.0, bit_level_columns = 25.0;
constexpr double numbers_per_part = 8.0, numbers_per_cutter = 10.0;

double triangles_of(const bit::Bit& bit) {
  double sum = 0.0;
  for (const bit::Part& p : bit.parts) sum += static_cast<double>(p.mesh_P.triangles.size());
  return sum;
}

double history_bytes(const Case& c, double steps) {
  const double numbers = bit_level_columns +
                         numbers_per_part * static_cast<double>(c.bit.parts.size()) +
                         numbers_per_cutter * static_cast<double>(c.bit.cutters.size());
  const double rows = steps / static_cast<double>(c.output.history_every);
  // Bytes of a number: in history.nc single values, or windows that are deflated; in history.rows.
  constexpr double whole = 8.0, window = 2.0, rows_of_chunk = 64.0;
  const bool has_windows = c.output.history_every > 1;
  const double in_nc =
      has_windows ? window * rows : whole * rows_of_chunk * std::ceil(rows / rows_of_chunk);
  const double in_rows = c.output.checkpoint_every != 0 ? whole * rows : 0.0;
  return (in_nc + in_rows) * numbers + csv_per_number * bit_level_columns * rows;
}

/// Returns the size of the profiles of a string on a chain.
double profile_bytes(const Case& c, double steps) {
  const auto& chained = c.drilling.system.chained;
  if (!chained || c.output.chain.profile_every == 0) return 0.0;
  constexpr double of_nodes = 5.0, of_elements = 2.0, deflated = 7.0;
  const double numbers = (of_nodes + of_elements) * chained->chain.count();
  return deflated * numbers * steps / static_cast<double>(c.output.chain.profile_every);
}

double disk_bytes(const Case& c, double triangles, double steps) {
  double frames = 1.0;
  if (c.output.frames_every > 0) frames += steps / static_cast<double>(c.output.frames_every);
  const double of_bit =
      frames > 1.0 ? frame_per_triangle + animation_per_triangle : frame_per_triangle;
  constexpr double two = 2.0;  // checkpoints, which are kept during the run
  return frames * frame_per_triangle * triangles + of_bit * triangles_of(c.bit) +
         final_per_triangle * triangles + two * checkpoint_per_triangle * triangles +
         history_bytes(c, steps) + profile_bytes(c, steps);
}

mesh::Box box_of(const mesh::Surface& s) {
  mesh::Box box;
  for (int v = 0; v < s.vertex_slots(); ++v)
    if (s.is_alive(v)) box.add(s.position(v));
  return box;
}

/// Measures the run time of one step in seconds, over some tenths of a second. A step that fails
/// ends the measurement; the run itself will report the failure.
double seconds_per_step(const Case& c, Simulation& s, long& tried) {
  constexpr double enough = 0.4;  // s
  const auto began = std::chrono::steady_clock::now();
  try {
    while (s.state.steps_done < c.time.steps && seconds_since(began) < enough) {
      step(c, s);
      ++tried;
    }
  } catch (const RunError&) {
    tried = 0;
  }
  return tried > 0 ? seconds_since(began) / static_cast<double>(tried) : 0.0;
}

}  // namespace

RunEstimate estimate(const Case& c, Simulation& s) {
  RunEstimate e;
  const double steps = static_cast<double>(c.time.steps - c.time.first);
  const RockRequirements wall = new_wall_requirements(c);
  e.triangles = static_cast<double>(s.state.start_triangles) + wall.triangles;
  const RockRequirements start =
      rock_requirements(0.0, box_of(s.state.rock.surface), c.rock.edge_length);
  e.memory_bytes = bytes_of_triangles(e.triangles) + start.bytes + wall.bytes -
                   bytes_of_triangles(wall.triangles);
  e.disk_bytes = disk_bytes(c, e.triangles, steps);
  e.seconds = steps * seconds_per_step(c, s, e.steps_tried);
  return e;
}

}  // namespace tdbd::simulation
