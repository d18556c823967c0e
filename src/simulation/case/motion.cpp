#include "simulation/case/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/config/config.hpp"
#include "core/config/csv.hpp"
#include "core/error.hpp"
#include "rotation/screw.hpp"
#include "simulation/case/top_settings.hpp"

namespace tdbd::simulation {
namespace {

double ramp_fraction(double ramp, double t) { return ramp > 0.0 ? std::min(1.0, t / ramp) : 1.0; }

double sign(WhirlSense sense) { return sense == WhirlSense::forward ? 1.0 : -1.0; }

Vec3 orbit(const Whirl& w, double t) {
  const double angle = sign(w.sense) * w.frequency * t;
  return w.radius * ramp_fraction(w.ramp, t) * Vec3(std::cos(angle), std::sin(angle), 0.0);
}

/// The rotation that takes z to the leaning axis, about the horizontal line perpendicular to the
/// lean.
Mat3 lean(const Tilt& tilt, double t) {
  const double azimuth = tilt.azimuth + sign(tilt.sense) * tilt.frequency * t;
  return rotation::exp(tilt.angle * ramp_fraction(tilt.ramp, t) *
                       Vec3(-std::sin(azimuth), std::cos(azimuth), 0.0));
}

/// The rows before and after t, and the position of t between them.
struct Rows {
  const PathPoint *before, *after;
  double fraction;
};

Rows rows_around(const std::vector<PathPoint>& path, double t) {
  const auto after = std::upper_bound(
      path.begin(), path.end(), t, [](double time, const PathPoint& p) { return time < p.time; });
  if (after == path.begin()) return {&path.front(), &path.front(), 0.0};
  if (after == path.end()) return {&path.back(), &path.back(), 0.0};
  const PathPoint& a = *(after - 1);
  return {&a, &*after, (t - a.time) / (after->time - a.time)};
}

Vec3 turn_between(const PathPoint& a, const PathPoint& b) {
  return rotation::log(rotation::exp(a.rotation_WB).transpose() * rotation::exp(b.rotation_WB));
}

Pose pose_on(const std::vector<PathPoint>& path, double t) {
  const Rows at = rows_around(path, t);
  const Vec3 turn = at.fraction * turn_between(*at.before, *at.after);
  return {rotation::exp(at.before->rotation_WB) * rotation::exp(turn),
          (1.0 - at.fraction) * at.before->p_WB + at.fraction * at.after->p_WB};
}

using dynamics::AxialMode;
using dynamics::Schedule;

using Columns = std::array<std::size_t, 7>;

Columns find_columns(const CsvTable& t) {
  Columns c{};
  const std::array<const char*, 7> names{"time_s", "x_m",    "y_m",   "z_m",
                                         "rx_rad", "ry_rad", "rz_rad"};
  for (std::size_t i = 0; i < names.size(); ++i) c[i] = csv_column(t, names[i]);
  return c;
}

void require_rising_times(const CsvTable& t, const std::vector<PathPoint>& path) {
  if (path.size() < 2)
    throw InputError(fmt::format("{}: found {} rows, expected at least two", t.file, path.size()));
  for (std::size_t i = 1; i < path.size(); ++i)
    if (!(path[i].time > path[i - 1].time))
      throw InputError(fmt::format("{}:{}: time_s: found {} after {}, expected rising times",
                                   t.file, t.lines[i], path[i].time, path[i - 1].time));
}

double time_of_turn(double angle, double rotary_speed) {
  return rotary_speed > 0.0 ? angle / rotary_speed : 0.0;
}

double one_turn(double rotary_speed) { return time_of_turn(2.0 * std::numbers::pi, rotary_speed); }

/// Records a mistake at the leg after which the bit has turned too often. A path has a row for
/// every quarter of a turn (path_of); this many rows take 0.1 GB.
void check_turns(const std::vector<Leg>& legs, std::vector<Config>& tables) {
  constexpr double most_turns = 250'000.0;
  double turns = 0.0;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    turns += std::abs(legs[i].rotary_speed * legs[i].duration) / (2.0 * std::numbers::pi);
    if (!(turns > most_turns)) continue;
    return tables[i].problem("duration",
                             fmt::format("{:.4g} revolutions at the end of this leg", turns),
                             fmt::format("at most {} in all legs", most_turns));
  }
}

/// There is at least one leg. Legs with mistakes produce no path.
void read_legs(Config& c, Motion& m) {
  std::vector<Config> tables = c.tables(Leg::table);
  if (tables.empty()) c.problem("legs", "none", "one [[motion.legs]] or more");
  std::vector<Leg> legs;
  legs.reserve(tables.size());
  const std::size_t before = c.problem_count();
  for (Config& table : tables) read_fields(table, legs.emplace_back());
  if (c.problem_count() == before) check_turns(legs, tables);
  if (!legs.empty() && c.problem_count() == before) m.path = path_of(legs, m.start_W);
}

void read_path(Config& c, Motion& m) {
  if (m.path_file.empty()) return;
  try {
    m.path = read_path_table(m.path_file);
  } catch (const InputError& e) {
    c.other_file(e.what());
  }
}

void read_whirl_and_tilt(Config& c, Motion& m) {
  const double ramp = one_turn(m.rotary_speed);
  if (m.kind == MotionKind::whirl) m.whirl = read_table(c, Whirl{.ramp = ramp});
  if (c.has(Tilt::table)) m.tilt = read_table(c, Tilt{.ramp = ramp});
}

/// Reads a quantity, or a table of it over time.
Schedule read_schedule(Config& c, const QuantityKey& key) {
  if (!c.has(fmt::format("{}.values", key.name)))
    return dynamics::constant(c.read(key, std::nullopt));
  Config table = c.table(key);
  ScheduleSettings s;
  read_fields(table, s, key.unit);
  for (const double x : s.values)
    if (!key.range.contains(x))
      table.problem("values", fmt::format("{}", x), std::string(key.unit) + key.range.text());
  const std::string wrong = dynamics::schedule_problem(s.times, s.values);
  if (wrong.empty()) return dynamics::make_schedule(s.between, s.times, s.values);
  table.problem("times", wrong, "ascending times, and as many values");
  return dynamics::constant(0.0);
}

double fastest(const Schedule& speed) {
  return speed.values.empty() ? 0.0
                              : std::abs(*std::ranges::max_element(
                                    speed.values, {}, [](double v) { return std::abs(v); }));
}

/// Reads the speed of the top, and its rate or its weight. The prescribed motion in `m` is that of
/// a bit that follows its top.
void read_top(Config& c, const RigLog& log, Motion& m) {
  dynamics::TopDrive& top = m.driven.top;
  refuse_logged(c, motion_keys::rotary_speed, log.rotary_speed);
  refuse_logged(c, motion_keys::rate_of_penetration, log.block_speed);
  m.driven.hook_load = log.hook_load;
  top.speed =
      is_given(log.rotary_speed) ? log.rotary_speed : read_schedule(c, motion_keys::rotary_speed);
  const bool weight = c.has(motion_keys::weight_on_bit);
  if (weight == (c.has(motion_keys::rate_of_penetration) || is_given(log.block_speed)))
    c.problem("", weight ? "weight_on_bit and rate_of_penetration" : "neither",
              "weight_on_bit or rate_of_penetration");
  top.axial = weight ? AxialMode::load : AxialMode::rate;
  m.rotary_speed = dynamics::value_at(top.speed, 0.0);
  if (weight) {
    top.load = read_schedule(c, motion_keys::weight_on_bit);
    top.following_time = one_turn(fastest(top.speed));
  }
  read_fields(c, m.driven, top.axial);
  if (is_given(log.block_speed))
    top.rate = log.block_speed;
  else
    top.rate = weight ? dynamics::constant(m.driven.expected_rate)
                      : read_schedule(c, motion_keys::rate_of_penetration);
  m.rate_of_penetration = dynamics::value_at(top.rate, 0.0);
}

/// In the frame of the rock, whose origin is near the rock.
void check_start(Config& c, const Vec3& start_W) {
  constexpr double farthest = 1e5;  // m, more than the length of any borehole
  if (!(start_W.cwiseAbs().maxCoeff() <= farthest))
    c.problem("start", fmt::format("[{}, {}, {}] m", start_W.x(), start_W.y(), start_W.z()),
              fmt::format("a place within {:.0e} m", farthest));
}

/// Reads "rolling", or one speed for each cone of the bit.
void read_cone_motion(Config& c, const bit::Bit& bit, Motion& m) {
  constexpr double remembered_turn = 0.1;  // rad of the bit, well below the pitch of a gage row
  constexpr const char* key = "cone_speeds";
  if (bit.cones.empty() && !c.has(key)) return;
  m.cones.memory = time_of_turn(remembered_turn, m.rotary_speed);
  const bool rolls = c.is_text(key);
  read_fields(c, m.cones, rolls ? ConeDrive::rolling : ConeDrive::given);
  if (bit.parts.empty()) return;  // its mistakes are already recorded
  if (rolls && bit.cones.empty()) c.problem(key, "\"rolling\"", "a bit with cones");
  if (!rolls && m.cones.speeds.size() != bit.cones.size())
    c.problem(
        key, fmt::format("{} speeds", m.cones.speeds.size()),
        fmt::format("one for each of the bit's {} cones, over the bit's speed", bit.cones.size()));
}

}  // namespace

