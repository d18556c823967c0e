#include "bit/wear/wear.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bit/cone/cone_measures.hpp"
#include "bit/cutter/cutter.hpp"
#include "core/error.hpp"
#include "mesh/measures.hpp"
#include "mesh/shape/convex.hpp"

namespace tdbd::bit {
namespace {

double coefficient_at(const NoWear&, double) { return 0.0; }

double coefficient_at(const SlidingWear& law, double) { return law.coefficient / law.hardness; }

double coefficient_at(const ThermalWear& law, double temperature) {
  const double excess = std::max(0.0, temperature - law.threshold);
  return coefficient_at(law.sliding, temperature) * std::exp(excess / law.growth);
}

double coefficient_at(const TableWear& law, double temperature) {
  const auto above = std::ranges::upper_bound(law.temperatures, temperature);
  if (above == law.temperatures.begin()) return law.rates.front();
  if (above == law.temperatures.end()) return law.rates.back();
  const auto i = static_cast<std::size_t>(above - law.temperatures.begin());
  const double w = (temperature - law.temperatures[i - 1]) / (*above - law.temperatures[i - 1]);
  return std::lerp(law.rates[i - 1], law.rates[i], w);
}

}  // namespace

double wear_coefficient(const WearLaw& law, double temperature) {
  return std::visit([temperature](const auto& l) { return coefficient_at(l, temperature); }, law);
}

double wear_rate(const WearLaw& law, const WearContact& c) {
  return wear_coefficient(law, c.temperature) * c.normal_force * c.speed;
}

double flat_temperature(const FlatHeating& heating, const FlatContact& c) {
  if (!(c.normal_force > 0.0) || !(c.area > 0.0) || !(c.speed > 0.0))
    return heating.fluid_temperature;
  const double flux = heating.friction * c.normal_force * c.speed / c.area;
  const double passing = c.length / c.speed;  // s, for which a point of the rock is heated
  const double rock = 4.0 / 3.0 * std::sqrt(heating.rock_diffusivity * passing / std::numbers::pi) /
                      heating.rock_conductivity;
  const double cutter = heating.cutter_resistance;
  if (!(rock + cutter > 0.0)) return heating.fluid_temperature;
  return heating.fluid_temperature + flux * rock * cutter / (rock + cutter);
}

namespace {

std::size_t place_of(int index) { return static_cast<std::size_t>(index); }

/// A face enclosed by a chamfer has no volume of its own.
bool adds_volume(const Bit& bit, const Part& part) {
  return part.cutter < 0 || part.kind != PartKind::face ||
         bit.cutters[place_of(part.cutter)].chamfer == 0.0;
}

WearSolid solid_of(const Cutter& c, int index) {
  WearSolid s;
  s.name = fmt::format("cutter-{}", c.id);
  s.cutter = index;
  s.normal_C = c.X_BC.R.transpose() * profile_normal_B(c);
  s.motion_C = c.X_BC.R.transpose() * direction_of_motion_B(c);
  s.tip_C = tip_C(c);
  s.start = std::numeric_limits<double>::infinity();
  s.size = c.diameter;
  s.largest = 0.5 * c.diameter * std::cos(c.back_rake);
  return s;
}

/// A tooth is blunted along its axis Z, from its tip; a gage pad loses height along its X axis,
/// from the gage.
WearSolid solid_of(const Part& part) {
  constexpr double most_of_tooth = 0.95, most_of_pad = 0.5;
  const bool is_tooth = part.kind == PartKind::tooth;
  WearSolid s;
  s.name = part.name;
  s.normal_C = is_tooth ? Vec3::UnitZ() : Vec3::UnitX();
  s.motion_C = is_tooth ? Vec3::UnitX() : Vec3::UnitY();
  const auto along = [&](const Vec3& x) { return s.normal_C.dot(x); };
  const auto [low, high] = std::ranges::minmax(part.mesh_P.positions, {}, along);
  s.tip_C = high;
  s.start = 0.0;
  s.size = is_tooth ? along(high) : along(high) - along(low);
  s.largest = (is_tooth ? most_of_tooth : most_of_pad) * s.size;
  return s;
}

void add_part(const Part& part, WearSolid& s) {
  for (const mesh::Triangle& t : part.mesh_P.triangles) {
    std::array<Vec3, 3>& x = s.triangles_C.emplace_back();
    std::array<double, 3>& depth = s.depth.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      x[k] = part.mesh_P.positions[place_of(t[k])] - s.tip_C;
      depth[k] = -s.normal_C.dot(x[k]);
      s.start = std::min(s.start, depth[k]);
    }
  }
}

/// Radius of a tooth's tip from the bit's axis at the deepest position during a turn of its cone,
/// m.
double deepest_radius(const Bit& bit, const Part& part, const WearSolid& s) {
  if (part.cone < 0) return (part.X_BP * s.tip_C).head<2>().norm();
  const Cone& cone = bit.cones[place_of(part.cone)];
  const Vec3 x_K = cone.X_BK.R.transpose() * (part.X_BP * s.tip_C - cone.X_BK.p);
  return deepest_B(cone, x_K.head<2>().norm(), x_K.z()).head<2>().norm();
}

bool is_tooth_or_pad(const Part& part) {
  return part.kind == PartKind::tooth || part.kind == PartKind::gage_pad;
}

/// The part of a triangle beyond the plane: a polygon of up to four corners.
struct Beyond {
  std::array<Vec3, 4> x;
  int count = 0;
  void add(const Vec3& p) { x[place_of(count++)] = p; }
};

/// Extents of the section along two directions.
struct Extent {
  double lo = std::numeric_limits<double>::infinity();
  double hi = -std::numeric_limits<double>::infinity();
  void add(double value) {
    lo = std::min(lo, value);
    hi = std::max(hi, value);
  }
  double size() const { return hi > lo ? hi - lo : 0.0; }
};

struct Section {
  const WearSolid& solid;
  Vec3 across_C;  ///< in the plane, across the motion
  Extent along, across;

