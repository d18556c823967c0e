#include "simulation/case/read_law.hpp"

#include "forces/law.hpp"
#include "simulation/case/force_keys.hpp"

namespace tdbd::simulation {

std::optional<forces::Law> read_fit(Config& c) {
  if (!c.has(force_keys::coefficients)) return std::nullopt;
  return forces::fit_named(c.read(force_keys::coefficients)).law;
}

forces::Law read_law(Config& c, const std::string& usual) {
  const std::optional<forces::Law> fit = read_fit(c);
  std::optional<std::string> fallback;
  if (fit)
    fallback = forces::law_name(*fit);
  else if (!usual.empty())
    fallback = usual;
  const std::string name = c.read(force_keys::law, fallback);
  if (fit && name != forces::law_name(*fit))
    c.problem(force_keys::law, name,
              "the law of forces.coefficients, " + std::string(forces::law_name(*fit)));
  forces::Law law = fit.value_or(forces::law_named(name));
  for (const forces::LawField& f : forces::law_fields(law))
    *f.value = c.read(force_keys::key_of(f), fit ? std::optional(*f.value) : f.fallback);
  return law;
}

}  // namespace tdbd::simulation
