#include "verification/battery/generators.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "reference/mesh/convex_hull.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::battery {

rc::Gen<int> integer(int first, int last) {
  const int nearest = std::clamp(0, first, last);
  const int both = 2 * std::min(nearest - first, last - nearest);  // these alternate: 1, -1, 2, ...
  const int side = nearest - first < last - nearest ? 1 : -1;      // then one side continues
  const auto rank = rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, last - first + 1));
  return rc::gen::map(rank, [=](int k) {
    if (k > both) return nearest + side * (k - both / 2);
    return nearest + (k % 2 == 1 ? (k + 1) / 2 : -k / 2);
  });
}

rc::Gen<double> number(double lo, double hi) {
  const int first = static_cast<int>(std::ceil(1000.0 * lo));
  const int last = static_cast<int>(std::floor(1000.0 * hi));
  return rc::gen::map(integer(first, last), [](int i) { return i / 1000.0; });
}

rc::Gen<Vec3> point(double half) {
  return rc::gen::apply([](double x, double y, double z) { return Vec3(x, y, z); },
                        number(-half, half), number(-half, half), number(-half, half));
}

Random any_random() { return Random{*rc::gen::arbitrary<std::uint64_t>()}; }

rc::Gen<Vec3> direction() {
  return rc::gen::map(rotation(), [](const Mat3& R) { return Vec3(R.col(2)); });
}

rc::Gen<Mat3> rotation() {
  const auto component = integer(-20, 20);
  return rc::gen::apply(
      [](int w, int x, int y, int z) {
        if (w == 0 && x == 0 && y == 0 && z == 0) return Mat3(Mat3::Identity());
        return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
      },
      component, component, component, component);
}

rc::Gen<Pose> pose(double half) {
  return rc::gen::apply(
      [](const Mat3& R, const Vec3& p) {
        return Pose{R, p};
      },
      rotation(), point(half));
}

rc::Gen<mesh::TriangleMesh> convex_polyhedron() {
  const auto with_tetrahedron = [](std::vector<Vec3> points) {
    for (const Vec3& x : {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)})
      points.push_back(0.5 * x);
    return reference::convex_hull(points);
  };
  const auto points = rc::gen::mapcat(rc::gen::inRange<std::size_t>(0, 13), [](std::size_t n) {
    return rc::gen::container<std::vector<Vec3>>(n, point(1.0));
  });
  return rc::gen::map(points, with_tetrahedron);
}

rc::Gen<mesh::TriangleMesh> nonconvex_prism() {
  const auto outline =
      rc::gen::oneOf(rc::gen::map(number(0.2, 0.9), [](double arm) { return l_outline(1.6, arm); }),
                     rc::gen::map(number(0.1, 0.7), [](double arm) { return u_outline(1.6, arm); }),
                     rc::gen::apply([](double inner, int n) { return star_outline(1.0, inner, n); },
                                    number(0.2, 0.7), rc::gen::inRange(3, 8)));
  return rc::gen::apply(
      [](const std::vector<Eigen::Vector2d>& points, double half, const Mat3& R) {
        return placed({R, Vec3::Zero()}, prism(points, -half, half));
      },
      outline, number(0.1, 0.7), rotation());
}

rc::Gen<mesh::TriangleMesh> star_shape() {
  mesh::TriangleMesh unit = sphere(1.0, 1);
  const auto radii =
      rc::gen::container<std::vector<double>>(unit.positions.size(), number(0.4, 1.0));
  return rc::gen::map(radii, [unit](const std::vector<double>& r) {
    mesh::TriangleMesh m = unit;
    for (std::size_t i = 0; i < r.size(); ++i) m.positions[i] *= r[i];
    return m;
  });
}

}  // namespace tdbd::battery
