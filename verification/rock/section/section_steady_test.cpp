#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "bit/pdc/pdc_bit.hpp"
#include "bit/profile/exposure_profile.hpp"
#include "core/observed_order.hpp"
#include "reference/bit/radial_plane_engagement.hpp"
#include "rock/cut/cut_rock.hpp"
#include "rock/maintain/maintain.hpp"
#include "rock/section/section.hpp"
#include "rock/start/borehole.hpp"

namespace tdbd::rock::section_steady_test {

constexpr double turn = 2.0 * std::numbers::pi, mm = 1e-3;
constexpr double advance = 4.0 * mm;  // a revolution, which takes a second
constexpr long steps = 180;           // a revolution

/// Four sharp thin discs, each a quarter of a turn behind the last; the outer ones lean outwards,
/// so that what is behind their edges clears the wall and faces take all the rock.
bit::Bit small_bit() {
  constexpr std::array<double, 4> heights{0.0, 0.0, 0.5 * mm, 3.0 * mm};
  constexpr std::array<double, 4> profile_angles{0.0, 0.0, 0.3, 1.0};
  std::vector<bit::Cutter> cutters(4);
  for (std::size_t i = 0; i < 4; ++i) {
    bit::Cutter& c = cutters[i];
    c.id = static_cast<int>(i) + 1;
    c.length = 1.0 * mm;
    c.table_thickness = 0.5 * mm;
    c.tip_height = heights[i];
    c.profile_angle = profile_angles[i];
    c.diameter = 13.0 * mm;
    c.tip_radius = (4.0 + 4.0 * static_cast<double>(i)) * mm;
    c.azimuth = 0.25 * turn * static_cast<double>(i);
    c.back_rake = 0.15;
  }
  return bit::pdc_bit("small", cutters, {});
}

Pose pose_after(long step) {
  const double time = static_cast<double>(step) / steps;
  return rotation::carried({Vec3(0, 0, turn), Vec3(0, 0, advance)}, time);
}

Rock conforming_rock(const bit::Bit& bit, double edge_length) {
  std::vector<MeridianPoint> curve;
  for (const bit::ProfilePoint& p : bit::exposure_profile(bit.parts, 0.25 * edge_length))
    curve.push_back({p.r, p.z});
  const mesh::TriangleMesh m = borehole(with_wall(curve, 8.0 * mm), edge_length);
  mesh::Box reach = mesh::bounding_box(m);
  reach.hi.z() += 4.0 * advance;
  return make_rock(mesh::make_surface(m), 2.0 * edge_length, reach);
}

/// Mean volumes that the sections sweep in the third revolution, m3 a revolution.
std::vector<double> swept_by_sections(const bit::Bit& bit, double edge_length) {
  Rock rock = conforming_rock(bit, edge_length);
  const CuttingBit cutting = prepare_cutting_bit(bit);
  const rotation::Twist twist{Vec3(0, 0, turn), Vec3(0, 0, advance)};
  CutWorkspace cut_work;
  CutReport cut;
  MaintenanceWorkspace maintain_work;
  MaintenanceReport maintained;
  SectionWork section_work;
  std::vector<SectionFace> faces;
  faces.reserve(bit.cutters.size());
  for (std::size_t c = 0; c < bit.cutters.size(); ++c)
    faces.push_back(section_face(face_outline(bit.cutters[c], static_cast<int>(c), bit.parts)));
  std::vector<double> volumes(bit.cutters.size(), 0.0);
  for (long i = 0; i < 3 * steps; ++i) {
    cut_rock(rock, cutting, pose_after(i), pose_after(i + 1), cut_work, cut);
    if (i % 5 == 4) maintain(rock, limits_for(edge_length), maintain_work, maintained);
    if (i < 2 * steps) continue;
    for (std::size_t c = 0; c < volumes.size(); ++c)
      volumes[c] += section(rock, faces[c], pose_after(i + 1), twist,
                            {1.2 * edge_length, 1.0 * edge_length}, section_work)
                        .volume_rate /
                    steps;
  }
  return volumes;
}

/// The first and the last cutter are left out. Beside the axis the side of the disc behind the face
/// takes a part (section_noise_test). On the wall cusps should stay between
/// the passes of the last one, which columns of radii count as removed: its section is 3 % lower.
TEST(SteadySection, comes_to_what_the_radial_plane_gives_with_the_edge_length) {
  const bit::Bit bit = small_bit();
  const auto expected = reference::radial_plane_engagement(bit, advance, 0.02 * mm);
  const std::vector<double> edges{2.4 * mm, 1.7 * mm, 1.2 * mm, 0.85 * mm, 0.6 * mm};
  std::vector<double> errors;
  for (const double edge : edges) {
    const std::vector<double> volumes = swept_by_sections(bit, edge);
    double squares = 0.0;
    fmt::print("edges {:.2f} mm:", edge / mm);
    for (std::size_t c = 1; c + 1 < volumes.size(); ++c) {
      const double error = volumes[c] / expected.volume_per_revolution[c] - 1.0;
      fmt::print(" {:+.3f} %", 100.0 * error);
      squares += 0.5 * error * error;
    }
    errors.push_back(std::sqrt(squares));
    fmt::print("; rms {:.3f} %\n", 100.0 * errors.back());
  }
  const double order = least_squares_order(edges, errors);
  fmt::print("order {:.2f}\n", order);
  EXPECT_GE(order, 1.0);
  EXPECT_LT(errors.back(), 0.0026);  // of the volume
}

}  // namespace tdbd::rock::section_steady_test
