#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "rock/section.hpp"
#include "simulation/simulation.hpp"

namespace tdbd::simulation {
namespace {

double mean(const std::vector<double>& x) {
  return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

/// Over the mean.
double rms(const std::vector<double>& x) {
  const double m = mean(x);
  double squares = 0.0;
  for (const double y : x) squares += (y - m) * (y - m);
  return std::sqrt(squares / static_cast<double>(x.size())) / m;
}

/// What one cutter removed in each step, and what its section sweeps in a step there, m3.
struct Course {
  std::vector<double> removed, swept;
};

std::vector<Course> second_revolution(const Case& c) {
  const long steps = std::lround(2.0 * std::numbers::pi / c.motion.rotary_speed / c.time.step);
  const double edge = c.rock.edge_length;
  const rock::Twist twist{Vec3(0, 0, c.motion.rotary_speed),
                          Vec3(0, 0, c.motion.rate_of_penetration)};
  constexpr int rim_points = 32;  // of the case's discs
  std::vector<Course> courses(c.bit.cutters.size());
  std::vector<rock::SectionFace> faces;
  for (const bit::Cutter& cutter : c.bit.cutters)
    faces.push_back(rock::section_face(rock::face_outline(cutter, rim_points)));
  rock::SectionWork work;
  Simulation s = start(c);
  while (s.steps_done < 2 * steps) {
    step(c, s);
    if (s.steps_done <= steps) continue;
    for (Course& course : courses) course.removed.push_back(0.0);
    for (std::size_t p = 0; p < c.bit.parts.size(); ++p)
      if (const int cutter = c.bit.parts[p].cutter; cutter >= 0)
        courses[static_cast<std::size_t>(cutter)].removed.back() += s.cut.removed_by_part[p];
    const Pose X_WB = pose_at(c.motion, c.time.step * static_cast<double>(s.steps_done));
    for (std::size_t i = 0; i < courses.size(); ++i) {
      const auto now = rock::section(s.rock, faces[i], X_WB, twist, {1.2 * edge, 2.0 * edge}, work);
      courses[i].swept.push_back(now.volume_rate * c.time.step);
    }
  }
  return courses;
}

double median(std::vector<double> x) {
  std::ranges::sort(x);
  return x[x.size() / 2];
}

/// The first cutter is beside the axis, where part of its face goes backwards: bounded apart.
TEST(section_noise, is_small_and_the_mean_is_the_volume_removed) {
  const Case c = read_case(TDBD_SOURCE_DIR "/cases/standard-workload.toml", {});
  std::vector<double> noise, noise_of_volumes, ratios;
  for (const Course& course : second_revolution(c)) {
    noise.push_back(rms(course.swept));
    noise_of_volumes.push_back(rms(course.removed));
    ratios.push_back(mean(course.swept) / mean(course.removed));
  }
  fmt::print("rms of one step: section {:.2f} % (worst {:.2f} %), volume {:.1f} %\n",
             100 * median(noise), 100 * std::ranges::max(noise), 100 * median(noise_of_volumes));
  fmt::print("section over volume: median {:.4f}, first cutter {:.4f}, others {:.4f} to {:.4f}\n",
             median(ratios), ratios[0], *std::min_element(ratios.begin() + 1, ratios.end()),
             *std::max_element(ratios.begin() + 1, ratios.end()));
  EXPECT_LT(median(noise), 0.02);
  EXPECT_NEAR(median(ratios), 1.0, 0.01);
  EXPECT_NEAR(ratios[0], 1.0, 0.05);
  for (std::size_t i = 1; i < ratios.size(); ++i) EXPECT_NEAR(ratios[i], 1.0, 0.02) << i;
}

}  // namespace
}  // namespace tdbd::simulation
