#include <algorithm>
#include <cmath>
#include <numbers>

#include "claims/example_bits.hpp"
#include "claims/rock_runs.hpp"
#include "core/tolerance.hpp"
#include "reference/bit/radial_plane_engagement.hpp"
#include "reference/mesh/self_intersections.hpp"

/// Claims of chapter 4 on a long hole: 75 mm (3 in) by bit B, 9 revolutions of 8.3 mm on a mesh of
/// 3 mm edges.
namespace tdbd::claims::rock_drilling_test {

class LongHole : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    case_ = new simulation::Case(
        rock_case("bit-b-steady", {"rock.edge_length='3 mm'", "time.revolutions=9",
                                   "time.step='5 ms'", "motion.rate_of_penetration='60 m/h'"}));
    hole_ = new simulation::Simulation(simulation::start(*case_));
    start_triangles_ = hole_->state.rock.surface.triangle_count();
    while (hole_->state.steps_done < case_->time.steps) {
      simulation::step(*case_, *hole_);
      moves_ += hole_->state.cut.moved;
    }
  }
  static void TearDownTestSuite() {
    delete hole_;
    delete case_;
  }
  static inline simulation::Case* case_ = nullptr;
  static inline simulation::Simulation* hole_ = nullptr;
  static inline long moves_ = 0, start_triangles_ = 0;
};

TEST_F(LongHole, closes_the_ledger_of_prisms) {
  record_bound("chapter4/volume",
               "bit B, 75 mm of hole: prisms + change by maintenance against the change of the "
               "hole, relative",
               simulation::ledger_defect(*hole_), "1", tolerance::ledger);
}

TEST_F(LongHole, removes_the_gage_circle_times_the_advance) {
  record_bound("chapter4/volume",
               "bit B at 3 mm edges, ninth revolution: volume removed against pi R^2 d, relative",
               std::abs(removed_in(*hole_, 8) / volume_per_revolution(*case_) - 1.0), "1", 1.5e-4);
}

TEST_F(LongHole, needs_few_operations) {
  record_bound("chapter4/few-operations",
               "bit B, 75 mm of hole: operations of 4.2.1 to 4.2.3 over moves of vertices",
               static_cast<double>(thesis_operations(*hole_)) / static_cast<double>(moves_), "1",
               few);
  record_bound("chapter4/few-operations",
               "bit B, 75 mm of hole: the same with flips and blunting, which are ours",
               static_cast<double>(operations(*hole_)) / static_cast<double>(moves_), "1",
               few_with_ours);
}

TEST_F(LongHole, needs_no_remeshing) {
  record_bound("chapter4/no-remeshing", "bit B, 75 mm of hole: pairs of triangles that intersect",
               static_cast<double>(
                   reference::self_intersecting_pairs(mesh::compact(hole_->state.rock.surface))),
               "1", 0.0);
  record_bound("chapter4/no-remeshing",
               "bit B, 75 mm of hole: volume disturbed by maintenance over volume removed",
               hole_->state.maintenance.volume_disturbed / hole_->state.ledger.removed.value(), "1",
               4.2e-5);
}

TEST_F(LongHole, keeps_its_mesh_good) {
  const std::vector<double> q = qualities(hole_->state.rock.surface);
  const auto below = [&q](double limit) {
    return static_cast<double>(std::ranges::lower_bound(q, limit) - q.begin()) /
           static_cast<double>(q.size());
  };
  record_bound("chapter4/long-term",
               "bit B, 75 mm of hole: share of triangles of quality below 0.1", below(0.1), "1",
               0.0);
  record_bound("chapter4/long-term",
               "bit B, 75 mm of hole: share of triangles of quality below 0.5", below(0.5), "1",
               0.0011);
}

/// Interior edges longer than maintenance may leave them.
enum class Waiting { left_out, counted };

