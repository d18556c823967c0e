#include "claims/force_runs.hpp"

#include <fmt/format.h>

#include <numbers>

namespace tdbd::claims {

std::vector<std::string> sharp(std::vector<std::string> more) {
  std::vector<std::string> all = {"rock.material='mancos-shale'",
                                  "forces.law=detournay",
                                  fmt::format("forces.eps={}", sharp_eps),
                                  fmt::format("forces.zeta={}", sharp_zeta),
                                  "forces.sigma=0",
                                  "forces.mu=0",
                                  "forces.l=0",
                                  "forces.cutter_body.law=none",
                                  "time.revolutions=2",
                                  "output.means_from='0.5 s'"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::vector<std::string> reconstructed(std::vector<std::string> more) {
  more.insert(more.end(), {"time.revolutions=2", "output.means_from='0.5 s'"});
  return more;
}

simulation::LoadStatisticsSummary loads_of(const simulation::Case& c) {
  const simulation::Simulation s = drilled(c);
  return simulation::summarize(c.bit, s.statistics.loads,
                               c.time.step * static_cast<double>(s.state.steps_done));
}

simulation::LoadStatisticsSummary sharp_loads(const std::vector<std::string>& more) {
  return loads_of(rock_case("bit-b-steady", sharp(more)));
}

simulation::LoadStatisticsSummary reconstructed_loads(const std::vector<std::string>& more) {
  return loads_of(rock_case("bit-b-3000psi", reconstructed(more)));
}

double depth_of_cut(const simulation::Case& c) {
  return c.motion.rate_of_penetration * 2.0 * std::numbers::pi / c.motion.rotary_speed;
}

}  // namespace tdbd::claims
