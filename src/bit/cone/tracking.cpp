#include "bit/cone/tracking.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tdbd::bit {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

/// A ring whose prints may lie close enough to those of the ring that is judged.
struct Neighbour {
  const std::vector<Print>* prints;
  double near;  ///< rad: nearer in azimuth than this is close enough
};

double wrapped(double angle) { return std::remainder(angle, two_pi); }

/// Half the angle of the places on a ring that are nearer than `distance` to a place of another
/// ring; 0: none.
double near_angle(const PrintRing& ring, const PrintRing& other, double distance) {
  const double a = ring.radius, b = other.radius;
  if (std::abs(a - b) >= distance) return 0.0;
  if (a + b <= distance) return std::numbers::pi;
  return 2.0 * std::asin(0.5 * std::sqrt((distance * distance - (a - b) * (a - b)) / (a * b)));
}

/// Azimuths of the prints that a ring made before `turned` by more than `least` and at most `most`.
template <class Visit>
void visit_earlier(const Neighbour& n, double turned, double least, double most, Visit visit) {
  const auto begin = std::ranges::lower_bound(*n.prints, turned - most, {}, &Print::turned);
  const auto end = std::ranges::lower_bound(*n.prints, turned - least, {}, &Print::turned);
  for (auto p = begin; p < end; ++p) visit(p->azimuth);
}

bool tracks(const Print& print, const std::vector<Neighbour>& near, int lag) {
  bool found = false;
  for (const Neighbour& n : near) {
    const double least = lag == 1 ? 0.0 : two_pi * (lag - 1) + n.near;
    visit_earlier(n, print.turned, least, two_pi * lag + n.near, [&](double azimuth) {
      found = found || std::abs(wrapped(print.azimuth - azimuth)) < n.near;
    });
  }
  return found;
}

/// Share of the circle within reach of the prints of the last revolution.
double covered_share(const Print& print, const std::vector<Neighbour>& near,
                     std::vector<std::pair<double, double>>& arcs) {
  arcs.clear();
  for (const Neighbour& n : near)
    visit_earlier(n, print.turned, 0.0, two_pi + n.near, [&](double azimuth) {
      const double begin = wrapped(azimuth - n.near) + std::numbers::pi, end = begin + 2.0 * n.near;
      arcs.emplace_back(begin, std::min(end, two_pi));
      if (end > two_pi) arcs.emplace_back(0.0, end - two_pi);
    });
  std::ranges::sort(arcs);
  double covered = 0.0, reached = 0.0;
  for (const auto& [begin, end] : arcs) {
    covered += std::max(0.0, end - std::max(begin, reached));
    reached = std::max(reached, end);
  }
  return covered / two_pi;
}

TrackingShare judge(const std::vector<Print>& own, const std::vector<Neighbour>& near, int lags) {
  TrackingShare t;
  t.share.assign(static_cast<std::size_t>(lags), 0.0);
  std::vector<std::pair<double, double>> arcs;
  for (const Print& print : own) {
    if (print.turned < 0.0) continue;
    ++t.prints;
    for (int lag = 1; lag <= lags; ++lag)
      t.share[static_cast<std::size_t>(lag - 1)] += tracks(print, near, lag) ? 1.0 : 0.0;
    t.random_phase += covered_share(print, near, arcs);
  }
  const double count = static_cast<double>(std::max(1L, t.prints));
  for (double& share : t.share) share /= count;
  t.random_phase /= count;
  return t;
}

}  // namespace

std::vector<TrackingShare> tracking(const std::vector<PrintRing>& rings,
                                    const std::vector<double>& speed_ratios,
                                    const TrackingOptions& options) {
  const double past = -two_pi * (options.lags + 1), end = two_pi * options.revolutions;
  std::vector<std::vector<Print>> all;
  all.reserve(rings.size());
  for (std::size_t i = 0; i < rings.size(); ++i)
    all.push_back(prints(rings[i], speed_ratios[i], past, end));
  std::vector<TrackingShare> shares;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    std::vector<Neighbour> near;
    for (std::size_t j = 0; j < rings.size(); ++j)
      if (const double angle =
              near_angle(rings[i], rings[j], options.share_of_width * rings[i].width);
          angle > 0.0)
        near.push_back({&all[j], angle});
    shares.push_back(judge(all[i], near, options.lags));
  }
  return shares;
}

TrackingShare combined(const std::vector<TrackingShare>& rings) {
  TrackingShare sum;
  for (const TrackingShare& r : rings) {
    const double n = static_cast<double>(r.prints);
    sum.prints += r.prints;
    sum.share.resize(std::max(sum.share.size(), r.share.size()), 0.0);
    for (std::size_t k = 0; k < r.share.size(); ++k) sum.share[k] += n * r.share[k];
    sum.random_phase += n * r.random_phase;
  }
  const double count = static_cast<double>(std::max(1L, sum.prints));
  for (double& share : sum.share) share /= count;
  sum.random_phase /= count;
  return sum;
}

std::vector<BitRow> bit_rows(const Bit& bit, double penetration) {
  std::vector<BitRow> rows;
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    for (std::size_t j = 0; j < bit.cones[k].layout.rows.size(); ++j) {
      const ToothRow& row = bit.cones[k].layout.rows[j];
      const double teeth = static_cast<double>(row.angles.size());
      if (tooth_contact_ratio(bit.cones[k], row, penetration) < teeth)
        rows.push_back(
            {static_cast<int>(k), static_cast<int>(j), print_ring(bit.cones[k], row, penetration)});
    }
  return rows;
}

std::vector<TrackingShare> tracking(const std::vector<BitRow>& rows,
                                    const std::vector<double>& cone_speeds,
                                    const TrackingOptions& options) {
  std::vector<PrintRing> rings;
  std::vector<double> ratios;
  for (const BitRow& row : rows) {
    rings.push_back(row.ring);
    ratios.push_back(cone_speeds[static_cast<std::size_t>(row.cone)]);
  }
  return tracking(rings, ratios, options);
}

}  // namespace tdbd::bit
