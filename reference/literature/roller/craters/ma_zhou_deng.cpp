#include "reference/literature/roller/craters/ma_zhou_deng.hpp"

namespace tdbd::reference {

RollerRun ma_zhou_deng(const RollerBit& bit, const ToothLaw& law, const RollerSchedule& schedule,
                       const MaZhouDengOptions& options) {
  return crater_drilling(bit, law, schedule, options.drilling);
}

}  // namespace tdbd::reference
