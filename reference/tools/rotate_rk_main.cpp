#include <cstdio>
#include <exception>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "reference/dynamics/work_precision.hpp"
#include "simulation/rotate/rotate_case.hpp"

namespace {

using tdbd::InputError;
using tdbd::reference::ComparisonMethod;
using tdbd::reference::WorkPrecision;
using Json = nlohmann::ordered_json;

constexpr const char* usage =
    "Usage: rotate-runge-kutta CASE.toml METHOD NUMBER... [--set KEY=VALUE]...\n"
    "Runs a rotate case by a Runge-Kutta method, once for each number, and prints one line of "
    "JSON\n"
    "for each: method, accuracy (the number), torque_evaluations, attitude_error_rad (at the end,\n"
    "against rk8pd at a tolerance of rounding), attitude (3 x 3), body_momentum, cone_angles,\n"
    "cone_momenta. The case's own integrator and step are not used.\n"
    "METHOD: rk8pd, rkf45 (GSL, adaptive): a number is a tolerance, absolute and relative;\n"
    "        rk4 (classical, fixed): a number is how many steps.\n"
    "Example: rotate-runge-kutta cases/slow-top.toml rk8pd 1e-4 1e-6 1e-8\n"
    "Exit codes: 0 done, 1 the computation failed, 2 the input is wrong.\n";

struct Arguments {
  std::string path, method;
  std::vector<double> accuracies;
  std::vector<std::string> overrides;
};

double number(const std::string& text) {
  try {
    std::size_t end = 0;
    const double value = std::stod(text, &end);
    if (end == text.size()) return value;
  } catch (const std::exception&) {
  }
  throw InputError("found '" + text + "', expected a number");
}

Arguments read_arguments(const std::vector<std::string>& words) {
  Arguments a;
  std::vector<std::string> places;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] != "--set") {
      places.push_back(words[i]);
      continue;
    }
    if (++i == words.size()) throw InputError("--set: found nothing, expected KEY=VALUE");
    a.overrides.push_back(words[i]);
  }
  if (places.size() < 3) throw InputError("found too few arguments\n" + std::string(usage));
  a.path = places[0];
  a.method = places[1];
  for (std::size_t i = 2; i < places.size(); ++i) a.accuracies.push_back(number(places[i]));
  return a;
}

ComparisonMethod rival(const std::string& name) {
  const std::map<std::string, ComparisonMethod> rivals{{"rk8pd", ComparisonMethod::rk8pd},
                                                       {"rkf45", ComparisonMethod::rkf45},
                                                       {"rk4", ComparisonMethod::rk4}};
  if (const auto found = rivals.find(name); found != rivals.end()) return found->second;
  throw InputError("found method '" + name + "', expected rk8pd, rkf45 or rk4");
}

Json rows(const tdbd::Mat3& A) {
  Json all;
  for (int i = 0; i < 3; ++i) all.push_back({A(i, 0), A(i, 1), A(i, 2)});
  return all;
}

Json line(const std::string& method, const WorkPrecision& p) {
  const tdbd::Vec3& momentum = p.end.body_momentum_B;
  return {{"method", method},
          {"accuracy", p.accuracy},
          {"torque_evaluations", p.evaluations},
          {"attitude_error_rad", p.attitude_error},
          {"attitude", rows(p.end.R_WB)},
          {"body_momentum", {momentum.x(), momentum.y(), momentum.z()}},
          {"cone_angles", p.end.cone_angles},
          {"cone_momenta", p.end.cone_momenta}};
}

void run(const Arguments& a) {
  const auto c = tdbd::simulation::read_rotate_case(a.path, a.overrides);
  for (const WorkPrecision& p :
       tdbd::reference::work_precision(c.body, c.loads, tdbd::reference::matrix_state(c.start),
                                       c.time.duration, rival(a.method), a.accuracies))
    std::cout << line(a.method, p).dump() << "\n";
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() == 1 && (words[0] == "--help" || words[0] == "-h")) {
    std::fputs(usage, stdout);
    return 0;
  }
  try {
    run(read_arguments(words));
    std::cout.flush();
    return std::cout ? 0 : 1;
  } catch (const InputError& e) {
    std::fprintf(stderr, "rotate-runge-kutta: %s\n", e.what());
    return 2;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "rotate-runge-kutta: %s\n", e.what());
    return 1;
  }
}
