#include "simulation/case/case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "bit/cone/cone_bit.hpp"
#include "bit/files/bit_file.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "simulation/case/case_drilling.hpp"
#include "simulation/case/case_forces.hpp"
#include "simulation/case/case_motion.hpp"
#include "simulation/case/case_rock.hpp"
#include "simulation/case/case_spalling.hpp"
#include "simulation/case/case_wear.hpp"
#include "simulation/case/contact_slopes.hpp"
#include "simulation/case/doubtful_values.hpp"
#include "simulation/case/force_keys.hpp"
#include "simulation/case/history_rows.hpp"
#include "simulation/case/read_chain.hpp"
#include "simulation/case/run_keys.hpp"
#include "simulation/case/step_check.hpp"
#include "simulation/case/title_key.hpp"

namespace tdbd::simulation {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

/// How long: a duration, or a number of revolutions where the rotary speed is given; along a path
/// as long as the path.
double read_duration(Config& c, const Motion& m) {
  if (!c.has(time_keys::revolutions)) {
    std::optional<double> fallback;
    if (has_path(m)) fallback = m.path.empty() ? 1.0 : m.path.back().time;
    return c.read(time_keys::duration, fallback);
  }
  const double turns = c.read(time_keys::revolutions);
  if (c.has(time_keys::duration)) {
    c.read(time_keys::duration);
    c.problem(time_keys::revolutions, "duration as well", "one of the two");
  }
  if (m.rotary_speed > 0.0) return turns * two_pi / m.rotary_speed;
  c.problem(time_keys::revolutions, "a motion without rotary speed", "time.duration instead");
  return std::numeric_limits<double>::infinity();
}

/// A step is a small part of the motion: the rock is swept along straight lines in the bit's frame.
TimeGrid read_time(Config c, const Motion& m) {
  constexpr double largest_turn = 0.5;  // rad
  constexpr double most_steps = 1e10;   // the fastest take 0.1 ms each: eleven days
  TimeGrid t;
  t.step = c.read(time_keys::step);
  const double duration = read_duration(c, m);
  const double count = duration / t.step;
  t.steps = std::lround(std::min(count, most_steps));
  t.first = c.read(time_keys::first_step);
  if (t.first > 0 && t.first >= t.steps)
    c.problem(time_keys::first_step, fmt::format("{} of {} steps", t.first, t.steps),
              "a step before the end of the run");
  if (!c.has(time_keys::step)) return t;
  if (t.steps < 1)
    c.problem(time_keys::step, fmt::format("{} s for a run of {} s", t.step, duration),
              "at most the duration");
  else if (count > most_steps && (std::isfinite(duration) || m.rotary_speed > 0.0))
    c.problem(
        time_keys::step,
        fmt::format("{} s for a run of {} s, which makes {:.3g} steps", t.step, duration, count),
        fmt::format("at most {:.0e} steps", most_steps));
  else if (m.rotary_speed * t.step > largest_turn)
    c.problem(time_keys::step,
              fmt::format("a turn of {:.3g} rad in one step", m.rotary_speed * t.step),
              fmt::format("at most {} rad", largest_turn));
  return t;
}

MaintenancePlan read_maintenance(Config c) {
  using namespace maintenance_keys;
  return {.every = c.read(every),
          .rest = c.read(rest),
          .longest_wait = c.read(longest_wait),
          .renumber_every = c.read(renumber_every),
          .shortest_edge = c.read(shortest_edge),
          .longest_edge = c.read(longest_edge),
          .worst_quality = c.read(worst_quality),
          .flip_quality = c.read(flip_quality),
          .smoothing = c.read(smoothing),
          .smooth_quality = c.read(smooth_quality)};
}

MeasurePlan read_measure(Config c) {
  using namespace measure_keys;
  return {.section = c.read(section),
          .section_lead = c.read(section_lead),
          .section_at_face = c.read(section_at_face),
          .contact = c.read(contact),
          .contact_gap = c.read(contact_gap),
          .section_every = c.read(section_every)};
}

void read_convergence(Config& c, OutputPlan& p) {
  try {
    const std::string file = c.path(output_keys::convergence, "");
    if (!file.empty()) p.convergence = read_studied_convergence(file);
  } catch (const InputError& e) {
    c.other_file(e.what());
  }
}

/// Means are taken over the second half unless the case says otherwise.
OutputPlan read_output(Config c, const TimeGrid& t, MotionKind kind) {
  using namespace output_keys;
  const double duration = t.step * static_cast<double>(t.steps - t.first);
  OutputPlan p{.history_every = c.read(history_every, usual_history_every(t.steps - t.first)),
               .frames_every = c.read(frames_every),
               .means_from = c.read(means_from, 0.5 * duration)};
  if (c.has(checkpoint_every.name)) p.checkpoint_every = c.read(checkpoint_every);
  if (c.has(convergence.name)) read_convergence(c, p);
  if (kind != MotionKind::drilling) return p;
  p.energy_order = c.read(energy_order);
  p.energy_order_window = c.read(energy_order_window);
  return p;
}

UpdatePlan read_update(Config& c) {
  using namespace update_keys;
  return {.cutting = {.search = c.read(exit_search),
                      .directions = c.read(leaning),
                      .exit_from = c.read(exit_from)},
          .most_passes = static_cast<int>(c.read(most_passes))};
}

/// The case's bit; its mistakes join those of the case.
bit::BitFile read_bit_of(Config& c, Config& update, const BitReader& read_bit) {
  Config table = c.table(bit_keys::table);
  const std::string file = table.read(bit_keys::file);
  const std::vector<std::string> changes = table.table(bit_keys::set).assignments();
  const auto directions = update.read(update_keys::directions);
  const auto inside = update.read(update_keys::inside_cutters);
  bit::BitFile bit;
  try {
    if (!file.empty()) bit = read_bit(file, directions, inside, changes);
  } catch (const InputError& e) {
    c.other_file(e.what());
  }
  bit::set_tooth_directions(bit.bit, update.read(update_keys::gage_teeth));
  return bit;
}

/// Rejects a weight that no part can carry, and one more than ten times what the bit would carry with
/// everything that cuts a gage radius deep in rock: a mistake of units.
void check_overload(Config c, const Case& read) {
  constexpr double by_orders = 10.0;
  const double most = by_orders * weight_borne(read.bit, read.forces, read.bit.gage_radius);
  const std::string limit =
      most > 0.0 ? fmt::format(
                       "at most {:.4g} N: ten times what the bit would carry buried to its "
                       "gage radius",
                       most)
                 : "0 N: no part of the bit has a force law that carries weight";
  for (const double load : read.drilling.system.top.load.values)
    if (load > most)
      return c.problem(motion_keys::weight_on_bit, fmt::format("{:.4g} N", load), limit);
}

/// What is recorded of a string on a chain, which has been read by now.
void read_string_output(Config c, Case& read) {
  const auto& chained = read.drilling.system.chained;
  if (!chained && c.problem_count() == 0) return refuse_chain_output(c);
  read.output.chain =
      read_chain_output(c, chained ? chained->chain : string::Chain{}, read.time.step);
}

/// What a bit that drills by itself needs, and cannot have.
void check_drilling_case(Config& c, const Case& read) {
  if (read.motion.kind != MotionKind::drilling) return;
  Config time = c.table(time_keys::table);
  if (read.forces.forces == Forces::off)
    c.problem(force_keys::table.name, "no table [forces]",
              "force laws: without them nothing drills");
  if (read.time.first > 0)
    time.problem(time_keys::first_step,
                 fmt::format("{} of a bit that forces move", read.time.first),
                 "0: what moved before is in no file");
  if (read.measure.section_every > 1)
    c.table(measure_keys::table)
        .problem(measure_keys::section_every, fmt::format("{}", read.measure.section_every),
                 "1 where forces move the bit: with sections of former steps the motion is of "
                 "first order");
  if (c.problem_count() > 0) return;
  const dynamics::ContactSlopes slopes = contact_slopes(read.bit, read.forces);
  check_overload(c.table(motion_keys::table), read);
  const std::string unstable =
      dynamics::stability_problem(read.drilling.system, slopes, read.time.step);
  if (!unstable.empty())
    time.problem(time_keys::step, fmt::format("{} s", read.time.step),
                 "a stable step: " + unstable);
}

/// Cones that roll remember their contacts, and no file does.
void check_continued_cones(Config c, const Case& read) {
  if (read.motion.cone_drive == ConeDrive::rolling && read.time.first > 0)
    c.problem(time_keys::first_step, fmt::format("{} with rolling cones", read.time.first),
              "0: what cones remember of their contacts is in no file");
}

/// The bit's file, and the choices of [update] that its parts and their search depend on.
std::string bit_hash(Config& update, const bit::BitFile& bit, const rock::CuttingOptions& cutting) {
  return fnv1a_hex(fmt::format(
      "{}\n{} {} {} {} {} {}", bit.fingerprint,
      static_cast<int>(update.read(update_keys::directions)),
      static_cast<int>(update.read(update_keys::inside_cutters)),
      static_cast<int>(update.read(update_keys::gage_teeth)), static_cast<int>(cutting.search),
      static_cast<int>(cutting.directions), static_cast<int>(cutting.exit_from)));
}

/// All tables, and what must hold between them.
bit::BitFile read_tables(Config& c, const BitReader& read_bit, Case& read) {
  Config update = c.table(update_keys::table);
  bit::BitFile file = read_bit_of(c, update, read_bit);
  read.bit = file.bit;
  read.rock = read_rock(c.table(rock_keys::table));
  const RigLog log = read_rig_log(c);
  read.motion = read_motion(c.table(motion_keys::table), read.bit, log);
  read.time = read_time(c.table(time_keys::table), read.motion);
  check_rig_log(c, log, read.time.step * static_cast<double>(read.time.steps));
  read.update = read_update(update);
  read.bit_hash = bit_hash(update, file, read.update.cutting);
  read.maintenance = read_maintenance(c.table(maintenance_keys::table));
  read.measure = read_measure(c.table(measure_keys::table));
  read.output = read_output(c.table(output_keys::table), read.time, read.motion.kind);
  check_continued_cones(c.table(time_keys::table), read);
  read.forces = read_forces(c, read.bit, read.measure, read.warnings);
  read.wear = read_wear(c, read.bit, read.forces);
  read.spalling = read_spalling(c, read.bit, read.measure, read.forces, read.warnings);
  if (read.motion.kind == MotionKind::drilling)
    read.drilling = read_drilling(c, read.bit, read.motion, read.time.step, read.warnings);
  read_string_output(c.table(output_keys::table), read);
  check_drilling_case(c, read);
  check_step_length(c, read);
  if (c.problem_count() > 0) return file;
  std::ranges::move(doubtful_values(c, read), std::back_inserter(read.warnings));
  return file;
}

bit::BitFile read_now(const std::string& path, bit::DirectionRule directions,
                      bit::InsideRule inside, const std::vector<std::string>& overrides) {
  return bit::read_bit(path, directions, inside, bit::Densities::as_given, overrides);
}

Case read_case_with(Config c, const std::string& path, const BitReader& read_bit) {
  Case result;
  result.path = path;
  if (c.has(title_keys::title)) result.title = c.read(title_keys::title);
  const bit::BitFile bit = read_tables(c, read_bit, result);
  if (result.title.empty()) result.title = result.bit.name;
  Config rock = c.table(rock_keys::table);
  result.places = {rock.place(rock_keys::edge_length), c.place(motion_keys::table.name),
                   rock.place(rock_keys::file), rock.place(rock_keys::profile),
                   c.table(time_keys::table).place(time_keys::first_step)};
  c.finish();
  result.files = c.files();
  result.files.insert(result.files.end(), bit.files.begin(), bit.files.end());
  result.resolved = c.resolved();
  result.quantities = c.quantities();
  result.hash = fnv1a_hex(c.fingerprint() + bit.fingerprint);
  return result;
}

}  // namespace

Case read_case(const std::string& path, const std::vector<std::string>& overrides) {
  return read_case(path, overrides, read_now);
}

Case read_case(const std::string& path, const std::vector<std::string>& overrides,
               const BitReader& read_bit) {
  return read_case_with(Config::read_file(path, overrides), path, read_bit);
}

Case read_case(Config c, const std::string& path) {
  return read_case_with(std::move(c), path, read_now);
}

}  // namespace tdbd::simulation