  void add(const Vec3& x) {
    along.add(solid.motion_C.dot(x));
    across.add(across_C.dot(x));
  }
};

Beyond beyond_plane(const WearSolid& s, std::size_t i, double height, Section& section) {
  Beyond polygon;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const double a = s.depth[i][k] - height, b = s.depth[i][next] - height;
    if (a <= 0.0) polygon.add(s.triangles_C[i][k]);
    if (a == 0.0) section.add(s.triangles_C[i][k]);
    if (a * b >= 0.0) continue;
    // From the corner with the smaller index, so that both triangles of an edge give the same
    // point.
    const Vec3 &p = s.triangles_C[i][k], &q = s.triangles_C[i][next];
    const Vec3 x = a < 0.0 ? Vec3(p + a / (a - b) * (q - p)) : Vec3(q + b / (b - a) * (p - q));
    polygon.add(x);
    section.add(x);
  }
  return polygon;
}

/// The section at this height, and the volume beyond it.
WearFlat section_at(const WearSolid& s, double height) {
  WearFlat flat{.height = height};
  const Vec3 apex = -height * s.normal_C;  // in the plane: the section itself adds no volume
  Section section{s, s.normal_C.cross(s.motion_C), {}, {}};
  for (std::size_t i = 0; i < s.depth.size(); ++i) {
    if (std::ranges::min(s.depth[i]) >= height) continue;
    const Beyond polygon = beyond_plane(s, i, height, section);
    for (int k = 2; k < polygon.count; ++k) {
      const Vec3 a = polygon.x[0] - apex, b = polygon.x[place_of(k - 1)] - apex,
                 c = polygon.x[place_of(k)] - apex;
      flat.volume += a.dot(b.cross(c)) / 6.0;
      flat.area += 0.5 * s.normal_C.dot((b - a).cross(c - a));
    }
  }
  flat.length = section.along.size();
  flat.width = section.across.size();
  return flat;
}

}  // namespace

std::vector<WearSolid> wear_solids(const Bit& bit, std::span<const std::uint8_t> wears) {
  std::vector<WearSolid> solids;
  for (std::size_t i = 0; i < bit.cutters.size(); ++i)
    solids.push_back(solid_of(bit.cutters[i], static_cast<int>(i)));
  for (std::size_t p = 0; p < bit.parts.size(); ++p) {
    const Part& part = bit.parts[p];
    const bool wears_alone = part.cutter < 0 && is_tooth_or_pad(part) && !wears.empty() && wears[p];
    if (part.cutter < 0 && !wears_alone) continue;
    if (wears_alone) solids.push_back(solid_of(part));
    WearSolid& s = part.cutter < 0 ? solids.back() : solids[place_of(part.cutter)];
    s.parts.push_back(static_cast<int>(p));
    if (adds_volume(bit, part)) add_part(part, s);
  }
  return solids;
}

