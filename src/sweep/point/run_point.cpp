#include "sweep/point/run_point.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>

#include "bit/cutter/cutter.hpp"
#include "bit/files/bit_file.hpp"
#include "bit/report/bit_report.hpp"
#include "calibration/result/calibrate.hpp"
#include "core/error.hpp"
#include "core/provenance.hpp"
#include "core/text.hpp"
#include "forces/part/directions.hpp"
#include "simulation/result/run.hpp"
#include "simulation/rotate/rotate_case.hpp"
#include "simulation/rotate/rotate_run.hpp"
#include "simulation/rotate/rotate_simulation.hpp"
#include "simulation/step/loads.hpp"

namespace tdbd::sweep {
namespace {

namespace sim = simulation;

/// What a cutter cuts in the radial plane.
struct CutterCut {
  const bit::Cutter& cutter;
  double area = 0.0, edge = 0.0, arm = 0.0;  ///< m2, m, m
};

/// The contact of a face: its area in the plane of the face gives the cut area normal to its path.
void take_face(const CutterCut& cut, const Vec3& along_W, sim::CutOfPart& c) {
  const double ahead = c.forward_W.dot(along_W);
  c.cut.diameter = cut.cutter.diameter;
  c.face_area = ahead > 0.0 ? cut.area / ahead : 0.0;
}

/// The contact of a chamfer behind the engaged edge.
void take_chamfer(const CutterCut& cut, const Vec3& along_W, sim::CutOfPart& c) {
  const double rake = forces::effective_back_rake(c.forward_W, along_W);
  c.cut.contact_area = cut.edge * sim::chamfer_width(cut.cutter, rake);
}

/// The cut of a face or a chamfer at its place in the hole.
sim::CutOfPart cut_of(const sim::Case& c, int part, const CutterCut& cut,
                      const sim::BitVelocity& motion, const Pose& X_WB) {
  const bit::Part& of = c.bit.parts[static_cast<std::size_t>(part)];
  const Vec3 p_B(cut.arm * std::cos(cut.cutter.azimuth), cut.arm * std::sin(cut.cutter.azimuth),
                 -cut.cutter.tip_height);
  sim::CutOfPart found;
  found.part = part;
  found.cut.kind = of.kind;
  found.cut.point = X_WB * p_B;
  found.cut.normal = X_WB.R * bit::profile_normal_B(cut.cutter);
  found.cut.engaged_edge = cut.edge;
  found.forward_W = X_WB.R * cut.cutter.X_BC.R.col(0);
  const Vec3 along_W = sim::velocity_at(c.bit, X_WB, motion, -1, found.cut.point).normalized();
  if (of.kind == bit::PartKind::face)
    take_face(cut, along_W, found);
  else
    take_chamfer(cut, along_W, found);
  found.cut.strength = forces::strength_at(c.forces.rock, found.cut.point);
  return found;
}

}  // namespace

PlanarLoads planar_loads(const sim::Case& c, const std::vector<int>& indices,
                         const bit::Engagement& e, double advance) {
  constexpr double any_time = 1e-3;  // s: no cut of the planar model depends on the time step
  const double speed = c.motion.rotary_speed;
  const double rate = advance * speed / (2.0 * std::numbers::pi);
  const Pose X_WB;
  const sim::BitVelocity motion{X_WB.p, Vec3(0.0, 0.0, rate), Vec3(0.0, 0.0, speed), {}};
  PlanarLoads sum;
  for (std::size_t p = 0; p < c.bit.parts.size(); ++p) {
    const bit::Part& part = c.bit.parts[p];
    const auto k = std::ranges::find(indices, part.cutter) - indices.begin();
    const bool cuts = part.kind == bit::PartKind::face || part.kind == bit::PartKind::chamfer;
    if (!cuts || k == std::ssize(indices) || !sim::has_law(c.forces, c.bit, p)) continue;
    const double area = e.area[static_cast<std::size_t>(k)];
    if (!(area > 0.0)) continue;
    const CutterCut cut{c.bit.cutters[static_cast<std::size_t>(part.cutter)], area,
                        e.edge[static_cast<std::size_t>(k)],
                        e.volume[static_cast<std::size_t>(k)] / (2.0 * std::numbers::pi * area)};
    const sim::CutOfPart found = cut_of(c, static_cast<int>(p), cut, motion, X_WB);
    const sim::PartLoad load = sim::load_of(c.forces, c.bit, X_WB, motion, any_time, found);
    sum.force_B += load.force_W;
    sum.torque -= load.point_W.cross(load.force_W).z();
  }
  return sum;
}

nlohmann::ordered_json planar_summary(const sim::Case& c, double normal_ratio) {
  const sim::Motion& m = c.motion;
  const std::vector<int> indices = bit::cutting_at_start(c.bit);
  if (indices.empty())
    throw InputError(
        "bit.file: found a bit without cutters that cut from the start, expected one that the "
        "planar model knows");
  if (!(m.rotary_speed > 0.0 && m.rate_of_penetration > 0.0))
    throw InputError(
        "motion: found no advance per revolution, expected a rotary speed and a rate of "
        "penetration");
  const double advance = 2.0 * std::numbers::pi * m.rate_of_penetration / m.rotary_speed;
  const std::vector<bit::Cutter> cutters = bit::cutters_at(c.bit, indices);
  const bit::Engagement e = bit::engagement(cutters, advance, bit::report_column_width);
  const double classical = bit::planar_imbalance(cutters, e.area, normal_ratio);
  nlohmann::ordered_json weight, torque, imbalance = classical;
  if (c.forces.forces == sim::Forces::on) {
    const PlanarLoads loads = planar_loads(c, indices, e, advance);
    weight = -loads.force_B.z();
    torque = loads.torque;
    imbalance = loads.force_B.z() < 0.0
                    ? nlohmann::ordered_json(loads.force_B.head<2>().norm() / -loads.force_B.z())
                    : nlohmann::ordered_json();
  }
  return {{"advance_m", advance},
          {"imbalance", imbalance},
          {"imbalance_of_normal_ratio", classical},
          {"imbalance_of_unit_law", bit::imbalance(cutters, e.area)},
          {"wob_n", weight},
          {"tob_n_m", torque},
          {"mean_redundancy", bit::mean_redundancy(e.cutting)},
          {"cut_area_m2", std::accumulate(e.area.begin(), e.area.end(), 0.0)},
          {"largest_cut_area_m2", std::ranges::max(e.area)},
          {"engaged_cutters", std::ranges::count_if(e.area, [](double a) { return a > 0.0; })}};
}

namespace {

namespace sim = simulation;

constexpr double most_bits = 16.0;      // some megabytes each
constexpr double most_triangles = 1e6;  // about 200 bytes each

double or_none(double most, Keeping keeping) { return keeping == Keeping::on ? most : 0.0; }

template <class T>
double one(const T&) {
  return 1.0;
}

double triangles(const sim::StartSurface& s) {
  return static_cast<double>(s.surface.triangle_count());
}

}  // namespace

Starts::Starts(Keeping keeping)
    : files(or_none(most_bits, keeping)),
      bits(or_none(most_bits, keeping)),
      surfaces(or_none(most_triangles, keeping)) {}

sim::Case read_case(const std::string& path, const std::vector<std::string>& overrides,
                    Starts& kept) {
  const auto reader = [&](const std::string& file, bit::DirectionRule directions,
                          bit::InsideRule inside, const std::vector<std::string>& changes) {
    const auto read = [&] {
      return bit::read_bit(file, directions, inside, bit::Densities::as_given, changes);
    };
    const std::string key = fmt::format("{}\n{} {}\n{}", file, static_cast<int>(directions),
                                        static_cast<int>(inside), fmt::join(changes, "\n"));
    return *kept.files.get(key, read, one<bit::BitFile>);
  };
  return sim::read_case(path, overrides, reader);
}

sim::Simulation start(const sim::Case& c, Starts& kept, rock::CuttingBit reused_bit) {
  const auto bit = kept.bits.get(
      c.bit_hash, [&] { return rock::prepare_cutting_bit(c.bit, c.update.cutting); },
      one<rock::CuttingBit>);
  const auto surface = kept.surfaces.get(
      sim::start_surface_key(c), [&] { return sim::start_surface(c); }, triangles);
  reused_bit = *bit;
  return sim::start(c, std::move(reused_bit), *surface);
}

namespace {

namespace sim = simulation;
using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;
using Numbers = std::vector<std::pair<std::string, double>>;

void collect(const Json& value, const std::string& name, Numbers& numbers) {
  const std::string before = name.empty() ? "" : name + ".";
  if (value.is_object()) {
    for (const auto& [key, child] : value.items()) collect(child, before + key, numbers);
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i)
      collect(value[i], fmt::format("{}{}", before, i), numbers);
  } else if (value.is_number()) {
    numbers.emplace_back(name, value.get<double>());
  } else if (value.is_boolean()) {
    numbers.emplace_back(name, value.get<bool>() ? 1.0 : 0.0);
  } else if (value.is_null()) {
    numbers.emplace_back(name, std::numeric_limits<double>::quiet_NaN());
  }
}

Numbers numbers_of(const Json& summary) {
  Numbers numbers;
  collect(summary, "", numbers);
  return numbers;
}

struct Summary {
  std::string case_hash, text;
};

void stop_if(sim::RunStatus status) {
  if (status == sim::RunStatus::interrupted) throw Interrupted{};
}

/// Does the same as `tdbd run`, without its files.
Summary drill(const Design& d, const Words& overrides, PointSurroundings& around) {
  const sim::Case c = read_case(d.case_file, overrides, around.starts);
  sim::Simulation s = start(c, around.starts, std::move(around.reused_bit));
  sim::DrillingSteps steps(c, s, sim::plan_energy_order(c));
  sim::RunOptions options;
  options.interrupted = around.interrupted;
  stop_if(sim::run_loop(steps, options));
  sim::RunSummary summary = sim::summary_of(c, s, sim::RunStatus::completed);
  if (summary.drive) summary.drive->order = steps.order;
  around.reused_bit = std::move(s.work.cutting);
  return {c.hash, sim::to_json(summary)};
}

Summary rotate(const Design& d, const Words& overrides, const std::atomic<bool>* interrupted) {
  const sim::RotateCase c = sim::read_rotate_case(d.case_file, overrides);
  sim::RotateOptions options;
  options.interrupted = interrupted;
  sim::RotateSimulation s = sim::start(c);
  sim::RotateSteps steps(c, s);
  stop_if(sim::run_loop(steps, options));
  return {c.hash, sim::summary_json(c, s, sim::RunStatus::completed)};
}

/// Calibrations take turns, because cut runs are files and the library that reads them does not
/// support threads.
Summary fit(const Design& d, const Words& overrides, const std::filesystem::path& cuts) {
  static std::mutex turn;
  const std::lock_guard hold(turn);
  const auto c = calibration::read_calibration(d.case_file, overrides);
  std::filesystem::create_directories(cuts);
  const auto found = calibration::calibrate(c, calibration::find_cuts(c, cuts));
  const std::string text = calibration::to_json(c, found);
  return {fnv1a_hex(text), text};
}

Summary analyse(const Design& d, const Words& overrides) {
  const bit::BitFile read =
      bit::read_bit(d.case_file, bit::DirectionRule::hybrid, bit::InsideRule::down,
                    bit::Densities::required, overrides);
  bit::ReportOptions options;
  options.advance = d.penetration;
  return {fnv1a_hex(read.fingerprint), bit::analysis_json(read.bit, options)};
}

Summary judge(const Design& d, const Words& overrides) {
  const sim::Case c = sim::read_case(d.case_file, overrides);
  return {c.hash, planar_summary(c, d.normal_ratio).dump()};
}

Summary summary_of(const Design& d, const Words& overrides, PointSurroundings& around) {
  switch (d.command) {
    case Command::run:
      return drill(d, overrides, around);
    case Command::rotate:
      return rotate(d, overrides, around.interrupted);
    case Command::calibrate:
      return fit(d, overrides, around.cuts);
    case Command::planar:
      return judge(d, overrides);
    case Command::bit:
      break;
  }
  return analyse(d, overrides);
}

/// Makes the paths of files in a message relative to the design's folder, so that the message does
/// not depend on the location of that folder.
std::string from_folder(const Design& d, std::string message) {
  const std::string folder =
      (std::filesystem::absolute(d.file).lexically_normal().parent_path() / "").string();
  for (std::size_t at = message.find(folder); at != std::string::npos;
       at = message.find(folder, at))
    message.erase(at, folder.size());
  return message;
}

}  // namespace

