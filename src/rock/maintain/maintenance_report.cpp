#include <cmath>
#include <numeric>

#include "rock/maintain/maintain.hpp"

namespace tdbd::rock {
namespace {

template <class Enumerator>
constexpr std::size_t at(Enumerator e) {
  return static_cast<std::size_t>(e);
}

}  // namespace

void note_done(MaintenanceReport& report, Operation what, double volume) {
  ++report.done[at(what)];
  report.volume_change += volume;
  report.volume_disturbed += std::abs(volume);
}

void note_refused(MaintenanceReport& report, Operation what, Refusal why) {
  ++report.refused[at(what)][at(why)];
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
