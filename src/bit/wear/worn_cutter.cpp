#include "bit/wear/worn_cutter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bit/cutter/cutter_frame.hpp"
#include "core/error.hpp"
#include "mesh/measures.hpp"
#include "mesh/shape/clip_convex.hpp"

namespace tdbd::bit {
namespace {

std::size_t place_of(int index) { return static_cast<std::size_t>(index); }

/// A face that a chamfer encloses has no volume of its own.
bool adds_volume(const Cutter& c, const Part& part) {
  return part.kind != PartKind::face || c.chamfer == 0.0;
}

WearSolid solid_of(const Cutter& c) {
  WearSolid s;
  s.id = c.id;
  const Vec3 motion_B = direction_of_motion_B(c);
  s.normal_C = c.X_BC.R.transpose() * profile_normal_B(c);
  s.motion_C = c.X_BC.R.transpose() * motion_B;
  s.start = std::numeric_limits<double>::infinity();
  s.diameter = c.diameter;
  s.largest = 0.5 * c.diameter * std::cos(c.back_rake);
  return s;
}

void add_part(const Part& part, const Vec3& tip, WearSolid& s) {
  for (const mesh::Triangle& t : part.mesh_P.triangles) {
    std::array<Vec3, 3>& x = s.triangles_C.emplace_back();
    std::array<double, 3>& depth = s.depth.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      x[k] = part.mesh_P.positions[place_of(t[k])] - tip;
      depth[k] = -s.normal_C.dot(x[k]);
      s.start = std::min(s.start, depth[k]);
    }
  }
}

/// What of a triangle lies beyond the plane: a polygon of up to four corners.
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
    // From the corner with the smaller number on, so that both triangles of an edge agree.
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

std::vector<WearSolid> wear_solids(const Bit& bit) {
  std::vector<WearSolid> solids;
  for (const Cutter& c : bit.cutters) solids.push_back(solid_of(c));
  for (const Part& part : bit.parts) {
    if (part.cutter < 0) continue;
    const Cutter& c = bit.cutters[place_of(part.cutter)];
    if (adds_volume(c, part)) add_part(part, tip_C(c), solids[place_of(part.cutter)]);
  }
  return solids;
}

WearFlat flat_at(const WearSolid& s, double height) {
  constexpr double beside = 1e-9;  // of the diameter, beside the flat of the table
  const double least = s.start + beside * s.diameter;
  if (height >= least) return section_at(s, height);
  WearFlat flat = section_at(s, least);
  flat.volume = section_at(s, height).volume;
  flat.height = height;
  return flat;
}

std::optional<WearFlat> flat_of_volume(const WearSolid& s, double volume, double from) {
  constexpr double agreement = 1e-14;  // of the volume
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
    if (!(next > low && next < high)) break;  // neighbouring numbers
    flat = flat_at(s, next);
    (flat.volume < volume ? low : high) = next;
  }
  return best;
}

void wear_cutter(const Bit& fresh, int cutter, double height, Bit& bit) {
  const Cutter& c = fresh.cutters[place_of(cutter)];
  const Vec3 n_C = c.X_BC.R.transpose() * profile_normal_B(c);
  const double limit = n_C.dot(tip_C(c)) - height;
  std::vector<mesh::TriangleMesh> meshes(fresh.parts.size());
  for (std::size_t p = 0; p < fresh.parts.size(); ++p) {
    if (fresh.parts[p].cutter != cutter) continue;
    meshes[p] = mesh::clipped_convex(fresh.parts[p].mesh_P, n_C, limit);
    if (meshes[p].triangles.empty())
      throw RunError(fmt::format("wear removes {} entirely at a flat of {:.3f} mm below the tip",
                                 fresh.parts[p].name, 1e3 * height));
  }
  for (std::size_t p = 0; p < fresh.parts.size(); ++p)
    if (fresh.parts[p].cutter == cutter) bit.parts[p].mesh_P = std::move(meshes[p]);
  bit.cutters[place_of(cutter)].wear = std::max(0.0, height);
}

LostVolume lost_volume(const Bit& fresh, const Bit& worn, int cutter) {
  const Cutter& c = worn.cutters[place_of(cutter)];
  const Vec3 n_C = c.X_BC.R.transpose() * profile_normal_B(c);
  const double limit = n_C.dot(tip_C(c)) - c.wear;
  LostVolume lost;
  for (std::size_t p = 0; p < fresh.parts.size(); ++p) {
    if (fresh.parts[p].cutter != cutter || !adds_volume(c, fresh.parts[p])) continue;
    const mesh::TriangleMesh& whole_P = fresh.parts[p].mesh_P;
    const mesh::TriangleMesh piece_P = mesh::clipped_convex(whole_P, -n_C, -limit);
    if (!piece_P.triangles.empty()) lost.beyond_flat += mesh::enclosed_volume(piece_P);
    const double volume = mesh::enclosed_volume(whole_P);
    lost.whole += volume;
    lost.by_meshes += volume - mesh::enclosed_volume(worn.parts[p].mesh_P);
  }
  return lost;
}

WornBit worn_bit(const Bit& fresh, const std::vector<double>& volumes) {
  WornBit worn{fresh, {}};
  const std::vector<WearSolid> solids = wear_solids(fresh);
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const auto flat = flat_of_volume(solids[i], volumes[i], solids[i].start);
    if (!flat)
      throw RunError(fmt::format("the flat of cutter-{} is as large as the cutter", solids[i].id));
    worn.flats.push_back(*flat);
    if (flat->height > solids[i].start)
      wear_cutter(fresh, static_cast<int>(i), flat->height, worn.bit);
  }
  return worn;
}

DullGrade dull_grade(const Bit& bit) {
  constexpr double inner_share = 2.0 / 3.0, eighths = 8.0;
  double sum[2] = {0.0, 0.0};
  int count[2] = {0, 0};
  for (const Cutter& c : bit.cutters) {
    const int group = c.tip_radius <= inner_share * bit.gage_radius ? 0 : 1;
    sum[group] += std::min(1.0, c.wear / (c.diameter * std::cos(c.back_rake)));
    ++count[group];
  }
  const auto grade = [&](int group) {
    return count[group] == 0 ? 0
                             : static_cast<int>(std::lround(eighths * sum[group] / count[group]));
  };
  return {grade(0), grade(1)};
}

}  // namespace tdbd::bit
