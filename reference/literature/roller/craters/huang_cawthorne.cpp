#include "reference/literature/roller/craters/huang_cawthorne.hpp"

namespace tdbd::reference {

RollerRun huang_cawthorne(const RollerBit& bit, const ToothTable& table,
                          const RollerSchedule& schedule, const HuangCawthorneOptions& options) {
  CraterDrillingOptions o = options.drilling;
  o.first_ratio = options.first_ratio;
  if (options.way == PatentMethod::first) {
    o.way = ConeUpdate::increments;
    o.torque_average = options.torque_average;
    o.prescribed_ratio_revolutions = options.prescribed_ratio_revolutions;
    o.sliding.bearing = 0.0;
  } else {
    o.way = ConeUpdate::speeds;
    o.torque_average = 0.0;
    o.prescribed_ratio_revolutions = 0.0;
    o.sliding.bearing = options.bearing;
  }
  return crater_drilling(bit, table, schedule, o);
}

}  // namespace tdbd::reference
