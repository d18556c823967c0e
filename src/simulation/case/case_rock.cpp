#include "simulation/case/case_rock.hpp"

#include <fmt/format.h>

#include <limits>

namespace tdbd::simulation {
namespace {

IntersectionCheck read_intersections(Config& c) {
  return c.choice<IntersectionCheck>(
      "intersection_check", {{"on", IntersectionCheck::full}, {"off", IntersectionCheck::none}},
      IntersectionCheck::full);
}

/// Waves shorter than a few edges are not seen by the mesh.
void read_roughness(Config& c, RockStart& r) {
  constexpr double least_edges = 2.0;
  r.roughness.amplitude = c.quantity("amplitude", "m", std::nullopt, Range::non_negative());
  r.roughness.correlation_length =
      c.quantity("correlation_length", "m", std::nullopt, Range::positive());
  const long seed = c.integer("seed", 1, 0, std::numeric_limits<long>::max());
  r.roughness.seed = static_cast<std::uint64_t>(seed);
  if (r.roughness.correlation_length < least_edges * r.edge_length)
    c.problem("correlation_length", fmt::format("{} m", r.roughness.correlation_length),
              fmt::format("at least two edges, {} m", least_edges * r.edge_length));
}

void read_profile(Config& c, RockStart& r) {
  for (const auto& [radius, depth] : c.pairs("profile", "m", std::nullopt))
    r.profile.push_back({radius, depth});
  const std::vector<rock::MeridianPoint>& p = r.profile;
  const auto wrong = [&](const std::string& found) {
    c.problem("profile", found,
              "two points or more, [radius, depth], the first on the axis, the others beside it");
  };
  if (p.size() < 2) return wrong(fmt::format("{} points", p.size()));
  if (p.front().r != 0.0) return wrong(fmt::format("a first point of radius {} m", p.front().r));
  for (std::size_t i = 1; i < p.size(); ++i) {
    if (!(p[i].r > 0.0)) return wrong(fmt::format("radius {} m of point {}", p[i].r, i + 1));
    if (p[i].r == p[i - 1].r && p[i].z == p[i - 1].z)
      return wrong(fmt::format("point {} twice", i));
  }
}

}  // namespace

RockStart read_rock(Config c) {
  RockStart r;
  r.shape = c.choice<RockShape>("shape",
                                {{"conforming", RockShape::conforming},
                                 {"flat", RockShape::flat},
                                 {"rough", RockShape::rough},
                                 {"profile", RockShape::profile},
                                 {"file", RockShape::file}},
                                RockShape::conforming);
  r.edge_length = c.quantity("edge_length", "m", std::nullopt, Range::within(1e-5, 0.1));
  r.trim = c.quantity("trim", "m", 0.0, Range::non_negative());
  if (r.shape == RockShape::file) {
    r.file = c.path("file", std::nullopt);
    r.unit = c.quantity("unit", "m", 1e-3, Range::positive());
  }
  if (r.shape == RockShape::profile) read_profile(c, r);
  if (r.shape == RockShape::file || r.shape == RockShape::profile) {
    r.intersections = read_intersections(c);
    return r;
  }
  r.wall = c.quantity("wall", "m", 0.03, Range::non_negative());
  if (r.shape == RockShape::conforming) return r;
  r.radius = c.quantity("radius", "m", 0.0, Range::non_negative());
  if (r.shape == RockShape::rough) read_roughness(c, r);
  return r;
}

}  // namespace tdbd::simulation
