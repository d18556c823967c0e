#include "verification/string/wells.hpp"

#include <cmath>

namespace tdbd::string {

std::vector<Section> well_a_sections() {
  Section upper = pipe(2270.0, {0.146529, 0.123024, 0.146529}, {206e9, 61e9, 7850.0}, 0.0, {});
  Section lower = upper;
  const double polar = 8.49371e-5, area = 0.0155634;
  lower.length = 230.0;
  lower.torsional_rigidity = 67e9 * polar;
  lower.inertia = 7850.0 * polar;
  lower.axial_rigidity = 206e9 * area;
  lower.mass = 7850.0 * area;
  lower.contact_radius = 0.083591;
  upper.weight = upper.mass * 9.81;
  lower.weight = lower.mass * 9.81;
  return {upper, lower};
}

Survey build_and_hold() {
  return make_survey({{0.0, 500.0, 1100.0, 2500.0},
                      {0.0, 0.0, 60.0 * degree, 60.0 * degree},
                      {0.0, 0.0, 0.0, 0.0}});
}

std::vector<Section> plain_build_and_hold() { return {steel(2500.0, 0.127, 0.1086, 0.1682, 0.87)}; }

std::vector<Section> three_sections() {
  return {steel(2300.0, 0.127, 0.1086, 0.1682, 0.87), steel(120.0, 0.127, 0.0762, 0.1651, 0.87),
          steel(80.0, 0.1651, 0.0714, 0.1651, 0.87)};
}

Chain make_chain(const std::vector<Section>& sections, const Survey& survey, double friction,
                 int elements) {
  Chain c;
  c.elements = make_elements(sections, elements);
  c.contact = make_contact(sections, survey, {{0.0, friction, friction}}, elements);
  return c;
}

Running at_rest(const Chain& chain) {
  Running r{{chain_at_rest(chain), {}}, {}};
  r.work = chain_work(chain, r.state.chain, motion_of(r.state.bit));
  return r;
}

}  // namespace tdbd::string
