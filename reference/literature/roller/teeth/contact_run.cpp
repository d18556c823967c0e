#include "reference/literature/roller/teeth/contact_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "reference/literature/roller/bracketed_root.hpp"
#include "reference/literature/roller/teeth/ma_azar.hpp"

namespace tdbd::reference {
namespace {

/// A tooth of the bit, and the depth of the bottom for its row: m below the bit's origin.
struct Tooth {
  std::size_t cone = 0;
  ToothPlace place;
  double bottom = 0.0;
};

/// State of a tooth at a time: depth of its tip in rock, and its downward speed.
struct Dip {
  double depth = 0.0, rate = 0.0;  ///< m, m/s
};

struct Kinematics {
  const RollerBit& bit;
  const ContactSchedule& schedule;
  std::vector<Tooth> teeth;
};

/// Without the bit's own descent, because the bottom moves down with it.
Dip dip_at(const Kinematics& k, const Tooth& tooth, double time) {
  const RollerCone& cone = k.bit.cones[tooth.cone];
  const double speed = k.schedule.bit_speed;
  const RollerMotion motion{steady_course(0.0, speed, time), {}};
  const ToothState state = tooth_state(
      cone, tooth.place, motion, steady_course(0.0, -k.schedule.ratios[tooth.cone] * speed, time));
  return {state.place.z() - tooth.bottom, state.velocity.z()};
}

std::vector<Tooth> teeth_of(const RollerBit& bit, double penetration) {
  std::vector<Tooth> teeth;
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    for (const RollerRow& row : bit.cones[k].rows) {
      const Vec3 lowest = tooth_state(bit.cones[k], {row.along, row.radius, 0.0}, {}, {}).place;
      for (const double angle : row.angles)
        teeth.push_back({k, {row.along, row.radius, angle}, lowest.z() - penetration});
    }
  return teeth;
}

bool in_rock(const Dip& dip) { return dip.depth > 0.0; }

/// Follows the contacts of one tooth in time.
struct Follower {
  const Kinematics& k;
  const Tooth& tooth;
  std::size_t index;
  double entry;  ///< s, of the current contact
  std::vector<ToothInRock>& contacts;
};

/// An interval of time in which the tooth only moves down or only up: it crosses the bottom once or
/// not at all.
void follow_one_way(Follower& f, double from, const Dip& before, double to, const Dip& after) {
  if (in_rock(before) == in_rock(after)) return;
  const double crossing =
      bracketed_root([&](double t) { return dip_at(f.k, f.tooth, t).depth; },
                     {.low = from, .high = to, .what = "Ma and Azar: a contact's end (s)"})
          .x;
  if (in_rock(after))
    f.entry = crossing;
  else
    f.contacts.push_back({f.index, f.entry, crossing});
}

/// A step, divided where the tooth reverses from down to up, so that contacts of any duration are
/// found.
void follow_step(Follower& f, double from, const Dip& before, double to, const Dip& after) {
  if (before.rate * after.rate >= 0.0) return follow_one_way(f, from, before, to, after);
  const double turn =
      bracketed_root([&](double t) { return dip_at(f.k, f.tooth, t).rate; },
                     {.low = from, .high = to, .what = "Ma and Azar: a tooth's lowest place (s)"})
          .x;
  const Dip between = dip_at(f.k, f.tooth, turn);
  follow_one_way(f, from, before, turn, between);
  follow_one_way(f, turn, between, to, after);
}

void follow_tooth(const Kinematics& k, std::size_t index, long steps,
                  std::vector<ToothInRock>& contacts) {
  const double step = k.schedule.duration / static_cast<double>(steps);
  Follower f{k, k.teeth[index], index, 0.0, contacts};
  Dip before = dip_at(k, f.tooth, 0.0);
  for (long i = 0; i < steps; ++i) {
    const double from = static_cast<double>(i) * step, to = static_cast<double>(i + 1) * step;
    const Dip after = dip_at(k, f.tooth, to);
    follow_step(f, from, before, to, after);
    before = after;
  }
  if (in_rock(before)) contacts.push_back({index, f.entry, k.schedule.duration});
}

/// A time at which a tooth enters (+1) or leaves (-1) the rock.
struct Change {
  double time = 0.0;
  int by = 0;
};

std::vector<Change> changes_after(const std::vector<ToothInRock>& contacts, double settle) {
  std::vector<Change> changes;
  for (const ToothInRock& c : contacts) {
    if (c.exit <= settle) continue;
    changes.push_back({std::max(c.entry, settle), 1});
    changes.push_back({c.exit, -1});
  }
  std::ranges::sort(changes, [](const Change& a, const Change& b) {
    return a.time != b.time ? a.time < b.time : a.by < b.by;
  });
  return changes;
}

void take_shares(ContactRun& run, const ContactSchedule& s) {
  const double counted = s.duration - s.settle;
  for (const ToothInRock& c : run.contacts)
    run.tooth_share[c.tooth] += std::max(0.0, c.exit - std::max(c.entry, s.settle)) / counted;
  run.count_share.assign(run.tooth_share.size() + 1, 0.0);
  int touching = 0;
  double since = s.settle;
  for (const Change& change : changes_after(run.contacts, s.settle)) {
    run.count_share[at(touching)] += (change.time - since) / counted;
    since = change.time;
    touching += change.by;
  }
  run.count_share[at(touching)] += (s.duration - since) / counted;
  for (std::size_t n = 0; n < run.count_share.size(); ++n)
    run.mean += static_cast<double>(n) * run.count_share[n];
  for (std::size_t n = 0; n < run.count_share.size(); ++n)
    run.variance += std::pow(static_cast<double>(n) - run.mean, 2) * run.count_share[n];
}

void check_times(const ContactSchedule& s) {
  if (!(s.duration > 0.0 && s.step > 0.0 && s.bit_speed > 0.0))
    throw InputError(
        "Ma and Azar: found a duration, step or bit speed that is not above 0; needs all three");
  if (!(s.settle >= 0.0 && s.settle < s.duration))
    throw InputError(fmt::format(
        "Ma and Azar: found means from {:.6g} s on, expected 0 to {:.6g} s", s.settle, s.duration));
  for (const double ratio : s.ratios)
    if (!(std::abs(ratio) * s.bit_speed * s.step < std::numbers::pi))
      throw InputError(fmt::format(
          "Ma and Azar: found a step of {:.6g} s in which a cone makes half a turn or more, "
          "expected a shorter one",
          s.step));
}

void check_contact_run(const RollerBit& bit, const ContactSchedule& s) {
  if (bit.cones.empty())
    throw InputError("Ma and Azar: found a bit without cones, expected a roller cone bit");
  if (s.ratios.size() != bit.cones.size())
    throw InputError(
        fmt::format("Ma and Azar: found {} cone speeds, expected one for each of {} cones",
                    s.ratios.size(), bit.cones.size()));
  if (!std::isfinite(s.penetration))
    throw InputError("Ma and Azar: found a penetration that is not finite, expected metres");
  check_times(s);
}

}  // namespace

ContactRun contact_run(const RollerBit& bit, const ContactSchedule& schedule) {
  check_contact_run(bit, schedule);
  const Kinematics k{bit, schedule, teeth_of(bit, schedule.penetration)};
  if (k.teeth.empty())
    throw InputError("Ma and Azar: found cones without teeth, expected at least one");
  ContactRun run;
  run.steps = std::max(1L, std::lround(std::ceil(schedule.duration / schedule.step)));
  run.tooth_share.assign(k.teeth.size(), 0.0);
  for (std::size_t i = 0; i < k.teeth.size(); ++i) follow_tooth(k, i, run.steps, run.contacts);
  std::ranges::stable_sort(run.contacts, {}, &ToothInRock::entry);
  take_shares(run, schedule);
  return run;
}

}  // namespace tdbd::reference
