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
#include "core/provenance.hpp"
#include "simulation/case/contact_slopes.hpp"
#include "simulation/case/doubtful_values.hpp"
#include "simulation/case/read_chain.hpp"
#include "simulation/case/run_settings.hpp"
#include "simulation/case/top_settings.hpp"

namespace tdbd::simulation {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

/// Reads the duration, or the number of revolutions if the rotary speed is given.
double duration_of(Config& c, const TimeSettings& t, const Motion& m) {
  if (!c.has("revolutions")) return t.duration;
  if (c.has("duration")) c.problem("revolutions", "duration as well", "one of the two");
  if (m.rotary_speed > 0.0) return t.revolutions * two_pi / m.rotary_speed;
  c.problem("revolutions", "a motion without rotary speed", "time.duration instead");
  return std::numeric_limits<double>::infinity();
}

/// In a time step the rock is swept along straight lines in the bit's frame, so a step must be a
/// small part of the motion.
TimeGrid read_time(Config& whole, const Motion& m) {
  constexpr double largest_turn = 0.5;  // rad
  constexpr double most_steps = 1e10;   // the fastest steps take 0.1 ms each: eleven days
  // Reads the time of a motion along a path. The default duration is that of the path.
  const double of_path = !has_path(m) ? 0.0 : m.path.empty() ? 1.0 : m.path.back().time;
  const auto settings = read_table(whole, TimeSettings{.duration = of_path});
  Config c = whole.table(TimeSettings::table);
  TimeGrid t;
  t.step = settings.step;
  const double duration = duration_of(c, settings, m);
  const double count = duration / t.step;
  t.steps = std::lround(std::min(count, most_steps));
  t.first = settings.first_step;
  if (t.first > 0 && t.first >= t.steps)
    c.problem("first_step", fmt::format("{} of {} steps", t.first, t.steps),
              "a step before the end of the run");
  if (!c.has("step")) return t;
  if (t.steps < 1)
    c.problem("step", fmt::format("{} s for a run of {} s", t.step, duration),
              "at most the duration");
  else if (count > most_steps && (std::isfinite(duration) || m.rotary_speed > 0.0))
    c.problem(
        "step",
        fmt::format("{} s for a run of {} s, which makes {:.3g} steps", t.step, duration, count),
        fmt::format("at most {:.0e} steps", most_steps));
  else if (m.rotary_speed * t.step > largest_turn)
    c.problem("step", fmt::format("a turn of {:.3g} rad in one step", m.rotary_speed * t.step),
              fmt::format("at most {} rad", largest_turn));
  return t;
}

void read_convergence(Config& c, OutputPlan& p) {
  try {
    if (!p.convergence_file.empty()) p.convergence = read_studied_convergence(p.convergence_file);
  } catch (const InputError& e) {
    c.other_file(e.what());
  }
}

/// By default, means are taken over the second half.
OutputPlan read_output(Config& whole, const TimeGrid& t, MotionKind kind) {
  const double duration = t.step * static_cast<double>(t.steps - t.first);
  OutputPlan p;
  p.history_every = usual_history_every(t.steps - t.first);
  p.means_from = 0.5 * duration;
  p = read_table(whole, p,
                 kind == MotionKind::drilling ? BitMotion::by_forces : BitMotion::prescribed);
  read_convergence(whole, p);
  return p;
}

/// Reads the bit. Its mistakes are added to those of the case.
bit::BitFile read_bit_of(Config& c, const UpdatePlan& update, const BitReader& read_bit) {
  const std::string file = read_table<BitSettings>(c).file;
  const std::vector<std::string> changes = c.table(BitSettings::table).table("set").assignments();
  bit::BitFile bit;
  try {
    if (!file.empty()) bit = read_bit(file, update.directions, update.inside_cutters, changes);
  } catch (const InputError& e) {
    c.other_file(e.what());
  }
  bit::set_tooth_directions(bit.bit, update.gage_teeth);
  return bit;
}

/// Rejects a weight that no part can carry, and a weight that is more than ten times the weight
/// that the bit would carry with all cutting parts one gage radius deep in rock. The latter is
/// probably in a wrong unit.
void check_overload(Config c, const Case& read) {
  constexpr double by_orders = 10.0;
  const double most = by_orders * weight_borne(read.bit, read.forces, read.bit.gage_radius);
  const std::string limit =
      most > 0.0
          ? fmt::format(
                "at most {:.4g} N: ten times what the bit would carry one gage radius deep in rock",
                most)
          : "0 N: no part of the bit has a force law that carries weight";
  for (const double load : read.drilling.system.top.load.values)
    if (load > most) return c.problem("weight_on_bit", fmt::format("{:.4g} N", load), limit);
}

/// Reads the output settings of a string on a chain, which must have been read already.
void read_string_output(Config c, Case& read) {
  const auto& chained = read.drilling.system.chained;
  if (!chained && c.problem_count() == 0) return refuse_chain_output(c);
  read.output.chain =
      read_chain_output(c, chained ? chained->chain : string::Chain{}, read.time.step);
}

/// Checks the requirements and the exclusions of a bit that is moved by forces.
void check_drilling_case(Config& c, const Case& read) {
  if (read.motion.kind != MotionKind::drilling) return;
  Config time = c.table(TimeSettings::table);
  if (read.forces.forces == Forces::off)
    c.problem(ForcePlan::table.name, "no table [forces]",
              "force laws, which a bit that drills requires");
  if (read.time.first > 0)
    time.problem("first_step", fmt::format("{} of a bit that forces move", read.time.first),
                 "0: the earlier motion is not in any file");
  if (read.measure.section_every > 1)
    c.table(MeasurePlan::table)
        .problem("section_every", fmt::format("{}", read.measure.section_every),
                 "1 if forces move the bit: with sections of earlier steps the motion is of first "
                 "order");
  if (c.problem_count() > 0) return;
  const dynamics::ContactSlopes slopes = contact_slopes(read.bit, read.forces);
  check_overload(c.table(Motion::table), read);
  const std::string unstable =
      dynamics::stability_problem(read.drilling.system, slopes, read.time.step);
  if (!unstable.empty())
    time.problem("step", fmt::format("{} s", read.time.step), "a stable step: " + unstable);
}

/// Cones that roll depend on their earlier contacts, which no file contains.
void check_continued_cones(Config c, const Case& read) {
  if (read.motion.cones.drive == ConeDrive::rolling && read.time.first > 0)
    c.problem("first_step", fmt::format("{} with rolling cones", read.time.first),
              "0: the earlier contacts of cones are not in any file");
}

/// Hashes the bit's file and the choices of [update] on which its parts depend.
std::string bit_hash(const UpdatePlan& update, const bit::BitFile& bit) {
  const rock::CuttingOptions& cutting = update.cutting;
  return fnv1a_hex(
      fmt::format("{}\n{} {} {} {} {}", bit.fingerprint, static_cast<int>(update.directions),
                  static_cast<int>(update.inside_cutters), static_cast<int>(update.gage_teeth),
                  static_cast<int>(cutting.directions), static_cast<int>(cutting.exit_from)));
}

/// Reads all tables and checks conditions between them.
bit::BitFile read_tables(Config& c, const BitReader& read_bit, Case& read) {
  read.update = read_table<UpdatePlan>(c);
  bit::BitFile file = read_bit_of(c, read.update, read_bit);
  read.bit = file.bit;
  for (const bit::BitDoubt& d : file.doubts) read.warnings.push_back({d.place, d.key, d.text});
  read.rock = read_rock(c);
  const RigLog log = read_rig_log(c);
  read.motion = read_motion(c, read.bit, log);
  read.time = read_time(c, read.motion);
  check_rig_log(c, log, read.time.step * static_cast<double>(read.time.steps));
  read.bit_hash = bit_hash(read.update, file);
  read.maintenance = read_table<rock::MaintenanceOptions>(c);
  read.measure = read_table<MeasurePlan>(c);
  read.output = read_output(c, read.time, read.motion.kind);
  check_continued_cones(c.table(TimeSettings::table), read);
  read.forces = read_forces(c, read.bit, read.measure, read.warnings);
  read.wear = read_wear(c, read.bit, read.forces);
  read.spalling = read_spalling(c, read.bit, read.measure, read.forces, read.warnings);
  if (read.motion.kind == MotionKind::drilling)
    read.drilling = read_drilling(c, read.bit, read.motion, read.time.step, read.warnings);
  read_string_output(c.table(OutputPlan::table), read);
  check_drilling_case(c, read);
  check_step_length(c, read);
  add_number_doubts(c, read.warnings);
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
  TitleSettings title;
  read_fields(c, title, Need::optional);
  result.title = title.title;
  const bit::BitFile bit = read_tables(c, read_bit, result);
  if (result.title.empty()) result.title = result.bit.name;
  Config rock = c.table(RockStart::table);
  result.places = {rock.place("edge_length"), c.place(Motion::table.name), rock.place("file"),
                   rock.place("profile"), c.table(TimeSettings::table).place("first_step")};
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
