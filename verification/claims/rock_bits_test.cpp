#include <algorithm>
#include <cmath>

#include "claims/example_bits.hpp"
#include "claims/rock_runs.hpp"
#include "core/tolerance.hpp"
#include "reference/mesh/self_intersections.hpp"

/// Claims of chapter 4 on every bit of cases/ beside B, which the other tests drill with: short
/// holes on coarse meshes.
namespace tdbd::claims::rock_bits_test {

/// How far a bit's hole may be from the gage circle's volume; operations over moves of vertices, volume disturbed over
/// volume removed, and the share of poor triangles.
struct Room {
  double volume, operations, disturbed, poor;
};
constexpr Room of_a{.volume = 0.0028, .operations = few, .disturbed = 6.5e-6, .poor = 7e-4};
constexpr Room of_c{.volume = 0.0015, .operations = 0.035, .disturbed = 2.1e-5, .poor = 9e-5};
constexpr Room of_r{.volume = 0.009, .operations = 0.04, .disturbed = 3.5e-4, .poor = 0.01};

/// How a bit drills, and how near its last revolutions come to the gage circle's volume.
struct Short {
  const char* name;
  const char* file;
  const char* edge_length;
  std::vector<std::string> settings;
  std::size_t revolutions, last;
  Room room;
};

void PrintTo(const Short& run, std::ostream* out) { *out << run.name; }

class EveryBit : public testing::TestWithParam<Short> {};

/// All that must hold of the surface, whatever drilled it.
void record_surface(const std::string& hole, const simulation::Simulation& s, const Room& room) {
  record_bound("chapter4/volume",
               hole + ": prisms + change by maintenance against the change of the hole, relative",
               simulation::ledger_defect(s), "1", tolerance::ledger);
  record_bound(
      "chapter4/no-remeshing", hole + ": pairs of triangles that intersect",
      static_cast<double>(reference::self_intersecting_pairs(mesh::compact(s.state.rock.surface))),
      "1", 0.0);
  record_bound(
      "chapter4/no-remeshing", hole + ": volume disturbed by maintenance over volume removed",
      s.state.maintenance.volume_disturbed / s.state.ledger.removed.value(), "1", room.disturbed);
  const std::vector<double> q = qualities(s.state.rock.surface);
  const auto share_below = [&q](double limit) {
    return static_cast<double>(std::ranges::lower_bound(q, limit) - q.begin()) /
           static_cast<double>(q.size());
  };
  record_bound("chapter4/long-term", hole + ": share of triangles of quality below 0.1",
               share_below(0.1), "1", 0.0);
  record_bound("chapter4/long-term", hole + ": share of triangles of quality below 0.5",
               share_below(0.5), "1", room.poor);
}

TEST_P(EveryBit, drills_steadily) {
  const Short& run = GetParam();
  std::vector<std::string> settings = run.settings;
  settings.push_back(fmt::format("time.revolutions={}", run.revolutions));
  settings.push_back(fmt::format("rock.edge_length='{}'", run.edge_length));
  settings.insert(settings.end(), {"measure.section=off", "measure.contact=off"});
  const simulation::Case c = rock_case(run.file, settings);
  simulation::Simulation s = simulation::start(c);
  long moves = 0;
  while (s.state.steps_done < c.time.steps) {
    simulation::step(c, s);
    moves += s.state.cut.moved;
  }
  const std::string hole =
      fmt::format("{} at {} edges, {} revolutions", run.name, run.edge_length, run.revolutions);
  record_surface(hole, s, run.room);
  double removed = 0.0;
  for (std::size_t k = run.revolutions - run.last; k < run.revolutions; ++k)
    removed += removed_in(s, k);
  record_bound(
      "chapter4/volume",
      fmt::format("{}: volume of the last {} of them against pi R^2 d, relative", hole, run.last),
      std::abs(removed / (static_cast<double>(run.last) * volume_per_revolution(c)) - 1.0), "1",
      run.room.volume);
  record_bound("chapter4/few-operations",
               hole + ": operations of 4.2.1 to 4.2.3 over moves of vertices",
               static_cast<double>(thesis_operations(s)) / static_cast<double>(moves), "1",
               run.room.operations);
}

/// Settings of steps of 5 ms at a rate of penetration. Bit A makes 33 mm of hole. Bit C makes 25 mm
/// at half the rate: at 60 m/h, at 2 mm edges, the needle that its cutters leave at the axis folds
/// (src/rock/README.md, long runs).
std::vector<std::string> at_rate(const std::string& rate) {
  return {"time.step='5 ms'", "motion.rate_of_penetration='" + rate + "'"};
}

INSTANTIATE_TEST_SUITE_P(
    of, EveryBit,
    testing::Values(Short{"bit A", "bit-a-steady", "3 mm", at_rate("60 m/h"), 4, 2, of_a},
                    Short{"bit C", "bit-c-steady", "3 mm", at_rate("30 m/h"), 6, 3, of_c},
                    Short{"bit R", "bit-r-steady", "4 mm", {"time.step='4 ms'"}, 18, 6, of_r}),
    [](const auto& instance) {
      std::string name = instance.param.name;
      std::ranges::replace(name, ' ', '_');
      return name;
    });

}  // namespace tdbd::claims::rock_bits_test
