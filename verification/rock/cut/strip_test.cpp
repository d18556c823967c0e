#include "rock/cut/strip.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

#include "verification/battery/generators.hpp"

namespace tdbd::rock::strip_test {

const mesh::Box part{Vec3::Constant(-2.0), Vec3::Constant(2.0)};

/// A way of up to `way` along each axis, and a direction that turns by about `turn` on it.
RelativePath any_path(double way, double turn) {
  RelativePath p;
  p.q0_P = *battery::point(0.5);
  p.q1_P = p.q0_P + way * *battery::point(1.0);
  p.u0_P = *battery::direction();
  p.u1_P = (p.u0_P + turn * *battery::point(1.0)).normalized();
  return p;
}

mesh::Box box_at(const Vec3& x, double half) {
  return {x - Vec3::Constant(half), x + Vec3::Constant(half)};
}

/// However small the box and however far the direction turns.
RC_GTEST_PROP(Strip, meets_every_box_that_a_point_of_it_is_in, ()) {
  const RelativePath path =
      any_path(*rc::gen::element(0.0, 0.1, 0.5), *rc::gen::element(0.0, 0.1, 0.4));
  const Strip strip(path, part);
  const double t = *battery::number(0.0, 1.0), half = *rc::gen::element(0.0, 1e-6, 0.1);
  const Vec3 x = strip.at(*battery::number(0.0, 1.0), t);
  RC_ASSERT(strip.meets(box_at(x, half)));
  RC_ASSERT(strip.up_to(t).meets(box_at(x, half)));
  RC_ASSERT(strip.up_to(t).meets({x, x + Vec3(half, 2.0 * half, half)}));
}

/// Without a way and a turn it is a line: it passes what is beside it, before it and beyond its end.
RC_GTEST_PROP(Strip, of_no_width_meets_no_box_beside_it, ()) {
  const Strip strip(any_path(0.0, 0.0), part);
  const Vec3 u = strip.at(0.0, 1.0) - strip.at(0.0, 0.0);
  const Vec3 beside =
      u.cross(Vec3::Unit(*battery::integer(0, 2)) + 0.1 * Vec3::Ones()).normalized();
  const double t = *battery::number(0.0, 1.0), half = *battery::number(0.001, 0.1);
  const double apart = 1.001 * std::sqrt(3.0) * half;  // half of its diagonal
  RC_ASSERT(!strip.meets(box_at(strip.at(0.0, t) + apart * beside, half)));
  RC_ASSERT(!strip.meets(box_at(strip.at(0.0, -apart), half)));
  RC_ASSERT(!strip.up_to(t).meets(box_at(strip.at(0.0, t + apart), half)));
  RC_ASSERT(strip.meets(box_at(strip.at(0.0, t + apart), half)));
}

/// It reaches beyond the part's box: what is there, it has passed.
RC_GTEST_PROP(Strip, ends_beyond_the_part, ()) {
  const Strip strip(any_path(0.5, 0.3), part);
  for (const double tau : {0.0, 0.5, 1.0}) {
    double t = 0.0;
    while (part.contains(strip.at(tau, t))) t += 0.01;
    RC_ASSERT(strip.meets(box_at(strip.at(tau, t - 0.01), 0.0)));
  }
}

/// A ray at any tau that hits the facet does so within an interval; and the level in the middle of each interval meets
/// the facet.
RC_GTEST_PROP(Strip, has_the_levels_that_meet_a_facet, ()) {
  const RelativePath path = any_path(*rc::gen::element(0.1, 0.5), *rc::gen::element(0.0, 0.1, 0.4));
  const Strip strip(path, part);
  const Vec3 near = strip.at(0.5, 0.8);
  const mesh::Facet f{near + *battery::point(0.5), near + *battery::point(0.5),
                      near + *battery::point(0.5)};
  RC_PRE((f.b - f.a).cross(f.c - f.a).norm() > 0.01);
  std::vector<double> ends;
  std::vector<Levels> intervals;
  strip.levels_that_meet(f, 1e-12, ends, intervals);
  RC_TAG(intervals.empty() ? "missed" : "met");
  for (int k = 0; k <= 50; ++k) {
    const double tau = k / 50.0;
    const Vec3 x = strip.at(tau, 0.0), u = strip.at(tau, 1.0) - x;
    const auto hit = mesh::meet(f, x, u);
    if (!hit || hit->margin < 0.0) continue;
    RC_ASSERT(std::ranges::any_of(intervals, [&](const Levels& i) {
      return hit->s >= i.lo - 1e-9 && hit->s <= i.hi + 1e-9;
    }));
  }
  for (const Levels& i : intervals) {
    if (i.hi - i.lo < 1e-6) continue;
    const double t = 0.5 * (i.lo + i.hi);
    const Vec3 from = strip.at(0.0, t), to = strip.at(1.0, t);
    const auto hit = mesh::meet(f, from, to - from);
    RC_ASSERT(hit.has_value());
    RC_ASSERT(hit->margin > -1e-9);
    RC_ASSERT(hit->s > -1e-9);
    RC_ASSERT(hit->s < 1.0 + 1e-9);
  }
}

}  // namespace tdbd::rock::strip_test
