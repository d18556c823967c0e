#include "simulation/step/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <unsupported/Eigen/FFT>

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

}  // namespace tdbd::simulation
