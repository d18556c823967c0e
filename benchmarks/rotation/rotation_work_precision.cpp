// Work-precision: what every drift, order and other program needs for an attitude error at t = 10
// s.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "benchmarks/rotation/work_precision.hpp"

namespace tdbd::bench {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const WorkPoint& p) {
  return {{"setting", p.setting},
          {"steps", p.steps},
          {"torque_evaluations", p.torque_evaluations},
          {"microseconds", p.microseconds},
          {"attitude_error", p.errors.attitude},
          {"cone_angle_error_rad", p.errors.cone_angles},
          {"momentum_error", p.errors.momentum},
          {"energy_error", p.errors.energy}};
}

Json to_json(const WorkPrecision& work) {
  Json curve = Json::array(), targets = Json::array();
  for (const WorkPoint& p : work.curve) curve.push_back(to_json(p));
  for (std::size_t i = 0; i < work.at_target.size(); ++i)
    targets.push_back({{"attitude_error", attitude_targets[i]},
                       {"run", work.at_target[i] ? to_json(*work.at_target[i]) : Json()}});
  return {{"curve", curve}, {"targets", targets}};
}

const WorkPoint& finest(const WorkPrecision& work) {
  const auto by_error = [](const WorkPoint& a, const WorkPoint& b) {
    return a.errors.attitude < b.errors.attitude;
  };
  return *std::min_element(work.curve.begin(), work.curve.end(), by_error);
}

void print(const std::string& name, const WorkPrecision& work) {
  fmt::print("{:28}", name);
  for (const auto& p : work.at_target)
    if (p)
      fmt::print(" | {:9} {:9.1f} {:8.1e} {:8.1e}", p->torque_evaluations, p->microseconds,
                 p->errors.momentum, std::abs(p->errors.energy));
    else
      fmt::print(" | {:>9} {:>9} {:>8} {:>8}", "-", "-", "-", "-");
  const WorkPoint& best = finest(work);
  fmt::print(" | {:8.1e} {:8.1e}\n", best.errors.attitude, best.errors.cone_angles);
  std::fflush(stdout);
}

void print_header(const RotationCase& c) {
  fmt::print("\n{}, attitude error at t = {} s\n{:28}", c.name, c.duration, "");
  for (const double target : attitude_targets) fmt::print(" | {:<37.0e}", target);
  fmt::print(" | best error\n{:28}", "");
  for (std::size_t i = 0; i < std::size(attitude_targets); ++i)
    fmt::print(" | {:>9} {:>9} {:>8} {:>8}", "torques", "us", "momentum", "energy");
  fmt::print(" | {:>8} {:>8}\n", "attitude", "cones");
}

Json measure_case(const RotationCase& c, const std::string& only) {
  Json results = Json::array();
  print_header(c);
  for (const Contender& contender : all_contenders()) {
    if (!contender.absent.empty())
      fmt::print("{:28} | ABSENT: {}\n", contender.name, contender.absent);
    for (const Method& method : contender.methods) {
      const std::string name = contender.name + " " + method.name;
      if (name.find(only) == std::string::npos) continue;
      const WorkPrecision work = measure_work(c, method);
      print(name, work);
      Json result = {{"program", contender.name}, {"method", method.name}};
      result.update(to_json(work));
      results.push_back(result);
    }
  }
  return results;
}

Json absent_contenders() {
  Json absent = Json::object();
  for (const Contender& contender : all_contenders())
    if (!contender.absent.empty()) absent[contender.name] = contender.absent;
  return absent;
}

}  // namespace
}  // namespace tdbd::bench

int main(int argc, char** argv) {
  using namespace tdbd::bench;
  CLI::App app("Torque evaluations and CPU time for an attitude error at t = 10 s");
  std::string json_path, only;
  bool all_cases = false;
  app.add_option("--json", json_path, "write every run to this file");
  app.add_option("--only", only, "methods whose name holds this text");
  app.add_flag("--all-cases", all_cases, "also the bodies with three cones");
  CLI11_PARSE(app, argc, argv);
  std::vector<RotationCase> cases = {slow_top()};
  if (all_cases) cases.insert(cases.end(), {free_gyrostat(), heavy_gyrostat()});
  Json result = {{"schema", 1}, {"absent", absent_contenders()}, {"cases", Json::object()}};
  for (const RotationCase& c : cases) result["cases"][c.name] = measure_case(c, only);
  if (json_path.empty()) return 0;
  std::ofstream file(json_path);
  file << result.dump(1) << '\n';
  return file.good() ? 0 : 1;
}
