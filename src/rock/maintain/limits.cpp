#include "rock/maintain/limits.hpp"

#include <cmath>
#include <numeric>

namespace tdbd::rock {

void set_shortest_edge(MaintenanceLimits& l, double shortest) {
  constexpr double below = 1.0 - 1e-9;  // M6 requires "less than"; guards and check round
  l.shortest_edge = shortest;
  l.farthest = below * 0.5 * shortest;
  l.untangle_farthest = below * 2.0 * shortest;
}

MaintenanceLimits limits_for(double edge_length) {
  MaintenanceLimits l;
  set_shortest_edge(l, 0.4 * edge_length);
  l.longest_edge = 1.6 * edge_length;
  l.volume_per_operation = 0.01 * edge_length * edge_length * edge_length;
  l.ridge_cut = 0.05 * edge_length;
  l.untangle_volume = 20.0 * l.volume_per_operation;
  return l;
}

void count_done(MaintenanceReport& report, Operation what, double volume) {
  ++report.done[static_cast<std::size_t>(what)];
  report.volume_change += volume;
  report.volume_disturbed += std::abs(volume);
}

void count_refused(MaintenanceReport& report, Operation what, Refusal why) {
  ++report.refused[static_cast<std::size_t>(what)][static_cast<std::size_t>(why)];
}

long refusals(const MaintenanceReport& report) {
  long sum = 0;
  for (const auto& by_reason : report.refused)
    sum = std::accumulate(by_reason.begin(), by_reason.end(), sum);
  return sum;
}

void add(const MaintenanceReport& more, MaintenanceReport& sum) {
  for (std::size_t o = 0; o < sum.done.size(); ++o) {
    sum.done[o] += more.done[o];
    for (std::size_t r = 0; r < sum.refused[o].size(); ++r) sum.refused[o][r] += more.refused[o][r];
  }
  sum.touched_triangles += more.touched_triangles;
  sum.volume_change += more.volume_change;
  sum.volume_disturbed += more.volume_disturbed;
}

std::vector<std::pair<std::string, long>> counts(const MaintenanceReport& report) {
  std::vector<std::pair<std::string, long>> all;
  all.reserve(report.done.size() * (1 + refusal_names.size()));
  for (std::size_t o = 0; o < report.done.size(); ++o)
    all.emplace_back(operation_names[o], report.done[o]);
  for (std::size_t o = 0; o < report.done.size(); ++o)
    for (std::size_t r = 0; r < refusal_names.size(); ++r)
      all.emplace_back(std::string("refused_") + operation_names[o] + "_" + refusal_names[r],
                       report.refused[o][r]);
  return all;
}

}  // namespace tdbd::rock
