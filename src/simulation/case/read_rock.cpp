#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "simulation/case/rock_settings.hpp"

namespace tdbd::simulation {
namespace {

/// The mesh does not resolve waves shorter than a few edges.
void check_roughness(Config& c, const RockStart& r) {
  constexpr double least_edges = 2.0;
  if (r.roughness.correlation_length < least_edges * r.edge_length)
    c.problem("correlation_length", fmt::format("{} m", r.roughness.correlation_length),
              fmt::format("at least two edges, {} m", least_edges * r.edge_length));
}

void check_profile(Config& c, const std::vector<rock::MeridianPoint>& p) {
  const auto wrong = [&](const std::string& found) {
    c.problem("profile", found,
              "two points or more, [radius, depth], the first on the axis, the others beside it");
  };
  if (p.size() < 2) return wrong(fmt::format("{} points", p.size()));
  if (p.front().r != 0.0) return wrong(fmt::format("a first point of radius {} m", p.front().r));
  for (std::size_t i = 0; i < p.size(); ++i)
    if (!(std::max(p[i].r, std::abs(p[i].z)) <= largest_length))
      return c.problem("profile", fmt::format("point {} at [{}, {}] m", i + 1, p[i].r, p[i].z),
                       fmt::format("points within {:.0e} m", largest_length));
  for (std::size_t i = 1; i < p.size(); ++i) {
    if (!(p[i].r > 0.0)) return wrong(fmt::format("radius {} m of point {}", p[i].r, i + 1));
    if (p[i].r == p[i - 1].r && p[i].z == p[i - 1].z)
      return wrong(fmt::format("point {} twice", i));
  }
}

Surroundings read_surroundings(Config& c) {
  Surroundings s;
  read_fields(c, s);
  return s;
}

}  // namespace

std::vector<std::string_view> NamedRock::names() {
  std::vector<std::string_view> all;
  for (const forces::KnownRock& rock : forces::known_rocks()) all.push_back(rock.name);
  return all;
}

forces::RockMaterial read_material(Config& c) {
  if (c.has("material.unconfined_strength")) return read_table<RockByNumbers>(c).material;
  NamedRock rock;
  read_fields(c, rock);
  return forces::rock_named(rock.material);
}

RockStart read_rock(Config& whole) {
  const RockStart r = read_table<RockStart>(whole);
  Config c = whole.table(RockStart::table);
  if (r.shape == RockShape::rough) check_roughness(c, r);
  if (r.shape == RockShape::profile) check_profile(c, r.profile);
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
    for (Config& layer : c.tables(RockLayer::table)) beds.push_back(bed(layer));
  return beds;
}

forces::Formation read_formation(Config c) {
  forces::Formation f;
  const Surroundings s = read_surroundings(c);
  const auto strength = [&](Config& of) {
    return forces::strength_of(read_material(of), s.hole, s.confinement);
  };
  Bedding bedding;
  read_fields(c, bedding);
  f.normal_W = forces::bedding_normal(bedding.dip, bedding.azimuth);
  f.strengths.push_back(strength(c));
  for (Config& layer : c.tables(RockLayer::table)) {
    RockLayer bed;
    read_fields(layer, bed);
    f.tops.push_back(bed.top);
    f.strengths.push_back(strength(layer));
    if (f.tops.size() > 1 && !(f.tops.back() > f.tops[f.tops.size() - 2]))
      layer.problem("top", fmt::format("{} m", f.tops.back()),
                    "a top below that of the layer above");
  }
  return f;
}

}  // namespace tdbd::simulation
