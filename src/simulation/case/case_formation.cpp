#include "simulation/case/case_formation.hpp"

#include <fmt/format.h>

#include <numbers>

#include "core/error.hpp"
#include "forces/rock/rock_material.hpp"

namespace tdbd::simulation {
namespace {

using forces::Confinement;

struct Surroundings {
  forces::BottomHole hole;
  Confinement confinement = Confinement::permeable;
};

Surroundings read_surroundings(Config& c) {
  Surroundings s;
  s.hole.pressure = c.quantity("pressure", "Pa", 0.0, Range::non_negative());
  s.hole.pore_pressure = c.quantity("pore_pressure", "Pa", 0.0, Range::non_negative());
  s.hole.overburden = c.quantity("overburden", "Pa", 0.0, Range::non_negative());
  s.confinement = c.choice<Confinement>("confinement",
                                        {{"permeable", Confinement::permeable},
                                         {"impermeable", Confinement::impermeable},
                                         {"by-porosity", Confinement::by_porosity}},
                                        Confinement::permeable);
  return s;
}

/// By name from the table of rocks, or by its numbers.
forces::RockMaterial read_material(Config& c) {
  constexpr double steepest = std::numbers::pi / 3.0;  // rad
  if (!c.has("material.unconfined_strength")) {
    std::vector<std::pair<std::string, std::string>> names;
    for (const forces::KnownRock& rock : forces::known_rocks())
      names.emplace_back(std::string(rock.name), std::string(rock.name));
    return forces::rock_named(c.choice<std::string>("material", names, std::nullopt));
  }
  Config table = c.table("material");
  forces::RockMaterial m;
  m.name = table.text("name", "given by the case");
  m.unconfined = table.quantity("unconfined_strength", "Pa", std::nullopt, Range::positive());
  m.friction_angle =
      table.quantity("friction_angle", "rad", std::nullopt, Range::within(0.0, steepest));
  m.porosity = table.quantity("porosity", "1", m.porosity, Range::within(0.0, 1.0));
  return m;
}

forces::Strength read_strength(Config& c, const Surroundings& s) {
  return forces::strength_of(read_material(c), s.hole, s.confinement);
}

}  // namespace

forces::Formation read_formation(Config c) {
  constexpr double right_angle = 0.5 * std::numbers::pi;  // rad
  forces::Formation f;
  const Surroundings surroundings = read_surroundings(c);
  const double dip = c.quantity("dip", "rad", 0.0, Range::within(0.0, right_angle));
  f.normal_W = forces::bedding_normal(dip, c.quantity("dip_azimuth", "rad", 0.0));
  f.strengths.push_back(read_strength(c, surroundings));
  for (Config& layer : c.tables("layers")) {
    f.tops.push_back(layer.quantity("top", "m", std::nullopt));
    f.strengths.push_back(read_strength(layer, surroundings));
    if (f.tops.size() > 1 && !(f.tops.back() > f.tops[f.tops.size() - 2]))
      layer.problem("top", fmt::format("{} m", f.tops.back()),
                    "a top below that of the layer above");
  }
  return f;
}

}  // namespace tdbd::simulation
