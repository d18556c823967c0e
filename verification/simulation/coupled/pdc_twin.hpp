#pragma once

#include <vector>

#include "reference/simulation/axial_bit.hpp"
#include "simulation/step/simulation.hpp"

/// Bit B as the program and as its twin run it, on an axis that a stiff string holds.
namespace tdbd::simulation {

/// A shipped case with bit B on rock and time steps `n` times finer than `edge_length` (m) and
/// `time_step` (s). Cutter 1 crosses the axis, where no mesh resolves how steeply it plunges: it cuts,
/// without force.
struct PdcCase {
  std::string name;
  double edge_length = 0.0, time_step = 0.0, duration = 0.0;
};

inline Case read_pdc_case(const PdcCase& p, double n) {
  return read_case(
      TDBD_SOURCE_DIR "/cases/" + p.name + ".toml",
      {fmt::format("rock.edge_length={}", p.edge_length / n),
       fmt::format("time.step={}", p.time_step / n), fmt::format("time.duration={}", p.duration),
       "string.lateral_stiffness=1e9", "string.lateral_damping=2e5", "string.bending_stiffness=1e7",
       "string.bending_damping=1e4", "forces.cutter_body.law='none'",
       "forces.areas.axis={names='cutter-1/*', law='none'}",
       "measure.section_at_face='extrapolated'"});
}

/// A run as both report it: at equal times, and means over its second half.
struct PdcFound {
  std::vector<double> height, speed;              // m, rad/s
  double depth = 0.0, turned = 0.0, spent = 0.0;  // m, rad, J at the end
  double weight = 0.0, torque = 0.0, rate = 0.0, slowest = 0.0, fastest = 0.0;
};

inline constexpr int pdc_rows = 40;

/// Collects steps into a PdcFound.
struct PdcMeans {
  double duration = 0.0;
  PdcFound f{};
  double time = 0.0, from = 0.0, from_depth = 0.0;

  void add(double t, double h, double depth, double speed, double weight, double torque) {
    const double row = duration / pdc_rows;
    while (t > row * (static_cast<double>(f.height.size()) + 1.0) - 0.5 * h) {
      f.height.push_back(depth);
      f.speed.push_back(speed);
    }
    if (t < 0.5 * duration + 0.5 * h) {
      from = t;
      from_depth = depth;
      f.slowest = f.fastest = speed;
      return;
    }
    f.weight += h * weight;
    f.torque += h * torque;
    f.slowest = std::min(f.slowest, speed);
    f.fastest = std::max(f.fastest, speed);
    time = t;
    f.depth = depth;
  }

  PdcFound end(double turned, double spent) {
    f.weight /= time - from;
    f.torque /= time - from;
    f.rate = (f.depth - from_depth) / (time - from);
    f.turned = turned;
    f.spent = spent;
    return f;
  }
};

inline PdcFound pdc_of_program(const Case& c, double duration) {
  Simulation s = start(c);
  PdcMeans means{.duration = duration};
  const double from = s.state.drive->state.c_W.z();
  while (s.state.steps_done < c.time.steps) {
    step(c, s);
    means.add(time_at(c.time, s.state.steps_done), c.time.step, s.state.drive->state.c_W.z() - from,
              s.work.velocity.w_W.z(), -s.work.loads.force_W.z(), -s.work.loads.torque_W.z());
  }
  return means.end(s.state.place.turned, -s.state.drive->ledger.cut_bit);
}

/// The string of a case in the twin's numbers.
inline reference::AxialString axial_string(const Case& c) {
  const dynamics::DrillingSystem& s = c.drilling.system;
  reference::AxialString a;
  a.mass = s.mass;
  a.inertia = s.gyrostat.inertia_B(2, 2);
  a.load = s.top.load.values.front();
  a.damping = s.string.damping(2, 2);
  a.rate = s.top.rate.values.empty() ? 0.0 : s.top.rate.values.front();
  a.following_time = s.top.following_time;
  a.stiffness = s.string.turn_stiffness(2, 2);
  a.turn_damping = s.string.turn_damping(2, 2);
  a.speed = s.top.speed.values.front();
  a.start_angle = s.top.start_angle;
  return a;
}

/// `columns`: of a face, at the coarsest level.
inline PdcFound pdc_of_twin(const Case& c, const reference::EdgeLaw& law, double duration, int n,
                            int columns, double time_step) {
  const std::string layout = TDBD_SOURCE_DIR "/cases/bits/bit-b.csv";
  reference::Columns bit = reference::make_columns(
      reference::read_round_cutters(layout, 0.3e-3, 0.25 * std::numbers::pi, 64), columns * n,
      0.3e-3 / n, 10e-3);
  bit.columns[0].clear();
  const reference::AxialString string = axial_string(c);
  reference::AxialState from;
  from.rate = string.rate;
  from.speed = string.speed;
  reference::AxialRun run(bit, law, string, from, 720 * n);
  PdcMeans means{.duration = duration};
  const double h = time_step / n;
  const long steps = std::lround(duration / h);
  for (long i = 1; i <= steps; ++i) {
    run.step(h);
    const reference::AxialLoads loads = run.loads();
    means.add(static_cast<double>(i) * h, h, run.state().height, run.state().speed, loads.weight,
              loads.torque);
  }
  return means.end(run.state().turned, run.state().spent);
}

}  // namespace tdbd::simulation
