#include <algorithm>
#include <cmath>
#include <numbers>

#include "claims/example_bits.hpp"
#include "claims/rock_runs.hpp"
#include "reference/bit/radial_plane_engagement.hpp"

/// Claims of chapter 2, chapter 6 and appendix C on forces, of bit B at a given rate.
namespace tdbd::claims::forces_test {

constexpr double eps = 100e6, zeta = 0.8;  ///< Pa and 1: the literature's common rock
constexpr double two_pi = 2.0 * std::numbers::pi;

/// What is common to the runs here: a sharp bit, means of the second revolution.
std::vector<std::string> sharp(std::vector<std::string> more) {
  std::vector<std::string> all = {"rock.material='mancos-shale'",
                                  "forces.law=detournay",
                                  "forces.eps='100 MPa'",
                                  "forces.zeta=0.8",
                                  "forces.sigma=0",
                                  "forces.mu=0",
                                  "forces.l=0",
                                  "forces.cutter_body.law=none",
                                  "time.revolutions=2",
                                  "output.means_from='0.5 s'"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

simulation::LoadFigures loads_of(const simulation::Case& c) {
  const simulation::Simulation s = drilled(c);
  return simulation::figures_of(c.bit, s.statistics.loads,
                                c.time.step * static_cast<double>(s.state.steps_done));
}

simulation::LoadFigures sharp_loads(const std::vector<std::string>& more) {
  return loads_of(rock_case("bit-b-steady", sharp(more)));
}

double depth_of_cut(const simulation::Case& c) {
  return c.motion.rate_of_penetration * two_pi / c.motion.rotary_speed;
}

/// w T + v W = eps pi R^2 v: exact of a sharp bit, whatever its layout.
TEST(Forces, of_a_sharp_bit_have_the_power_of_its_volume) {
  std::vector<double> errors;
  double torque_error = 0.0;
  for (const char* edge : {"4 mm", "2.8 mm", "2 mm", "1.4 mm", "1 mm"}) {
    const simulation::Case c =
        rock_case("bit-b-steady", sharp({"rock.edge_length='" + std::string(edge) + "'"}));
    const simulation::LoadFigures f = loads_of(c);
    const double R = c.bit.gage_radius;
    errors.push_back(std::abs(f.specific_energy / eps - 1.0));
    torque_error = f.tob.mean / (0.5 * eps * R * R * depth_of_cut(c)) - 1.0;
    record_bound(
        "appendix-c/sharp-power",
        fmt::format("bit B, edges of {}: w T + v W over eps pi R^2 v, distance from 1", edge),
        errors.back(), "1", 0.02);
  }
  record_bound("appendix-c/sharp-power", "bit B, edges of 1 mm: the same", errors.back(), "1",
               5e-3);
  record_bound(
      "appendix-c/sharp-power",
      "bit B: error at 1 mm over the error at 4 mm; 0.1 to 0.2 % stay, of discs beside the axis",
      errors.back() / errors.front(), "1", 0.5);
  record_bound(
      "appendix-c/sharp-torque",
      "bit B, edges of 1 mm: T over eps R^2 d/2, distance from 1 (the helix is 0.43 % of it)",
      std::abs(torque_error), "1", 1e-2);
}

/// Without normal force the helix is no more than the square of its angle.
TEST(Forces, of_faces_without_friction_have_the_torque_of_the_identity) {
  const simulation::Case c = rock_case("bit-b-steady", sharp({"forces.zeta=0"}));
  const double R = c.bit.gage_radius;
  record_bound("appendix-c/sharp-torque",
               "bit B, edges of 1 mm, zeta 0: T over eps R^2 d/2, distance from 1",
               std::abs(loads_of(c).tob.mean / (0.5 * eps * R * R * depth_of_cut(c)) - 1.0), "1",
               5e-3);
}

/// The weight of Warren and Sinor's plane: sum of zeta eps A_i cos theta_i.
TEST(Forces, carry_the_weight_of_the_radial_plane) {
  const simulation::Case c = rock_case("bit-b-steady", sharp({}));
  const reference::Engagement plane =
      reference::radial_plane_engagement(c.bit, depth_of_cut(c), 0.05e-3);
  double weight = 0.0;
  for (std::size_t i = 0; i < c.bit.cutters.size(); ++i)
    weight += zeta * eps * plane.mean_area[i] * std::cos(c.bit.cutters[i].profile_angle);
  record_bound("chapter2/radial-plane",
               "bit B, edges of 1 mm: weight over the plane's, distance from 1",
               std::abs(loads_of(c).wob.mean / weight - 1.0), "1", 0.01);
}

/// The tangential forces of a helix carry weight, too: about d ln(R/r) / (2 pi zeta R) of it, 1 %
/// of bit B's at 2 mm a revolution.
TEST(Forces, double_with_the_depth_of_cut) {
  constexpr double helix = 0.02;
  const auto once = sharp_loads({"rock.edge_length='1.5 mm'"});
  const auto twice =
      sharp_loads({"rock.edge_length='1.5 mm'", "motion.rate_of_penetration='30 m/h'"});
  record_bound("appendix-c/depth",
               "bit B: weight at twice the depth over twice the weight, distance from 1",
               std::abs(twice.wob.mean / (2.0 * once.wob.mean) - 1.0), "1", helix);
  record_bound("appendix-c/depth",
               "bit B: torque at twice the depth over twice the torque, distance from 1",
               std::abs(twice.tob.mean / (2.0 * once.tob.mean) - 1.0), "1", 0.01);
}

TEST(Forces, do_not_depend_on_the_step) {
  const auto whole = sharp_loads({"rock.edge_length='1.5 mm'", "time.step='2 ms'"});
  const auto half = sharp_loads({"rock.edge_length='1.5 mm'", "time.step='1 ms'"});
  record_bound("appendix-c/step",
               "bit B: mean weight at half the step over the mean, distance from 1",
               std::abs(half.wob.mean / whole.wob.mean - 1.0), "1", 5e-3);
  record_bound("appendix-c/step",
               "bit B: mean torque at half the step over the mean, distance from 1",
               std::abs(half.tob.mean / whole.tob.mean - 1.0), "1", 5e-3);
}

/// Two pressures: the tangential forces of the reconstructed law grow with the confined strength.
TEST(Forces, grow_with_pressure_as_the_confined_strength_does) {
  const auto at = [](const char* name) {
    return loads_of(rock_case(name, {"rock.edge_length='3 mm'", "time.step='2 ms'",
                                     "time.revolutions=2", "output.means_from='0.5 s'"}));
  };
  const double ratio = at("bit-b-6000psi").wob.mean / at("bit-b-3000psi").wob.mean;
  record_near("chapter6/pressure", "bit B: weight at 6000 psi over weight at 3000 psi", ratio, 1.43,
              0.01);
}

}  // namespace tdbd::claims::forces_test
