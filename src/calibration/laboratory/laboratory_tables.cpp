#include "calibration/laboratory/laboratory_tables.hpp"

#include "bit/areas/area_keys.hpp"
#include "calibration/laboratory/laboratory_keys.hpp"

namespace tdbd::calibration {

std::vector<KeyTable> laboratory_tables() {
  using namespace laboratory_keys;
  namespace area_keys = bit::area_keys;
  const std::string command = "laboratory";
  return {key_table(command, laboratory_keys::table,
                    rows(law, bits, pressures, rates, rotary_speed, seed)),
          key_table(command, truth, rows(any_coefficient)),
          key_table(command, area,
                    rows(area_keys::kind, area_keys::zone, area_keys::blade, area_keys::names,
                         area_keys::part)),
          key_table(command, area_truth, rows(any_area_coefficient))};
}

}  // namespace tdbd::calibration
