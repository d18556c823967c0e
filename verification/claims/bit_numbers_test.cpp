#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "bit/bit.hpp"
#include "bit/cone/cone_parts.hpp"
#include "bit/cutter/cutter.hpp"
#include "bit/profile/bit_analysis.hpp"
#include "claims/example_bits.hpp"
#include "core/observed_order.hpp"
#include "core/random.hpp"
#include "mesh/measures.hpp"

/// Our claims of chapter 3: numbers of bits against closed forms.
namespace tdbd::claims::bit_numbers_test {

constexpr double pi = std::numbers::pi;
constexpr int trials = 200;

Vec3 any_point(Random& random, double lo, double hi) {
  return {random.uniform(lo, hi), random.uniform(lo, hi), random.uniform(lo, hi)};
}

mesh::TriangleMesh box(const Vec3& lo, const Vec3& size) {
  mesh::TriangleMesh m;
  m.positions.reserve(8);
  for (int k = 0; k < 8; ++k)
    m.positions.emplace_back(lo + size.cwiseProduct(Vec3(k & 1, (k >> 1) & 1, k >> 2)));
  m.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                 {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return m;
}

/// Relative difference of mass, centre and inertia to known ones, the worst; `size` about the
/// origin.
double difference(const bit::MassProperties& found, const bit::MassProperties& known, double size) {
  return std::max({std::abs(found.mass / known.mass - 1.0),
                   (found.centre - known.centre).norm() / size,
                   (found.inertia - known.inertia).norm() / (known.mass * size * size)});
}

double of_any_box(Random& random) {
  const Vec3 lo = any_point(random, -1, 1), size = any_point(random, 0.1, 2),
             s2 = size.cwiseProduct(size);
  const double mass = 3.0 * size.prod();
  const bit::MassProperties known{mass, lo + 0.5 * size,
                                  (mass / 12.0 * (Vec3::Constant(s2.sum()) - s2)).asDiagonal()};
  return difference(bit::mass_properties(box(lo, size), 3.0), known, lo.norm() + size.norm());
}

/// Edges along the axes: centre a quarter of each, Ixx = 3 m (b^2 + c^2)/80, Ixy = m a b/80.
double of_any_tetrahedron(Random& random) {
  const Vec3 e = any_point(random, 0.1, 2);
  mesh::TriangleMesh m;
  m.positions = {Vec3::Zero(), {e.x(), 0, 0}, {0, e.y(), 0}, {0, 0, e.z()}};
  m.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  bit::MassProperties known{3.0 * e.prod() / 6.0, 0.25 * e, Mat3::Zero()};
  known.inertia = known.mass / 80.0 * e * e.transpose();
  for (int i = 0; i < 3; ++i)
    known.inertia(i, i) = 3.0 * known.mass / 80.0 * (e.squaredNorm() - e[i] * e[i]);
  return difference(bit::mass_properties(m, 3.0), known, e.norm());
}

mesh::TriangleMesh prism(int corners) {
  return bit::surface_of_revolution({{0, 1, 1}, {0.5, 1, corners}, {0.5, -1, corners}, {0, -1, 1}});
}

/// A regular prism of radius 1/2 and height 2 along X: Ixx = m r^2 (2 + cos(2 pi/n))/6.
double of_prism(int corners) {
  const double mass = corners * 0.25 * std::sin(2 * pi / corners);
  const double axial = mass * 0.25 * (2 + std::cos(2 * pi / corners)) / 6;
  const Vec3 diagonal(axial, 0.5 * axial + mass / 3, 0.5 * axial + mass / 3);
  return difference(bit::mass_properties(prism(corners), 1.0),
                    {mass, Vec3::Zero(), diagonal.asDiagonal()}, 1.0);
}

TEST(BitNumbers, mass_properties_are_those_of_closed_forms) {
  Random random{3};
  double boxes = 0.0, tetrahedra = 0.0, prisms = 0.0;
  for (int k = 0; k < trials; ++k) {
    boxes = std::max(boxes, of_any_box(random));
    tetrahedra = std::max(tetrahedra, of_any_tetrahedron(random));
  }
  for (const int corners : {3, 8, 32, 128}) prisms = std::max(prisms, of_prism(corners));
  const auto record = [](const char* what, double found) {
    record_bound("ours/mass-properties", fmt::format("{}: mass, centre, inertia, relative", what),
                 found, "1", 1e-13);
  };
  record("200 boxes anywhere", boxes);
  record("200 tetrahedra", tetrahedra);
  record("regular prisms of 3 to 128 corners", prisms);
}

/// The order with which volumes converge to the smooth body's, over the number of segments.
template <class Volume>
void record_order(const std::string& what, double smooth, const Volume& volume) {
  constexpr std::array segments{16, 32, 64, 128, 256};
  std::vector<double> sizes, errors;
  sizes.reserve(segments.size());
  errors.reserve(segments.size());
  for (const int n : segments) {
    sizes.push_back(1.0 / n);
    errors.push_back(std::abs(volume(n) - smooth));
  }
  record_near("ours/mesh-order", what, observed_order(sizes, errors, smooth).order, 2.0, 0.02);
}

TEST(BitNumbers, meshes_converge_to_the_smooth_body_with_second_order) {
  bit::Cutter c = example("bit-b").cutters.front();
  const double r = 0.5 * c.diameter, inner = r - c.chamfer, depth = bit::chamfer_depth(c);
  const double cylinder = pi * r * r * (c.length - depth);
  const double frustum = pi * depth * (r * r + r * inner + inner * inner) / 3.0;
  const auto volume_of = [&c](std::size_t part) {
    return [&c, part](int n) {
      bit::CutterMeshing m;
      m.rim_segments = n;
      return mesh::enclosed_volume(cutter_parts(c, m).at(part).mesh_P);
    };
  };
  record_order("volume of a cutter's body against the cylinder's, 16 to 256 segments", cylinder,
               volume_of(2));
  record_order("volume of a cutter's chamfer against the frustum's, 16 to 256 segments", frustum,
               volume_of(1));
  record_order("axial inertia of a cylinder, 16 to 256 segments", pi / 16.0,
               [](int n) { return bit::mass_properties(prism(n), 1.0).inertia(0, 0); });
}

TEST(BitNumbers, cut_volumes_fill_the_hole) {
  constexpr double advance = 5e-3, width = 0.05e-3;
  for (const bit::Bit& b : fixed_cutter_bits()) {
    const bit::Engagement e = bit::engagement(b.cutters, advance, width);
    const auto uncut = static_cast<double>(std::ranges::count(e.cutting, 0));
    const double reach = e.column_width * static_cast<double>(e.cutting.size());
    const double hole = pi * advance * (reach * reach - std::pow(uncut * e.column_width, 2));
    const double sum = std::accumulate(e.volume.begin(), e.volume.end(), 0.0);
    record_bound(
        "ours/engagement",
        b.name + ", 5 mm a revolution: volumes of all cutters against the hole's, relative",
        std::abs(sum / hole - 1.0), "1", 1e-12);
  }
}

/// A flat, sharp cutter without rakes.
bit::Cutter flat_cutter(double radius, double tip_radius) {
  bit::Cutter c;
  c.diameter = 2.0 * radius;
  c.length = radius;
  c.tip_radius = tip_radius;
  c.X_BC = cutter_pose(c);
  return c;
}

TEST(BitNumbers, exposure_between_two_circles_is_the_height_between_them) {
  constexpr double radius = 0.01;
  double worst = 0.0;
  for (double apart = 0.05 * radius; apart < 0.9 * radius; apart += 0.05 * radius) {
    const auto found =
        bit::exposures({flat_cutter(radius, 0.05), flat_cutter(radius, 0.05 + apart)});
    worst =
        std::max(worst, std::abs(found[0] - radius + std::sqrt(radius * radius - apart * apart)));
  }
  record_bound("ours/exposure", "two cutters of 20 mm, 0.5 to 9 mm apart: from R - sqrt(R^2 - d^2)",
               worst, "m", 1.1e-7);
}

TEST(BitNumbers, the_gage_is_reached_and_not_passed) {
  constexpr double gage = 0.10795;  // m, 8.5 in / 2, as in the files
  for (const char* name : {"bit-a", "bit-b", "bit-c", "bit-r", "bit-m", "generated"})
    record_bound("ours/gage",
                 fmt::format("{}: largest radius of cutting parts{} from half of 8.5 in", name,
                             example(name).cones.empty() ? "" : " in full turns of the cones"),
                 std::abs(example(name).gage_radius - gage), "m", 1e-12);
}

}  // namespace tdbd::claims::bit_numbers_test
