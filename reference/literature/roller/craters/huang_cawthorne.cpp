#include "reference/literature/roller/craters/huang_cawthorne.hpp"

namespace tdbd::reference {

RollerRun huang_cawthorne(const RollerBit& bit, const ToothTable& table,
                          const RollerSchedule& schedule, const HuangCawthorneOptions& options) {
  CraterDrillingOptions o = options.drilling;
  o.first_ratio = options.first_ratio;
  if (options.way == PatentWay::first) {
    o.way = ConeWay::increments;
    o.torque_average = options.torque_average;
    o.given_revolutions = options.given_revolutions;
    o.sliding.bearing = 0.0;
  } else {
    o.way = ConeWay::speeds;
    o.torque_average = 0.0;
    o.given_revolutions = 0.0;
    o.sliding.bearing = options.bearing;
  }
  return crater_drilling(bit, table, schedule, o);
}

}  // namespace tdbd::reference