std::vector<std::string> figure_names(const Json& summary) {
  std::vector<std::string> names;
  for (const auto& [name, number] : numbers_of(summary)) names.push_back(name);
  return names;
}

std::vector<double> summarize(const Json& summary, const std::vector<std::string>& names) {
  std::map<std::string, double> numbers;
  for (const auto& [name, number] : numbers_of(summary)) numbers.emplace(name, number);
  std::vector<double> figures;
  std::string missing;
  for (const std::string& name : names) {
    const auto found = numbers.find(name);
    if (found != numbers.end()) {
      figures.push_back(found->second);
      continue;
    }
    const auto nearest = nearest_name(name, figure_names(summary));
    missing +=
        fmt::format("{}sweep.figures: found {}, expected a number of the summary{}",
                    missing.empty() ? "" : "\n", name, nearest ? ", such as " + *nearest : "");
  }
  if (!missing.empty()) throw InputError(missing);
  return figures;
}

const char* name_of(Steady steady) {
  return steady == Steady::yes ? "yes" : steady == Steady::no ? "no" : "unknown";
}

PointOutcome run_point(const Design& d, const Words& overrides, PointSurroundings& around) {
  PointOutcome outcome;
  bool ended = false;
  try {
    const Summary summary = summary_of(d, overrides, around);
    ended = true;
    outcome.case_hash = summary.case_hash;
    const Json json = Json::parse(summary.text);
    outcome.figures = summarize(json, d.figures);
    if (const auto steady = json.find("steady"); steady != json.end() && steady->is_boolean())
      outcome.steady = steady->get<bool>() ? Steady::yes : Steady::no;
  } catch (const std::exception& e) {
    outcome.status = PointStatus::failed;
    outcome.lacks_figures = ended;
    outcome.message = from_folder(d, error_message_of(e));
    outcome.figures.assign(d.figures.size(), std::numeric_limits<double>::quiet_NaN());
  }
  return outcome;
}

PointInputs inputs_of(const Design& d, const Words& overrides) {
  switch (d.command) {
    case Command::run:
    case Command::planar: {
      const sim::Case c = sim::read_case(d.case_file, overrides);
      return {c.files, sim::doubts_about_numbers(c.warnings)};
    }
    case Command::rotate: {
      const sim::RotateCase c = sim::read_rotate_case(d.case_file, overrides);
      return {c.files, {}};
    }
    case Command::calibrate: {
      const auto c = calibration::read_calibration(d.case_file, overrides);
      return {c.files, c.doubts};
    }
    case Command::bit:
      break;
  }
  return {bit::read_bit(d.case_file, bit::DirectionRule::hybrid, bit::InsideRule::down,
                        bit::Densities::as_given, overrides)
              .files,
          {}};
}

Words figures_on_offer(const Design& d, const Words& overrides, const std::filesystem::path& cuts) {
  Starts starts(Keeping::off);
  PointSurroundings around{cuts, nullptr, starts};
  return figure_names(Json::parse(summary_of(d, overrides, around).text));
}

}  // namespace tdbd::sweep