Pose pose_at(const Motion& m, double t) {
  if (has_path(m)) return pose_on(m.path, t);
  Pose X_WB{rotation::exp(Vec3(0.0, 0.0, m.rotary_speed * t)),
            m.start_W + Vec3(0.0, 0.0, m.rate_of_penetration * t)};
  if (m.kind == MotionKind::whirl) X_WB.p += orbit(m.whirl, t);
  if (m.tilt.angle > 0.0) X_WB.R = lean(m.tilt, t) * X_WB.R;
  return X_WB;
}

void sum_turns(std::vector<PathPoint>& path) {
  for (std::size_t i = 1; i < path.size(); ++i)
    path[i].turned = path[i - 1].turned + turn_between(path[i - 1], path[i]).z();
}

std::vector<PathPoint> path_of(const std::vector<Leg>& legs, const Vec3& start_W) {
  constexpr double quarter_turn = 0.5 * std::numbers::pi;
  std::vector<PathPoint> path{{0.0, start_W, Vec3::Zero()}};
  for (const Leg& leg : legs) {
    const PathPoint from = path.back();
    const double turn = leg.rotary_speed * leg.duration;
    const long rows = std::max(1L, std::lround(std::ceil(std::abs(turn) / quarter_turn)));
    for (long k = 1; k <= rows; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(rows);
      path.push_back({from.time + share * leg.duration,
                      from.p_WB + share * leg.duration * leg.velocity_W,
                      from.rotation_WB + share * turn * Vec3::UnitZ()});
    }
  }
  sum_turns(path);
  return path;
}

