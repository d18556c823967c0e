#include "claims/mesh_noise_runs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

#include "claims/rock_runs.hpp"

namespace tdbd::claims {
namespace {

/// Torque in every step of a case after its first `skipped` steps.
std::vector<double> torques(const simulation::Case& c, long skipped) {
  simulation::Simulation s = simulation::start(c);
  std::vector<double> torque;
  while (s.state.steps_done < c.time.steps) {
    simulation::step(c, s);
    if (s.state.steps_done > skipped) torque.push_back(-s.work.loads.torque_W.z());
  }
  return torque;
}

TorqueRun made(const char* name, std::vector<std::string> settings, long skipped, TorqueRun run) {
  settings.push_back(fmt::format("bit.file='bits/{}.toml'", cutter_meshes.at(run.mesh).bit));
  settings.push_back(fmt::format("forces.cut={}", cuts.at(run.cut)));
  settings.push_back(fmt::format("rock.edge_length={}", run.edge));
  run.torque = torques(rock_case(name, settings), skipped);
  return run;
}

}  // namespace

double mean(const TorqueRun& run) {
  return std::accumulate(run.torque.begin(), run.torque.end(), 0.0) /
         static_cast<double>(run.torque.size());
}

double noise(const TorqueRun& run) {
  const double m = mean(run);
  double squares = 0.0;
  for (const double t : run.torque) squares += (t - m) * (t - m);
  return std::sqrt(squares / static_cast<double>(run.torque.size())) / m;
}

double step_noise(const TorqueRun& run) {
  double squares = 0.0;
  for (std::size_t i = 1; i < run.torque.size(); ++i)
    squares += (run.torque[i] - run.torque[i - 1]) * (run.torque[i] - run.torque[i - 1]);
  return std::sqrt(squares / static_cast<double>(run.torque.size() - 1)) / mean(run);
}

const std::vector<TorqueRun>& steady_runs() {
  static const std::vector<TorqueRun> all = [] {
    std::vector<TorqueRun> runs;
    for (std::size_t mesh = 0; mesh < cutter_meshes.size(); ++mesh)
      for (std::size_t cut = 0; cut < cuts.size(); ++cut)
        for (const double edge : rock_edges)
          runs.push_back(made("bit-a-3000psi", {"time.revolutions=2"}, 500, {mesh, cut, edge, {}}));
    return runs;
  }();
  return all;
}

const std::vector<TorqueRun>& runs_without_rest() {
  static const std::vector<TorqueRun> all = [] {
    std::vector<TorqueRun> runs;
    for (const double edge : rock_edges)
      runs.push_back(made("bit-a-3000psi", {"time.revolutions=2", "maintenance.rest=0"}, 500,
                          {0, 0, edge, {}}));
    return runs;
  }();
  return all;
}

const std::vector<TorqueRun>& drilling_runs() {
  static const std::vector<TorqueRun> all = [] {
    std::vector<TorqueRun> runs;
    for (std::size_t mesh = 0; mesh < cutter_meshes.size(); ++mesh)
      for (std::size_t cut = 0; cut < cuts.size(); ++cut)
        runs.push_back(made(
            "high-frequency",
            {"motion.torque_at_start='2100 N m'", "time.duration='2 s'", "output.means_from='1 s'"},
            1000, {mesh, cut, 2e-3, {}}));
    return runs;
  }();
  return all;
}

const TorqueRun& run_of(const std::vector<TorqueRun>& runs, std::size_t mesh, std::size_t cut,
                        double edge) {
  for (const TorqueRun& r : runs)
    if (r.mesh == mesh && r.cut == cut && r.edge == edge) return r;
  throw std::logic_error("no such run");
}

}  // namespace tdbd::claims
