#include "simulation/step/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <unsupported/Eigen/FFT>

#include "simulation/step/measure.hpp"

namespace tdbd::simulation {
namespace {

double mean(std::span<const double> x) {
  return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

double share_below(std::span<const double> x, double limit) {
  return static_cast<double>(std::ranges::count_if(x, [&](double v) { return v < limit; })) /
         static_cast<double>(x.size());
}

/// The last whole cycles of a frequency (Hz), as many as fit; all samples if there is not one.
std::span<const double> whole_cycles(std::span<const double> x, double frequency, double dt) {
  const double cycles = std::floor(static_cast<double>(x.size()) * dt * frequency);
  if (!(cycles > 0.0)) return x;
  const auto count = static_cast<std::size_t>(std::lround(cycles / (frequency * dt)));
  return x.last(std::min(count, x.size()));
}

double swing(std::span<const double> x, double of_mean) {
  const auto [least, greatest] = std::ranges::minmax(x);
  return of_mean != 0.0 ? (greatest - least) / (2.0 * std::abs(of_mean)) : 0.0;
}

std::vector<double> windowed(const std::vector<double>& x) {
  const double m = mean(x), n = static_cast<double>(x.size());
  std::vector<double> y(x.size());
  for (std::size_t i = 0; i < x.size(); ++i)
    y[i] =
        (x[i] - m) * (1.0 - std::cos(2.0 * std::numbers::pi * (static_cast<double>(i) + 0.5) / n));
  return y;
}

/// Position of the maximum of the parabola through three neighbouring lines, in lines from the
/// middle one.
double top_between(double before, double at, double after) {
  const double curvature = before - 2.0 * at + after;
  return curvature < 0.0 ? 0.5 * (before - after) / curvature : 0.0;
}

/// Rotation of the centre about its mean position, rad, signed and absolute, and its mean square
/// distance, m2.
struct Orbit {
  double turned = 0.0, square = 0.0, moved = 0.0;
};

Orbit orbit_of(const std::vector<Eigen::Vector2d>& centre) {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& x : centre) middle += x / static_cast<double>(centre.size());
  Orbit o;
  for (std::size_t i = 0; i < centre.size(); ++i) {
    const Eigen::Vector2d b = centre[i] - middle;
    o.square += b.squaredNorm() / static_cast<double>(centre.size());
    if (i == 0) continue;
    const Eigen::Vector2d a = centre[i - 1] - middle;
    const double turn = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    o.turned += turn;
    o.moved += std::abs(turn);
  }
  return o;
}

WhirlKind whirl_of(const Orbit& o, double orbit_speed, double rotary_speed) {
  constexpr double smallest_orbit = 1e-4;  // m
  constexpr double steadiness = 0.5;       // net share of the rotation in one direction
  constexpr double same_speed = 0.1;
  if (std::sqrt(o.square) < smallest_orbit || std::abs(o.turned) < steadiness * o.moved)
    return WhirlKind::none;
  if (std::abs(orbit_speed - rotary_speed) < same_speed * std::abs(rotary_speed))
    return WhirlKind::synchronous;
  return orbit_speed * rotary_speed > 0.0 ? WhirlKind::forward : WhirlKind::backward;
}

/// Whether the rock can stop and release the bit: see diagnose().
bool can_stick(const Trace& t, double torque, double mean_speed, double lost_contact_share) {
  constexpr double most_lost_contact = 0.5, steadiness = 0.5;
  double turned = 0.0;
  for (const double w : t.rotary_speed)
    turned += std::abs(w) / static_cast<double>(t.rotary_speed.size());
  return lost_contact_share <= most_lost_contact && torque * mean_speed > 0.0 &&
         std::abs(mean_speed) >= steadiness * turned;
}

/// Whether the rotary speed varies by more than half of its mean, and by more than rounding.
bool swings(const std::vector<double>& speed, double mean_speed) {
  constexpr double half = 0.5, least = 1e-3;  // rad/s
  const auto [lowest, highest] = std::ranges::minmax(speed);
  return 0.5 * (highest - lowest) > std::max(half * std::abs(mean_speed), least);
}

/// " at 3.2 Hz" after `before`; empty if the frequency is unknown.
std::string at_frequency(const char* before, double frequency) {
  return frequency > 0.0 ? fmt::format("{} at {:.3g} Hz", before, frequency) : "";
}

/// The revolutions of a run that is too short to show vibrations, less than one. Nothing for a
/// bit that hardly turns, that turns to and fro, that sticks or is off bottom: a longer run is
/// alike.
std::optional<double> too_few_revolutions(const Trace& t, const Diagnosis& d) {
  constexpr double often_stuck = 0.05, steadiness = 0.5, least = 1e-3;  // rad/s
  double net = 0.0, all = 0.0;
  for (const double w : t.rotary_speed) {
    net += w * t.dt;
    all += std::abs(w) * t.dt;
  }
  const double time = t.dt * static_cast<double>(t.rotary_speed.size());
  const double revolutions = all / (2.0 * std::numbers::pi);
  if (revolutions >= 1.0 || std::abs(net) < steadiness * all || all < least * time ||
      d.stuck_share >= often_stuck || d.lost_contact_share == 1.0)
    return std::nullopt;
  return revolutions;
}

std::string text_of(const Diagnosis& d, const std::optional<double>& too_few) {
  if (too_few)
    return fmt::format("too short to judge: {:.2g} revolutions, at least one is required",
                       *too_few);
  constexpr double bouncing = 0.01, swinging = 0.5;
  std::string text;
  const auto add = [&text](const std::string& s) { text += (text.empty() ? "" : "; ") + s; };
  if (d.stick_slip_severity > severe_stick_slip)
    add(fmt::format("stick-slip, severity {:.2f}{}, stuck {:.0f} % of the time",
                    d.stick_slip_severity, at_frequency(",", d.torsional_frequency),
                    100.0 * d.stuck_share));
  if (d.lost_contact_share == 1.0)
    add("off bottom, no contact with rock");
  else if (d.lost_contact_share > bouncing)
    add(fmt::format("bit bounce, without contact {:.0f} % of the time{}",
                    100.0 * d.lost_contact_share, at_frequency(",", d.axial_frequency)));
  else if (d.wob_swing > swinging)
    add(fmt::format("axial vibration, weight swings by {:.0f} %{}", 100.0 * d.wob_swing,
                    at_frequency("", d.axial_frequency)));
  if (d.twists) add("torsional vibration" + at_frequency("", d.torsional_frequency));
  if (d.whirl != WhirlKind::none)
    add(fmt::format("{} whirl, {:.3g} mm at {:.3g} Hz", whirl_name(d.whirl), 1e3 * d.orbit_radius,
                    d.orbit_frequency));
  return text.empty() ? "steady" : text;
}

}  // namespace

void reserve(Trace& t, long steps) {
  constexpr long most = 10'000'000;
  const auto count = static_cast<std::size_t>(std::min(steps, most));
  t.wob.reserve(count);
  t.tob.reserve(count);
  t.rop.reserve(count);
  t.rotary_speed.reserve(count);
  t.centre_W.reserve(count);
  t.force_B.reserve(count);
}

double strongest_frequency(const std::vector<double>& samples, double dt) {
  constexpr std::size_t fewest = 8;
  if (samples.size() < fewest) return 0.0;
  Eigen::FFT<double> fft;
  std::vector<std::complex<double>> lines;
  fft.fwd(lines, windowed(samples));
  std::size_t peak = 1;
  for (std::size_t k = 1; k < samples.size() / 2; ++k)
    if (std::abs(lines[k]) > std::abs(lines[peak])) peak = k;
  const double top = std::abs(lines[peak]);
  if (!(top > 0.0)) return 0.0;
  const auto height = [&](std::size_t k) { return std::log(std::abs(lines[k]) + 1e-300); };
  const double between = top_between(height(peak - 1), height(peak), height(peak + 1));
  return (static_cast<double>(peak) + between) / (static_cast<double>(samples.size()) * dt);
}

std::string whirl_name(WhirlKind w) {
  switch (w) {
    case WhirlKind::forward:
      return "forward";
    case WhirlKind::backward:
      return "backward";
    case WhirlKind::synchronous:
      return "synchronous";
    case WhirlKind::none:
      break;
  }
  return "none";
}

Diagnosis diagnose(const Trace& t, double torque) {
  constexpr double stuck = 0.05;
  Diagnosis d;
  if (t.wob.size() < 2) return d;
  const double speed = mean(t.rotary_speed);
  d.torsional_frequency = strongest_frequency(t.rotary_speed, t.dt);
  d.lost_contact_share =
      static_cast<double>(std::ranges::count(t.wob, 0.0)) / static_cast<double>(t.wob.size());
  if (can_stick(t, torque, speed, d.lost_contact_share)) {
    const std::span<const double> cycles =
        whole_cycles(t.rotary_speed, d.torsional_frequency, t.dt);
    d.stick_slip_severity = swing(t.rotary_speed, mean(cycles));
    d.stuck_share = share_below(cycles, stuck * mean(cycles));
  } else {
    d.twists = swings(t.rotary_speed, speed);
  }
  d.wob_swing = swing(t.wob, mean(t.wob));
  d.axial_frequency = strongest_frequency(t.wob, t.dt);
  const Orbit o = orbit_of(t.centre_W);
  const double time = t.dt * static_cast<double>(t.centre_W.size() - 1);
  d.orbit_radius = std::sqrt(o.square);
  d.orbit_frequency = o.turned / (2.0 * std::numbers::pi * time);
  d.whirl = whirl_of(o, o.turned / time, speed);
  d.text = text_of(d, too_few_revolutions(t, d));
  return d;
}

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
