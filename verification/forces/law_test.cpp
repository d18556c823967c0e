#include "forces/law.hpp"

#include <gtest/gtest.h>

#include <set>

#include "battery/counted_memory.hpp"
#include "core/error.hpp"
#include "forces/generate.hpp"

namespace tdbd::forces::law_test {

RC_GTEST_PROP(Force, does_no_positive_work_on_the_bit, ()) {
  const PartCut c = any_cut();
  const PartForce f = force(any_law(), c);
  RC_ASSERT(f.force.dot(c.velocity) <= rounding(size(f) * c.velocity.norm()));
}

RC_GTEST_PROP(Force, never_pulls_the_bit_into_the_rock, ()) {
  const PartCut c = any_cut();
  const PartForce f = force(any_law(), c);
  RC_ASSERT(f.force.dot(c.normal) <= rounding(size(f)));
}

/// Every surface but faces and chamfers, under every law that knows it: Coulomb's law for every
/// motion, and no force where it lifts.
RC_GTEST_PROP(Force, of_a_surface_that_presses_satisfies_coulombs_law, ()) {
  const Law law = any_law();
  const PartCut c = any_cut();
  const bool cuts = c.kind == bit::PartKind::face || c.kind == bit::PartKind::chamfer;
  const bool has_force = knows(law, c.kind) && law_name(law) != "none";
  RC_PRE(!cuts && has_force);
  const std::optional<Pressing> presses = pressing(law, c);
  RC_ASSERT(presses.has_value());
  const Vec3 F = force(law, c).force;
  const double normal = -F.dot(c.normal);
  constexpr double rounding = 1e-14;
  RC_ASSERT((F + normal * c.normal).norm() <=
            presses->sliding.mu * normal + rounding * presses->limit);
  RC_ASSERT(normal <= presses->limit * (1.0 + rounding));
  if (c.velocity.dot(c.normal) < -1e-9 * c.velocity.norm()) RC_ASSERT(F == Vec3::Zero());
}

RC_GTEST_PROP(Force, is_finite_and_acts_at_the_contact, ()) {
  const PartCut c = any_cut();
  const PartForce f = force(any_law(), c);
  RC_ASSERT(f.force.allFinite());
  RC_ASSERT(f.normal >= 0.0 && f.tangential >= 0.0);
  RC_ASSERT(f.point == c.point);
}

RC_GTEST_PROP(Force, at_rest_is_none, ()) {
  PartCut c = any_cut();
  c.velocity = Vec3::Zero();
  RC_ASSERT(force(any_law(), c).force == Vec3::Zero());
}

/// Sizes of force that a law can reach on a cut, whatever the velocity.
double largest_force(const Law& law, PartCut c) {
  double largest = 0.0;
  for (const Vec3& v : {Vec3(c.normal), Vec3(c.normal.unitOrthogonal())}) {
    c.velocity = 1e6 * v;
    largest = std::max(largest, size(force(law, c)));
  }
  return largest;
}

/// With a slip speed the force is continuous in the velocity, at rest, in a plunge and in
/// withdrawal: its slope is at most a few times force over slip speed. Measured on 3e6 cuts: 2.1.
RC_GTEST_PROP(Force, is_continuous_in_the_velocity, ()) {
  Law law = any_law();
  double slip_speed = 0.0;
  for (const LawField& f : law_fields(law)) {
    if (f.key == "slip_speed") slip_speed = *f.value = number(0.05, 1.0);
    if (f.key == "weakening") *f.value = number(0.0, 0.5);
    if (f.key == "weakening_speed") *f.value = number(1.0, 2.0);
  }
  RC_PRE(slip_speed > 0.0);
  PartCut a = any_cut();
  RC_PRE(!pressing(law, a));  // rigid-plastic: anything between nothing and all as it slides
  a.velocity *= number(0.0, 1.0);
  PartCut b = a;
  const double change = slip_speed * std::pow(10.0, -number(1.0, 6.0));  // m/s
  b.velocity += change * any_direction();
  const Vec3 difference = force(law, a).force - force(law, b).force;
  // wide: 2.1 in 3e6 cuts, far less in a hundred
  RC_ASSERT(difference.norm() <= 3.0 * largest_force(law, a) * change / slip_speed);
}

/// Turning the whole problem turns the force.
RC_GTEST_PROP(Force, turns_with_the_problem, ()) {
  const Law law = any_law();
  const PartCut c = any_cut();
  const Mat3 R = any_rotation();
  PartCut turned = c;
  turned.velocity = R * c.velocity;
  turned.normal = R * c.normal;
  turned.point = R * c.point;
  const PartForce f = force(law, c), g = force(law, turned);
  // A velocity along the normal keeps a rest of sideways motion by rounding: its direction is free.
  const Vec3 slip = c.velocity - c.velocity.dot(c.normal) * c.normal;
  RC_PRE(c.velocity.isZero(0.0) || slip.norm() > 1e-3 * c.velocity.norm());
  RC_ASSERT((R * f.force - g.force).norm() <= 1e-12 * size(f));
}

RC_GTEST_PROP(Force, of_a_part_that_touches_nothing_is_none, ()) {
  PartCut c = any_cut();
  c.cut_area = c.contact_area = c.engaged_edge = c.depth = 0.0;
  RC_ASSERT(force(any_law(), c).force == Vec3::Zero());
}

RC_GTEST_PROP(Force, of_a_kind_that_the_law_does_not_support_is_none, ()) {
  const Law law = any_law();
  const PartCut c = any_cut();
  if (!law_problem(law, c.kind, c.diameter).empty()) RC_ASSERT(force(law, c).force == Vec3::Zero());
}

/// Two parts, each with a share of a part's areas and edge: their forces add up to the part's.
RC_GTEST_PROP(Force, of_laws_linear_in_area_adds_up, ()) {
  const Law law = any_law({"hanson-hansen", "detournay", "friction"});
  PartCut whole = any_cut(), part = whole, rest = whole;
  const double share = number(0.0, 1.0);
  for (auto [p, s] : {std::pair{&part, share}, std::pair{&rest, 1.0 - share}}) {
    p->cut_area *= s;
    p->contact_area *= s;
    p->engaged_edge *= s;
  }
  const PartForce f = force(law, whole);
  RC_ASSERT((force(law, part).force + force(law, rest).force - f.force).norm() <=
            rounding(size(f)));
}

/// How a quantity of this unit is written in units of length, force and speed.
double in_units(std::string_view unit, double length, double force, double speed) {
  return unit == "m"     ? 1.0 / length
         : unit == "m/s" ? 1.0 / speed
         : unit == "Pa"  ? length * length / force
         : unit == "N"   ? 1.0 / force
                         : 1.0;
}

/// A bit twice as large, or harder rock, scales the force. Only Glowka's law has an internal
/// length, the depth at which its forces are given.
RC_GTEST_PROP(Force, does_not_depend_on_the_units, ()) {
  Law law = any_law(
      {"hanson-hansen", "detournay", "depth-of-cut", "thin-cut", "friction", "indentation"});
  PartCut c = any_cut(), d = c;
  const double length = number(0.1, 10.0), newton = number(0.1, 10.0), speed = number(0.1, 10.0);
  const auto scale = [&](std::string_view unit) { return in_units(unit, length, newton, speed); };
  for (double* area : {&d.cut_area, &d.contact_area}) *area *= scale("m") * scale("m");
  for (double* x : {&d.engaged_edge, &d.depth, &d.diameter}) *x *= scale("m");
  for (double* p : {&d.strength.unconfined, &d.strength.confined, &d.strength.pressure})
    *p *= scale("Pa");
  d.velocity *= scale("m/s");
  const PartForce f = force(law, c);
  for (const LawField& field : law_fields(law)) *field.value *= scale(field.unit);
  const Vec3 g = force(law, d).force;
  RC_ASSERT((g * newton - f.force).norm() <= 1e-12 * size(f));
}

TEST(SweptArea, of_a_cut_does_not_depend_on_the_step) {
  const double width = 10e-3, depth = 1e-3, speed = 0.5;  // m, m, m/s
  for (const double step : {1e-4, 1e-3, 1e-2})
    EXPECT_NEAR(swept_area(width * depth * speed * step, speed * step), 1e-5, 1e-20) << step;
  EXPECT_EQ(swept_area(0.0, 0.0), 0.0);
}

TEST(Force, of_every_law_allocates_nothing) {
  for (const std::string_view name : law_names()) {
    const Law law = law_named(name);
    battery::reset_peak();
    const long before = battery::counted_memory().peak;
    for (int kind = 0; kind < 8; ++kind) force(law, plain_cut(static_cast<bit::PartKind>(kind)));
    EXPECT_EQ(battery::counted_memory().peak, before) << name;
  }
}

TEST(LawFields, reach_every_coefficient_by_name_unit_and_range) {
  Law law = law_named("detournay");
  for (const LawField& f : law_fields(law))
    if (f.key == "eps") {
      EXPECT_EQ(f.unit, "Pa");
      EXPECT_FALSE(f.fallback.has_value());
      EXPECT_FALSE(f.range.contains(0.0));
      *f.value = 100 * MPa;
    }
  EXPECT_EQ(std::get<Detournay>(law).eps, 100 * MPa);
}

/// What a law starts with is what its table promises, lies in its range, and no key comes twice.
TEST(LawFields, of_a_new_law_have_their_defaults) {
  for (const std::string_view name : law_names()) {
    Law law = law_named(name);
    EXPECT_EQ(law_name(law), name);
    std::set<std::string_view> keys;
    for (const LawField& f : law_fields(law)) {
      EXPECT_EQ(*f.value, f.fallback.value_or(0.0)) << name << ' ' << f.key;
      EXPECT_TRUE(!f.fallback || f.range.contains(*f.fallback)) << name << ' ' << f.key;
      EXPECT_TRUE(keys.insert(f.key).second) << name << ' ' << f.key;
      EXPECT_FALSE(f.meaning.empty());
    }
  }
}

TEST(LawNamed, names_the_laws_that_there_are) {
  try {
    law_named("hanson");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("\"hanson-hansen\", \"detournay\""), std::string::npos)
        << e.what();
  }
}

