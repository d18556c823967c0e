#include "calibration/case/calibration_tables.hpp"

#include "bit/areas/area_keys.hpp"
#include "calibration/case/calibration_keys.hpp"
#include "simulation/case/rock_keys.hpp"
#include "simulation/case/spalling_keys.hpp"

namespace tdbd::calibration {

std::vector<KeyTable> calibration_tables() {
  using namespace calibration_keys;
  using namespace simulation::formation_keys;
  namespace area_keys = bit::area_keys;
  const std::string command = "calibrate";
  return {
      key_table(command, calibration_keys::table,
                rows(law, records, fit_bits, predict_bits, leave_out, calibration_keys::pressures)),
      key_table(command, bits, rows(any_bit)),
      key_table(command, cutter, rows(diameter, back_rake, wear_flat, chamfer)),
      key_table(command, calibration_keys::rock,
                rows(material, edge_length, confinement, pore_pressure, overburden)),
      key_table(command, rocks, rows(name, unconfined_strength, friction_angle, porosity)),
      key_table(command, calibration_keys::time, rows(revolutions, steps_per_revolution)),
      key_table(
          command, simulation::spalling_keys::table,
          rows(simulation::spalling_keys::angle, simulation::spalling_keys::depth_share,
               simulation::spalling_keys::ahead_share, simulation::spalling_keys::up_to_pressure)),
      key_table(command, noise, rows(reading, test, rop)),
      key_table(command, unknown, rows(start, prior_sd, range)),
      key_table(command, fixed, rows(any_coefficient)),
      key_table(command, area,
                rows(area_keys::kind, area_keys::zone, area_keys::blade, area_keys::names,
                     area_keys::part)),
      key_table(command, area_unknown, rows(start, prior_sd, range)),
      key_table(command, area_fixed, rows(any_area_coefficient)),
      key_table(command, intervals, rows(level, bootstrap, seed))};
}

}  // namespace tdbd::calibration
