#include <gtest/gtest.h>

#include "forces/generate.hpp"

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

/// Of many cuts one at least feels it. The generator is called by hand: the search is no property
/// of a single cut.
bool shows(std::string_view name, PartKind kind, std::size_t coefficient) {
  constexpr int most = 200;
  const auto trials = rc::gen::exec([=] { return any_trial(name, kind); });
  rc::Random random(20261122);
  for (int i = 0; i < most; ++i)
    if (change_of_force(trials(random.split(), rc::kNominalSize).value(), coefficient) > 0.0)
      return true;
  return false;
}

TEST(ActsOn, a_coefficient_changes_a_force_wherever_it_says_so) {
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
TEST(ActsOn, lies_within_what_the_law_knows) {
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

}  // namespace tdbd::forces::acts_on_test