TEST(LawProblem, names_the_law_the_part_and_the_supported_parts) {
  EXPECT_EQ(law_problem(law_named("detournay"), bit::PartKind::tooth, 0.0),
            "the law \"detournay\" does not apply to tooth; it applies to: face, chamfer, cse, "
            "cutter body");
  EXPECT_EQ(law_problem(law_named("detournay"), bit::PartKind::face, 16e-3), "");
}

}  // namespace tdbd::forces::law_test

/// Where each coefficient of each law acts.
namespace tdbd::forces::acts_on_test {

using bit::PartKind;

/// A law and a cut with which a coefficient may show.
struct Trial {
  Law law, other;  ///< of the same name, with other coefficients
  PartCut cut;
};

Trial any_trial(std::string_view name, PartKind kind) {
  Trial t{any_law({name}), any_law({name}), any_cut()};
  t.cut.kind = kind;
  return t;
}

/// The size of the change of force when one coefficient of the law takes its value of the other.
double change_of_force(Trial t, std::size_t coefficient) {
  const Vec3 before = force(t.law, t.cut).force;
  *law_fields(t.law)[coefficient].value = *law_fields(t.other)[coefficient].value;
  return (force(t.law, t.cut).force - before).norm();
}

RC_GTEST_PROP(ActsOn, a_coefficient_changes_no_force_elsewhere, ()) {
  const auto names = law_names();
  Trial t = any_trial(names[index(names.size())], any_kind());
  const auto fields = law_fields(t.law);
  for (std::size_t k = 0; k < fields.size(); ++k)
    if (!acts_on(fields[k], t.cut.kind)) RC_ASSERT(change_of_force(t, k) == 0.0);
}

/// The coefficient changes the force of at least one of many cuts. The generator is called
/// directly, because the search is not a property of a single cut.
bool shows(std::string_view name, PartKind kind, std::size_t coefficient) {
  constexpr int most = 200;
  const auto trials = rc::gen::exec([=] { return any_trial(name, kind); });
  rc::Random random(20261122);
  for (int i = 0; i < most; ++i)
    if (change_of_force(trials(random.split(), rc::kNominalSize).value(), coefficient) > 0.0)
      return true;
  return false;
}

TEST(ActsOn, a_coefficient_changes_a_force_of_every_kind_that_it_lists) {
  for (const std::string_view name : law_names()) {
    Law law = law_named(name);
    const auto fields = law_fields(law);
    for (std::size_t k = 0; k < fields.size(); ++k)
      for (const PartKind kind : bit::part_kinds)
        if (acts_on(fields[k], kind)) {
          EXPECT_TRUE(shows(name, kind, k))
              << name << ' ' << fields[k].key << " on " << bit::kind_words(kind);
        }
  }
}

/// None acts where the law knows nothing, and the slip speed acts wherever it knows something.
TEST(ActsOn, lists_only_kinds_that_the_law_supports) {
  for (const std::string_view name : law_names()) {
    Law law = law_named(name);
    for (const LawField& f : law_fields(law))
      for (const PartKind kind : bit::part_kinds) {
        const bool known = knows(law, kind);
        EXPECT_TRUE(known || !acts_on(f, kind)) << name << ' ' << f.key;
        EXPECT_TRUE(f.key != "slip_speed" || acts_on(f, kind) == known) << name;
      }
  }
}

/// Whether the force of one of many cuts changes with the strength of the rock.
bool feels_strength(std::string_view name, PartKind kind) {
  constexpr int most = 200;
  const auto trials = rc::gen::exec([=] { return any_trial(name, kind); });
  rc::Random random(20261129);
  for (int i = 0; i < most; ++i) {
    Trial t = trials(random.split(), rc::kNominalSize).value();
    const Vec3 before = force(t.law, t.cut).force;
    t.cut.strength.unconfined *= 1.5;
    t.cut.strength.confined *= 1.5;
    if (force(t.law, t.cut).force != before) return true;
  }
  return false;
}

TEST(UsesStrength, is_true_where_a_force_changes_with_the_rock) {
  for (const std::string_view name : law_names())
    for (const PartKind kind : bit::part_kinds)
      EXPECT_EQ(uses_strength(law_named(name), kind), feels_strength(name, kind))
          << name << " on " << bit::kind_words(kind);
}

}  // namespace tdbd::forces::acts_on_test
