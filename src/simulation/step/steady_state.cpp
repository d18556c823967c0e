#include "simulation/step/steady_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>
#include <span>

#include "simulation/step/measure.hpp"

namespace tdbd::simulation {
namespace {

constexpr std::size_t batches_per_half = 8;

/// The means of the batches of a half.
RunningVariance batches_of(std::span<const double> half) {
  const std::size_t length = half.size() / batches_per_half;
  RunningVariance means;
  for (std::size_t k = 0; k < batches_per_half; ++k) {
    const std::span<const double> batch = half.subspan(k * length, length);
    add(means, std::accumulate(batch.begin(), batch.end(), 0.0) / static_cast<double>(length));
  }
  return means;
}

/// Initial samples that do not fill a batch are omitted, as in batch_uncertainty. A prescribed rate
/// has no scatter but that of rounding, which therefore bounds the standard error from below.
MeanChange change_of(const char* name, const std::vector<double>& samples) {
  constexpr double rounding = 1e-9;
  const std::size_t half = samples.size() / (2 * batches_per_half) * batches_per_half;
  const std::span<const double> used = std::span(samples).last(2 * half);
  const RunningVariance first = batches_of(used.first(half)), second = batches_of(used.last(half));
  const double size = std::max(std::abs(first.mean), std::abs(second.mean));
  MeanChange c{.name = name};
  if (size == 0.0) return c;
  const double n = batches_per_half, change = second.mean - first.mean;
  const double scatter = std::sqrt((first.squares + second.squares) / (n * (n - 1.0)));
  c.relative = change / size;
  c.t = change / std::max(scatter, rounding * size);
  c.is_drifting = std::abs(c.t) > drift_t && std::abs(c.relative) > smallest_drift;
  return c;
}

struct MeanName {
  const char *key, *words;
};
constexpr std::array mean_names{MeanName{"wob_mean_n", "the weight on bit"},
                                MeanName{"tob_mean_n_m", "the torque"},
                                MeanName{"rop_mean_m_per_s", "the rate of penetration"},
                                MeanName{"rotary_speed_mean_rad_per_s", "the rotary speed"}};

}  // namespace

SteadyState steady_state(const Trace& t) {
  SteadyState s;
  const double turned = std::accumulate(t.rotary_speed.begin(), t.rotary_speed.end(), 0.0) * t.dt;
  s.revolutions = std::abs(turned) / (2.0 * std::numbers::pi);
  // A count of steps rounds the duration, so that a whole revolution may be a little less than one.
  constexpr double least_revolutions = 0.99;
  if (t.wob.size() < 2 * batches_per_half) {
    s.reason =
        fmt::format("{} steps in the means, fewer than {}", t.wob.size(), 2 * batches_per_half);
    return s;
  }
  if (s.revolutions < least_revolutions) {
    s.reason = fmt::format("the means cover {:.3g} revolutions, less than one", s.revolutions);
    return s;
  }
  const std::array<const std::vector<double>*, 4> samples{&t.wob, &t.tob, &t.rop, &t.rotary_speed};
  for (std::size_t i = 0; i < samples.size(); ++i)
    s.changes.push_back(change_of(mean_names[i].key, *samples[i]));
  s.is_steady = std::ranges::none_of(s.changes, &MeanChange::is_drifting);
  return s;
}

nlohmann::ordered_json to_json(const SteadyState& s) {
  using Json = nlohmann::ordered_json;
  Json means = Json::object();
  for (const MeanChange& c : s.changes)
    means[c.name] = {{"relative_change", c.relative}, {"t", c.t}, {"drifts", c.is_drifting}};
  Json j{{"revolutions", s.revolutions},
         {"t_limit", drift_t},
         {"relative_change_limit", smallest_drift},
         {"means", means}};
  if (!s.reason.empty()) j["reason"] = s.reason;
  return j;
}

std::string drifting_means(const SteadyState& s) {
  constexpr double percent = 100.0;
  std::string text;
  for (std::size_t i = 0; i < s.changes.size(); ++i)
    if (s.changes[i].is_drifting)
      text += fmt::format("{}{} by {:+.2g} %", text.empty() ? "" : ", ", mean_names[i].words,
                          percent * s.changes[i].relative);
  return text;
}

}  // namespace tdbd::simulation
