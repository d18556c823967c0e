#include "simulation/result/part_laws.hpp"

namespace tdbd::simulation {

std::vector<bit::PartLaw> part_laws(const Case& c) {
  std::vector<bit::PartLaw> laws;
  if (c.forces.forces == Forces::off) return laws;
  for (std::size_t i = 0; i < c.bit.parts.size(); ++i) {
    forces::Law law = law_of(c.forces, c.bit.parts[i].kind, static_cast<int>(i));
    bit::PartLaw& words = laws.emplace_back();
    words.law = forces::law_name(law);
    for (const forces::LawField& f : forces::law_fields(law))
      words.coefficients.emplace_back(std::string(f.key), *f.value);
    if (!c.forces.part_areas.empty()) words.areas = c.forces.part_areas[i];
  }
  return laws;
}

}  // namespace tdbd::simulation
