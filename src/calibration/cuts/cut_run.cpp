#include "calibration/cuts/cut_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bit/files/bit_file.hpp"
#include "core/config/config.hpp"
#include "core/error.hpp"
#include "forces/laws/laws.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::calibration {
namespace {

using simulation::CutOfPart;

constexpr double turns_per_second = 2.0;

/// The law is arbitrary as long as it applies to the parts of a cutter, because only their cuts are
/// used.
constexpr const char* cut_case_text = R"([bit]
file = {file}
[rock]
shape = "conforming"
edge_length = {edge}
wall = 0.03
material = "mancos-shale"
[motion]
kind = "steady"
rotary_speed = {speed}
rate_of_penetration = {rate}
[time]
step = {step}
revolutions = {turns}
[forces]
law = "hanson-hansen"
A1 = 1.0
A3 = 0.3
[output]
means_from = 0.0
)";

/// Sums over steps, from which the mean of a part is computed.
struct Sum {
  CutOfPart mean;       ///< sums of areas, lengths and volumes
  double weight = 0.0;  ///< weight of directions and points
};

void add(const CutOfPart& cut, const Pose& X_BW, Sum& s) {
  const double weight = cut.face_area > 0.0 ? cut.face_area : cut.cut.contact_area;
  CutOfPart& m = s.mean;
  m.part = cut.part;
  m.cut.kind = cut.cut.kind;
  m.cut.diameter = cut.cut.diameter;
  m.face_area += cut.face_area;
  m.cut.removed_volume += cut.cut.removed_volume;
  m.cut.contact_area += cut.cut.contact_area;
  m.cut.engaged_edge += cut.cut.engaged_edge;
  m.cut.point += weight * (X_BW * cut.cut.point);
  m.cut.normal += weight * (X_BW.R * cut.cut.normal);
  m.forward_W += weight * (X_BW.R * cut.forward_W);
  s.weight += weight;
}

CutOfPart mean_of(const Sum& s, double steps) {
  CutOfPart m = s.mean;
  m.face_area /= steps;
  m.cut.removed_volume /= steps;
  m.cut.contact_area /= steps;
  m.cut.engaged_edge /= steps;
  m.cut.point /= s.weight;
  m.cut.normal.normalize();
  m.forward_W.normalize();  // remains zero for a part without a face
  return m;
}

/// Throws InputError for a bit with cones. Mistakes in the generated case would mean nothing to the
/// user.
void reject_cones(const CalibrationCase& c, const Tool& tool) {
  const bit::BitFile file = bit::read_bit(tool.bit_file, {}, {});
  if (!file.bit.cones.empty())
    throw InputError(
        fmt::format("{}: bits.{}: found a bit with cones, expected fixed cutters: the "
                    "cuts of teeth have no mean place on the bit",
                    c.path, tool.name));
}

}  // namespace

double depth_of_run(const Record& record) {
  constexpr double picometres = 1e12;
  return std::round(record.depth * picometres) / picometres;
}

simulation::Case cut_case(const CalibrationCase& c, const Tool& bit, double depth) {
  std::string text = fmt::format(
      cut_case_text, fmt::arg("file", toml_string(bit.bit_file)),
      fmt::arg("edge", c.grid.edge_length),
      fmt::arg("speed", 2.0 * std::numbers::pi * turns_per_second),
      fmt::arg("rate", depth * turns_per_second),
      fmt::arg("step", 1.0 / (turns_per_second * static_cast<double>(c.grid.steps_per_revolution))),
      fmt::arg("turns", static_cast<double>(c.grid.revolutions)));
  if (c.grid.breakout)
    text += fmt::format("[spalling]\nangle = {}\ndepth_share = {}\nahead_share = {}\n",
                        c.grid.breakout->angle, c.grid.breakout->depth_share,
                        c.grid.breakout->ahead_share);
  try {
    return simulation::read_case(Config::read_text(text, c.path), c.path);
  } catch (const InputError&) {
    reject_cones(c, bit);
    throw;
  }
}

CutRun make_cut_run(const simulation::Case& c, double depth, long steps_per_revolution) {
  simulation::Simulation s = simulation::start(c);
  std::vector<Sum> sums(c.bit.parts.size());
  for (long step = 0; step < c.time.steps; ++step) {
    simulation::step(c, s);
    if (step < c.time.steps - steps_per_revolution) continue;
    const Pose X_BW = inverse(s.state.place.X_WB);
    for (const CutOfPart& cut : s.work.cuts) add(cut, X_BW, sums[at(cut.part)]);
  }
  CutRun run{depth, {}};
  for (const Sum& sum : sums)
    if (sum.weight > 0.0)
      run.cuts.push_back(mean_of(sum, static_cast<double>(steps_per_revolution)));
  return run;
}

namespace {

/// Length of the rim in the rock: an arc of the face, which is foreshortened in depth.
double engaged_rim(const SingleCutter& c, double depth) {
  const double radius = 0.5 * c.diameter;
  const double in_face = depth / std::cos(c.back_rake);
  return c.diameter * std::acos(std::clamp(1.0 - in_face / radius, -1.0, 1.0));
}

const Vec3 arm(0.0, -1.0, 0.0);  // m

}  // namespace

CutRun groove_cut(const SingleCutter& c, double depth, double ahead_share) {
  const forces::GrooveCutter groove{c.diameter, c.back_rake};
  double cut_area = forces::groove_area(groove, depth);
  if (ahead_share > 0.0) cut_area -= forces::groove_area(groove, ahead_share * depth);
  const double rim = engaged_rim(c, depth);
  simulation::CutOfPart face;
  face.cut.kind = bit::PartKind::face;
  face.cut.diameter = c.diameter;
  face.cut.engaged_edge = rim;
  face.cut.point = arm;
  face.cut.normal = Vec3::UnitZ();
  face.face_area = cut_area / std::cos(c.back_rake);
  face.forward_W = Vec3(std::cos(c.back_rake), 0.0, -std::sin(c.back_rake));
  CutRun run{depth, {face}};
  const double pressed = c.wear_flat + c.chamfer * rim;
  if (!(pressed > 0.0)) return run;
  simulation::CutOfPart flat = face;
  flat.cut.kind = bit::PartKind::chamfer;
  flat.cut.contact_area = pressed;
  flat.face_area = 0.0;
  flat.forward_W.setZero();
  run.cuts.push_back(flat);
  return run;
}

}  // namespace tdbd::calibration
