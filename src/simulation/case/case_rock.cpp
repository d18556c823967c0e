#include "simulation/case/case_rock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "simulation/case/rock_keys.hpp"

namespace tdbd::simulation {
namespace {

/// The mesh does not show waves shorter than a few edges.
void read_roughness(Config& c, RockStart& r) {
  constexpr double least_edges = 2.0;
  r.roughness.amplitude = c.read(rock_keys::amplitude);
  r.roughness.correlation_length = c.read(rock_keys::correlation_length);
  r.roughness.seed = static_cast<std::uint64_t>(c.read(rock_keys::seed));
  if (r.roughness.correlation_length < least_edges * r.edge_length)
    c.problem(rock_keys::correlation_length, fmt::format("{} m", r.roughness.correlation_length),
              fmt::format("at least two edges, {} m", least_edges * r.edge_length));
}

void read_profile(Config& c, RockStart& r) {
  for (const auto& [radius, depth] : c.read(rock_keys::profile))
    r.profile.push_back({radius, depth});
  const std::vector<rock::MeridianPoint>& p = r.profile;
  const auto wrong = [&](const std::string& found) {
    c.problem(rock_keys::profile, found,
              "two points or more, [radius, depth], the first on the axis, the others beside it");
  };
  if (p.size() < 2) return wrong(fmt::format("{} points", p.size()));
  if (p.front().r != 0.0) return wrong(fmt::format("a first point of radius {} m", p.front().r));
  for (std::size_t i = 0; i < p.size(); ++i)
    if (!(std::max(p[i].r, std::abs(p[i].z)) <= rock_keys::largest_length))
      return c.problem(rock_keys::profile,
                       fmt::format("point {} at [{}, {}] m", i + 1, p[i].r, p[i].z),
                       fmt::format("points within {:.0e} m", rock_keys::largest_length));
  for (std::size_t i = 1; i < p.size(); ++i) {
    if (!(p[i].r > 0.0)) return wrong(fmt::format("radius {} m of point {}", p[i].r, i + 1));
    if (p[i].r == p[i - 1].r && p[i].z == p[i - 1].z)
      return wrong(fmt::format("point {} twice", i));
  }
}

struct Surroundings {
  forces::BottomHole hole;
  forces::Confinement confinement = *formation_keys::confinement.fallback;
};

Surroundings read_surroundings(Config& c) {
  Surroundings s;
  s.hole.pressure = c.read(formation_keys::pressure);
  s.hole.pore_pressure = c.read(formation_keys::pore_pressure);
  s.hole.overburden = c.read(formation_keys::overburden);
  s.confinement = c.read(formation_keys::confinement);
  return s;
}

forces::Strength read_strength(Config& c, const Surroundings& s) {
  return forces::strength_of(read_material(c), s.hole, s.confinement);
}

}  // namespace

forces::RockMaterial read_material_table(Config table) {
  using namespace formation_keys;
  forces::RockMaterial m;
  m.name = table.read(name);
  m.unconfined = table.read(unconfined_strength);
  m.friction_angle = table.read(friction_angle);
  m.porosity = table.read(porosity);
  return m;
}

forces::RockMaterial read_material(Config& c) {
  using namespace formation_keys;
  if (!c.has(fmt::format("{}.{}", material.name, unconfined_strength.name)))
    return forces::rock_named(c.read(material));
  return read_material_table(c.table(material_table));
}

RockStart read_rock(Config c) {
  RockStart r;
  r.shape = c.read(rock_keys::shape);
  r.edge_length = c.read(rock_keys::edge_length);
  r.trim = c.read(rock_keys::trim);
  if (r.shape == RockShape::file) {
    r.file = c.read(rock_keys::file);
    r.unit = c.read(rock_keys::unit);
  }
  if (r.shape == RockShape::profile) read_profile(c, r);
  if (r.shape == RockShape::file || r.shape == RockShape::profile) {
    r.intersections = c.read(rock_keys::intersection_check);
    return r;
  }
  r.wall = c.read(rock_keys::wall);
  if (r.shape == RockShape::conforming) return r;
  r.radius = c.read(rock_keys::radius);
  if (r.shape == RockShape::rough) read_roughness(c, r);
  return r;
}

std::vector<Bed> read_beds(Config c, BedMaterial material) {
  const Surroundings s = read_surroundings(c);
  const auto bed = [&](Config& of) {
    Bed b;
    if (material == BedMaterial::read) b.material = read_material(of);
    b.confining_pressure = forces::confining_pressure(s.hole, s.confinement, b.material.porosity);
    return b;
  };
  std::vector<Bed> beds{bed(c)};
  if (material == BedMaterial::read)
    for (Config& layer : c.tables(formation_keys::layers)) beds.push_back(bed(layer));
  return beds;
}

forces::Formation read_formation(Config c) {
  forces::Formation f;
  const Surroundings surroundings = read_surroundings(c);
  const double dip = c.read(formation_keys::dip);
  f.normal_W = forces::bedding_normal(dip, c.read(formation_keys::dip_azimuth));
  f.strengths.push_back(read_strength(c, surroundings));
  for (Config& layer : c.tables(formation_keys::layers)) {
    f.tops.push_back(layer.read(formation_keys::top));
    f.strengths.push_back(read_strength(layer, surroundings));
    if (f.tops.size() > 1 && !(f.tops.back() > f.tops[f.tops.size() - 2]))
      layer.problem(formation_keys::top, fmt::format("{} m", f.tops.back()),
                    "a top below that of the layer above");
  }
  return f;
}

}  // namespace tdbd::simulation