WearFlat flat_at(const WearSolid& s, double height) {
  constexpr double beside = 1e-9;  // times the size, above the height of the flat in the table
  const double least = s.start + beside * s.size;
  if (height >= least) return section_at(s, height);
  WearFlat flat = section_at(s, least);
  flat.volume = section_at(s, height).volume;
  flat.height = height;
  return flat;
}

std::optional<WearFlat> flat_of_volume(const WearSolid& s, double volume, double from) {
  constexpr double agreement = 1e-14;  // relative to the volume
  constexpr int most_evaluations = 200;
  double low = std::max(from, s.start), high = s.largest;
  WearFlat best = flat_at(s, low);
  if (!(volume > best.volume)) return best;
  WearFlat flat = flat_at(s, high);
  if (volume >= flat.volume) return std::nullopt;
  const auto error = [volume](const WearFlat& f) { return std::abs(f.volume - volume); };
  for (int i = 0; i < most_evaluations; ++i) {
    if (error(flat) < error(best)) best = flat;
    if (error(best) <= agreement * volume) break;
    double next = flat.height - (flat.volume - volume) / flat.area;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (!(next > low && next < high)) break;  // adjacent doubles
    flat = flat_at(s, next);
    (flat.volume < volume ? low : high) = next;
  }
  return best;
}

void wear_piece(const Bit& fresh, const WearSolid& s, double height, Bit& bit) {
  const double limit = s.normal_C.dot(s.tip_C) - height;
  std::vector<mesh::TriangleMesh> meshes;
  for (const int p : s.parts) {
    const Part& part = fresh.parts[place_of(p)];
    meshes.push_back(mesh::clipped_convex(part.mesh_P, s.normal_C, limit));
    if (meshes.back().triangles.empty())
      throw RunError(fmt::format("wear removes {} entirely at a flat of {:.3f} mm below the tip",
                                 part.name, 1e3 * height));
  }
  for (std::size_t k = 0; k < meshes.size(); ++k)
    bit.parts[place_of(s.parts[k])].mesh_P = std::move(meshes[k]);
  if (s.cutter >= 0) bit.cutters[place_of(s.cutter)].wear = std::max(0.0, height);
}

LostVolume lost_volume(const Bit& fresh, const Bit& worn, const WearSolid& s, double height) {
  const double limit = s.normal_C.dot(s.tip_C) - height;
  LostVolume lost;
  for (const int p : s.parts) {
    const Part& part = fresh.parts[place_of(p)];
    if (!adds_volume(fresh, part)) continue;
    const mesh::TriangleMesh beyond_C = mesh::clipped_convex(part.mesh_P, -s.normal_C, -limit);
    if (!beyond_C.triangles.empty()) lost.beyond_flat += mesh::enclosed_volume(beyond_C);
    const double volume = mesh::enclosed_volume(part.mesh_P);
    lost.whole += volume;
    lost.by_meshes += volume - mesh::enclosed_volume(worn.parts[place_of(p)].mesh_P);
  }
  return lost;
}

DullGrade dull_grade(const Bit& bit, std::span<const WearSolid> solids,
                     std::span<const double> heights) {
  constexpr double inner_share = 2.0 / 3.0, eighths = 8.0;
  double sum[2] = {0.0, 0.0};
  int count[2] = {0, 0};
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const WearSolid& s = solids[i];
    const Part& part = bit.parts[place_of(s.parts.front())];
    if (part.kind == PartKind::gage_pad) continue;
    const Cutter* cutter = s.cutter >= 0 ? &bit.cutters[place_of(s.cutter)] : nullptr;
    const double radius = cutter != nullptr ? cutter->tip_radius : deepest_radius(bit, part, s);
    const double whole = cutter != nullptr ? s.size * std::cos(cutter->back_rake) : s.size;
    const int group = radius <= inner_share * bit.gage_radius ? 0 : 1;
    sum[group] += std::clamp(heights[i] / whole, 0.0, 1.0);
    ++count[group];
  }
  const auto grade = [&](int group) {
    return count[group] == 0 ? 0
                             : static_cast<int>(std::lround(eighths * sum[group] / count[group]));
  };
  return {grade(0), grade(1)};
}

}  // namespace tdbd::bit
