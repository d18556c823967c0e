#include "simulation/case/case.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "bit/cone/tooth_directions.hpp"
#include "bit/files/bit_file.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "simulation/case/case_drilling.hpp"
#include "simulation/case/case_forces.hpp"
#include "simulation/case/case_motion.hpp"
#include "simulation/case/case_rock.hpp"
#include "simulation/case/contact_slopes.hpp"
#include "simulation/case/step_check.hpp"

namespace tdbd::simulation {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

/// Reads another file; its mistakes join those of the case.
template <class Read>
void collect(Config& c, Read read) {
  try {
    read();
  } catch (const InputError& e) {
    c.other_file(e.what());
  }
}

/// How long: a duration, or a number of revolutions where the rotary speed is given; along a path
/// as long as the path.
double read_duration(Config& c, const Motion& m) {
  if (!c.has("revolutions")) {
    std::optional<double> fallback;
    if (has_path(m)) fallback = m.path.empty() ? 1.0 : m.path.back().time;
    return c.quantity("duration", "s", fallback, Range::positive());
  }
  const double turns = c.quantity("revolutions", "1", std::nullopt, Range::positive());
  if (c.has("duration")) {
    c.quantity("duration", "s", std::nullopt, Range::positive());
    c.problem("revolutions", "duration as well", "one of the two");
  }
  if (m.rotary_speed > 0.0) return turns * two_pi / m.rotary_speed;
  c.problem("revolutions", "a motion without rotary speed", "time.duration instead");
  return std::numeric_limits<double>::infinity();
}

/// A step is a small part of the motion: the rock is swept along straight lines in the bit's frame.
TimeGrid read_time(Config c, const Motion& m) {
  constexpr double largest_turn = 0.5;  // rad
  constexpr double most_steps = 1e15;
  TimeGrid t;
  t.step = c.quantity("step", "s", std::nullopt, Range::positive());
  const double duration = read_duration(c, m);
  t.steps = std::lround(std::min(duration / t.step, most_steps));
  t.first = c.integer("first_step", 0, 0, std::numeric_limits<long>::max());
  if (t.first > 0 && t.first >= t.steps)
    c.problem("first_step", fmt::format("{} of {} steps", t.first, t.steps),
              "a step before the end of the run");
  if (!c.has("step")) return t;
  if (t.steps < 1)
    c.problem("step", fmt::format("{} s for a run of {} s", t.step, duration),
              "at most the duration");
  else if (m.rotary_speed * t.step > largest_turn)
    c.problem("step", fmt::format("a turn of {:.3g} rad in one step", m.rotary_speed * t.step),
              fmt::format("at most {} rad", largest_turn));
  return t;
}

MaintenancePlan read_maintenance(Config c) {
  MaintenancePlan p;
  p.every = c.integer("every", p.every, 0, 1'000'000);
  p.shortest_edge = c.quantity("shortest_edge", "1", p.shortest_edge, Range::within(0.0, 0.7));
  p.longest_edge = c.quantity("longest_edge", "1", p.longest_edge, Range::within(1.3, 100.0));
  p.worst_quality = c.quantity("worst_quality", "1", p.worst_quality, Range::within(0.0, 0.5));
  p.flip_quality = c.quantity("flip_quality", "1", p.flip_quality, Range::within(0.0, 1.0));
  p.smoothing = c.choice<rock::Smoothing>(
      "smoothing", {{"off", rock::Smoothing::off}, {"tangential", rock::Smoothing::tangential}},
      p.smoothing);
  p.smooth_quality = c.quantity("smooth_quality", "1", p.smooth_quality, Range::within(0.0, 1.0));
  return p;
}

MeasurePlan read_measure(Config c) {
  MeasurePlan p;
  p.section = c.choice<SectionMeasure>(
      "section", {{"ahead", SectionMeasure::ahead}, {"off", SectionMeasure::off}}, p.section);
  p.section_lead = c.quantity("section_lead", "1", p.section_lead, Range::within(0.1, 10.0));
  p.contact = c.choice<ContactMeasure>(
      "contact", {{"on", ContactMeasure::on}, {"off", ContactMeasure::off}}, p.contact);
  p.contact_gap = c.quantity("contact_gap", "1", p.contact_gap, Range::within(1e-6, 1.0));
  return p;
}

/// Means are taken over the second half unless the case says otherwise.
OutputPlan read_output(Config c, const TimeGrid& t, bool drills) {
  OutputPlan p;
  p.history_every = c.integer("history_every", p.history_every, 1, 1'000'000'000);
  p.frames_every = c.integer("frames_every", p.frames_every, 0, 1'000'000'000);
  const double duration = t.step * static_cast<double>(t.steps - t.first);
  p.means_from = c.quantity("means_from", "s", 0.5 * duration, Range::non_negative());
  if (!drills) return p;
  using enum EnergyOrderWish;
  p.energy_order = c.choice<EnergyOrderWish>(
      "energy_order", {{"on", on}, {"off", off}, {"always", always}}, p.energy_order);
  p.energy_order_window = c.integer("energy_order_window", p.energy_order_window, 8, 1'000'000);
  return p;
}

UpdatePlan read_update(Config c) {
  using rock::DirectionFrame, rock::ExitSearch;
  UpdatePlan p;
  p.cutting.search = c.choice<ExitSearch>(
      "exit_search", {{"tree", ExitSearch::tree}, {"walk", ExitSearch::walk}}, p.cutting.search);
  p.cutting.directions = c.choice<DirectionFrame>(
      "leaning", {{"upright", DirectionFrame::upright}, {"bit", DirectionFrame::bit}},
      p.cutting.directions);
  p.most_passes = static_cast<int>(c.integer("most_passes", p.most_passes, 1, 1'000'000));
  return p;
}

struct Directions {
  bit::DirectionRule rule;
  bit::InsideRule inside;
  bit::GageRule gage;
};

/// The readings of eq. 4.2, and of its counterpart for roller cones (formulation 2.2, 2.3).
Directions read_directions(Config c) {
  using bit::DirectionRule;
  using bit::GageRule;
  using bit::InsideRule;
  return {c.choice<DirectionRule>("directions",
                                  {{"hybrid", DirectionRule::hybrid},
                                   {"all-down", DirectionRule::all_down},
                                   {"along-profile", DirectionRule::along_profile}},
                                  DirectionRule::hybrid),
          c.choice<InsideRule>("inside_cutters",
                               {{"down", InsideRule::down},
                                {"plus-x", InsideRule::plus_x},
                                {"minus-x", InsideRule::minus_x}},
                               InsideRule::down),
          c.choice<GageRule>("gage_teeth",
                             {{"normal", GageRule::normal},
                              {"row", GageRule::row},
                              {"down", GageRule::down},
                              {"horizontal", GageRule::horizontal}},
                             GageRule::normal)};
}

/// The case's bit, once all else is read, so that the mistakes of both come together.
bit::BitFile read_bit_of(Config& c) {
  const std::string file = c.path("bit.file", std::nullopt);
  const Directions directions = read_directions(c.table("update"));
  bit::BitFile bit;
  if (!file.empty())
    collect(c, [&] { bit = bit::read_bit(file, directions.rule, directions.inside); });
  bit::direct_teeth(bit.bit, directions.gage);
  return bit;
}

/// A bit carries about as much as it does with everything that cuts a gage radius deep in rock. A
/// tenfold is a mistake of units.
void note_overload(Config& c, const Case& read, double axial_stiffness) {
  constexpr double by_orders = 10.0;
  const double most = by_orders * axial_stiffness * read.bit.gage_radius;
  for (const double load : read.drilling.system.top.load.values)
    if (load > most)
      return c.problem("motion.weight_on_bit", fmt::format("{:.4g} N", load),
                       fmt::format("at most {:.4g} N: ten times what the bit would carry buried to "
                                   "its gage radius",
                                   most));
}

/// What a bit that drills by itself needs, and cannot have.
void note_undriven(Config& c, const Case& read) {
  if (read.motion.kind != MotionKind::drilling) return;
  if (read.forces.forces == Forces::off)
    c.problem("forces", "no table [forces]", "force laws: without them nothing drills");
  if (read.time.first > 0)
    c.problem("time.first_step", fmt::format("{} of a bit that forces move", read.time.first),
              "0: what moved before is in no file");
  if (c.problem_count() > 0) return;
  const dynamics::ContactSlopes slopes = contact_slopes(read.bit, read.forces);
  note_overload(c, read, slopes.axial_stiffness);
  const std::string unstable =
      dynamics::stability_problem(read.drilling.system, slopes, read.time.step);
  if (!unstable.empty())
    c.problem("time.step", fmt::format("{} s", read.time.step), "a stable step: " + unstable);
}

}  // namespace

Case read_case(const std::string& path, const std::vector<std::string>& overrides) {
  Config c = Config::read_file(path, overrides);
  Case result;
  result.path = path;
  result.rock = read_rock(c.table("rock"));
  result.motion = read_motion(c.table("motion"));
  dynamics::TopDrive top;
  if (result.motion.kind == MotionKind::drilling) read_top(c.table("motion"), top, result.motion);
  result.time = read_time(c.table("time"), result.motion);
  result.update = read_update(c.table("update"));
  result.maintenance = read_maintenance(c.table("maintenance"));
  result.measure = read_measure(c.table("measure"));
  const bool drills = result.motion.kind == MotionKind::drilling;
  result.output = read_output(c.table("output"), result.time, drills);
  const bit::BitFile bit = read_bit_of(c);
  if (!drills && (!bit.bit.cones.empty() || c.has("motion.cone_speeds")))
    read_cone_speeds(c.table("motion"), bit.bit, result.motion);
  if (result.motion.cone_drive == ConeDrive::rolling && result.time.first > 0)
    c.problem("time.first_step", fmt::format("{} with rolling cones", result.time.first),
              "0: what cones remember of their contacts is in no file");
  result.bit = bit.bit;
  result.forces = read_forces(c, bit.bit, result.measure);
  if (drills) result.drilling = read_drilling(c, bit.bit, top, result.motion);
  note_undriven(c, result);
  note_long_steps(c, result);
  result.places = {c.place("rock.edge_length"), c.place("motion"), c.place("rock.file"),
                   c.place("rock.profile")};
  c.finish();
  result.files = c.files();
  result.files.insert(result.files.end(), bit.files.begin(), bit.files.end());
  result.resolved = c.resolved();
  result.quantities = c.quantities();
  result.hash = fnv1a_hex(c.fingerprint() + bit.fingerprint);
  return result;
}

}  // namespace tdbd::simulation