double angle_turned(const Motion& m, double t) {
  if (!has_path(m)) return m.rotary_speed * t;
  const Rows at = rows_around(m.path, t);
  return (1.0 - at.fraction) * at.before->turned + at.fraction * at.after->turned;
}

std::vector<double> cone_angles(const Motion& m, double t) {
  std::vector<double> angles;
  for (const double speed : m.cones.speeds) angles.push_back(-speed * angle_turned(m, t));
  return angles;
}

std::vector<PathPoint> read_path_table(const std::string& file) {
  const CsvTable t = read_csv(file);
  const Columns c = find_columns(t);
  std::vector<PathPoint> path;
  path.reserve(t.rows.size());
  for (std::size_t i = 0; i < t.rows.size(); ++i) {
    const std::vector<double>& row = t.rows[i];
    path.push_back({row[c[0]], Vec3(row[c[1]], row[c[2]], row[c[3]]),
                    Vec3(row[c[4]], row[c[5]], row[c[6]]), 0.0, t.lines[i]});
  }
  require_rising_times(t, path);
  sum_turns(path);
  return path;
}

Motion read_motion(Config& whole, const bit::Bit& bit, const RigLog& log) {
  Motion m = read_table<Motion>(whole);
  Config c = whole.table(Motion::table);
  if (m.kind != MotionKind::table) check_start(c, m.start_W);
  switch (m.kind) {
    case MotionKind::table:
      read_path(c, m);
      break;
    case MotionKind::legs:
      read_legs(c, m);
      break;
    case MotionKind::drilling:
      read_top(c, log, m);
      return m;
    case MotionKind::steady:
    case MotionKind::whirl:
      read_whirl_and_tilt(c, m);
  }
  read_cone_motion(c, bit, m);
  return m;
}

}  // namespace tdbd::simulation
