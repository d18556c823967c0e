#include "calibration/laboratory/laboratory_tables.hpp"

#include "calibration/laboratory/laboratory_keys.hpp"

namespace tdbd::calibration {

std::vector<KeyTable> laboratory_tables() {
  using namespace laboratory_keys;
  const std::string command = "laboratory";
  return {key_table(command, laboratory_keys::table,
                    rows(law, bits, pressures, rates, rotary_speed, seed)),
          key_table(command, truth, rows(any_coefficient))};
}

}  // namespace tdbd::calibration
