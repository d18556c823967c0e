#include "reference/literature/surface/surface_error.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "reference/literature/surface/z_map_sweep.hpp"

namespace tdbd::reference {
namespace {

/// The ring of a radius: index of the last of `radii` at or below it; -1 outside all rings.
int ring_of(const std::vector<double>& radii, double r) {
  if (r < radii.front() || r >= radii.back()) return -1;
  return static_cast<int>(std::upper_bound(radii.begin(), radii.end(), r) - radii.begin()) - 1;
}

double percentile(std::vector<double>& sorted_in_part, double share) {
  const auto place =
      sorted_in_part.begin() +
      static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted_in_part.size()));
  std::nth_element(sorted_in_part.begin(), place, sorted_in_part.end());
  return *place;
}

/// The error statistics of one ring, from its distances along the normal.
SurfaceError summed(std::vector<double>& along_normal) {
  SurfaceError e;
  e.samples = static_cast<long>(along_normal.size());
  if (along_normal.empty()) return e;
  const auto n = static_cast<double>(e.samples);
  for (double& d : along_normal) {
    e.mean_signed += d / n;
    e.rms += d * d / n;
    d = std::abs(d);
    e.mean += d / n;
  }
  e.rms = std::sqrt(e.rms);
  e.p95 = percentile(along_normal, 0.95);
  e.p99 = percentile(along_normal, 0.99);
  return e;
}

}  // namespace

ProfileCosine profile_cosine(const bit::Bit& bit) {
  std::vector<std::pair<double, double>> tips;
  for (const bit::Cutter& c : bit.cutters) tips.emplace_back(c.tip_radius, c.profile_angle);
  std::sort(tips.begin(), tips.end());
  ProfileCosine p;
  for (const auto& [r, angle] : tips) {
    p.radius.push_back(r);
    p.angle.push_back(angle);
  }
  return p;
}

double ProfileCosine::at(double r) const {
  const auto above = std::lower_bound(radius.begin(), radius.end(), r);
  if (above == radius.begin()) return std::cos(angle.front());
  if (above == radius.end()) return std::cos(angle.back());
  const auto i = static_cast<std::size_t>(above - radius.begin());
  const double share = (r - radius[i - 1]) / (radius[i] - radius[i - 1]);
  return std::cos(std::lerp(angle[i - 1], angle[i], share));
}

std::vector<SurfaceError> surface_errors(const ZMap& reference, const ZMap& surface,
                                         const ProfileCosine& cosine,
                                         const std::vector<double>& radii) {
  if (reference.cells != surface.cells || reference.half != surface.half)
    throw std::invalid_argument("surface_errors: the two height fields have other cells");
  const double area = reference.cell() * reference.cell();
  std::vector<std::vector<double>> along_normal(radii.size() - 1);
  std::vector<double> volume(radii.size() - 1, 0.0);
  for (int row = 0; row < reference.cells; ++row)
    for (int column = 0; column < reference.cells; ++column) {
      const double r = std::hypot(reference.centre(column), reference.centre(row));
      const int ring = ring_of(radii, r);
      if (ring < 0) continue;
      const auto cell = static_cast<std::size_t>(row) * reference.cells + column;
      const double deeper = surface.height[cell] - reference.height[cell];
      volume[ring] += deeper * area;
      along_normal[ring].push_back(deeper * cosine.at(r));
    }
  std::vector<SurfaceError> errors;
  for (std::size_t i = 0; i + 1 < radii.size(); ++i) {
    errors.push_back(summed(along_normal[i]));
    errors.back().volume = volume[i];
    errors.back().r_lo = radii[i];
    errors.back().r_hi = radii[i + 1];
  }
  return errors;
}

ZMap resampled(const ZMap& coarse, const ZMap& cells_of) {
  ZMap fine = flat_z_map(cells_of.half, 0.0, cells_of.cells);
  for (int row = 0; row < fine.cells; ++row)
    for (int column = 0; column < fine.cells; ++column)
      fine.height[static_cast<std::size_t>(row) * fine.cells + column] =
          height_at(coarse, fine.centre(column), fine.centre(row));
  return fine;
}

}  // namespace tdbd::reference