/// The longest inner edge, m. An edge waits where an end does.
double longest_edge(const rock::Rock& rock, Waiting waiting) {
  const mesh::Surface& s = rock.surface;
  double longest = 0.0;
  for (int c = 0; c < 3 * s.triangle_slots(); ++c) {
    if (!s.triangle_is_alive(c / 3) || s.opposite_of(c) < 0) continue;
    const int a = s.vertex(mesh::next_corner(c)), b = s.vertex(mesh::previous_corner(c));
    const bool waits = rock.touched[at(a)] != 0 || rock.touched[at(b)] != 0;
    if (waits && waiting == Waiting::left_out) continue;
    longest = std::max(longest, (s.position(a) - s.position(b)).norm());
  }
  return longest;
}

/// Beside rock that waits to be left alone by the bit (maintenance.rest) edges are longer: the step in front of a cutter
/// is not divided for the next one to take it away.
TEST_F(LongHole, has_no_long_edge) {
  const rock::Rock& rock = hole_->state.rock;
  const double h = case_->rock.edge_length;
  record_bound("chapter4/equally-fine",
               "bit B, 75 mm of hole: longest edge over the length asked for, where no rock waits",
               longest_edge(rock, Waiting::left_out) / h, "1", case_->maintenance.longest_edge);
  record_bound(
      "chapter4/equally-fine",
      "bit B, 75 mm of hole: longest edge over the length asked for, steps before cutters included",
      longest_edge(rock, Waiting::counted) / h, "1", 2.0 * case_->maintenance.longest_edge);
}

/// Edge lengths of the bottom between two radii, over the requested length: median.
double median_edge(const simulation::Simulation& s, double from, double to) {
  const mesh::Surface& m = s.state.rock.surface;
  double bottom = -1e300;
  for (int v = 0; v < m.vertex_slots(); ++v)
    if (m.is_alive(v)) bottom = std::max(bottom, m.position(v).z());
  std::vector<double> lengths;
  for (int c = 0; c < 3 * m.triangle_slots(); ++c) {
    if (!m.triangle_is_alive(c / 3) || m.opposite_of(c) < c) continue;
    const Vec3 &a = m.position(m.vertex(mesh::next_corner(c))),
               &b = m.position(m.vertex(mesh::previous_corner(c)));
    const double r = 0.5 * (a + b).head<2>().norm();
    if (r >= from && r < to && a.z() > bottom - 0.06) lengths.push_back((a - b).norm());
  }
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

TEST_F(LongHole, is_equally_fine_from_the_axis_to_the_gage) {
  const double R = case_->bit.gage_radius, h = case_->rock.edge_length;
  struct Ring {
    const char* name;
    double from, to;
  };
  for (const Ring& ring : {Ring{"inner third", 0.0, R / 3}, Ring{"middle third", R / 3, 2 * R / 3},
                           Ring{"outer third", 2 * R / 3, R}})
    record_near("chapter4/equally-fine",
                fmt::format("bit B, 75 mm of hole: median edge of the bottom over the length asked "
                            "for, {} of radii",
                            ring.name),
                median_edge(*hole_, ring.from, ring.to) / h, 1.0, 0.14);
}

TEST_F(LongHole, has_the_pattern_that_the_cutters_make) {
  const double advance =
      volume_per_revolution(*case_) / (std::numbers::pi * std::pow(case_->bit.gage_radius, 2));
  const auto expected = reference::radial_plane_engagement(case_->bit, advance, 5e-5);
  std::vector<double> by_cutter(case_->bit.cutters.size(), 0.0), errors;
  for (std::size_t i = 0; i < case_->bit.parts.size(); ++i)
    if (const int k = case_->bit.parts[i].cutter; k >= 0)
      by_cutter[static_cast<std::size_t>(k)] += hole_->state.ledger.removed_by_revolution[8][i];
  errors.reserve(by_cutter.size());
  for (std::size_t k = 0; k < by_cutter.size(); ++k)
    if (const double v = expected.volume_per_revolution[k]; v > 0.01 * expected.total)
      errors.push_back(std::abs(by_cutter[k] / v - 1.0));
  ASSERT_GT(errors.size(), 10U);
  std::ranges::sort(errors);
  record_bound("chapter4/bottom-hole",
               "bit B at 3 mm edges: what a cutter removes against the classical radial plane, "
               "median of cutters, relative",
               errors[errors.size() / 2], "1", 0.02);
}

}  // namespace tdbd::claims::rock_drilling_test
