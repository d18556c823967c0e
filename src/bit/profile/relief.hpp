#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// By how much each cutter drags its heel, m, in the order of bit.cutters: the largest height,
/// along the profile's normal, of its body over the groove that its own edge has cut; <= 0 is
/// relieved. The bit turns steadily and sinks by advance_per_rev, m, each revolution; so the groove
/// under a point that trails the edge by the angle a was cut advance a / (2 pi) higher. A worn
/// cutter's flat follows its path, not the groove: of length e it stands out by advance e / (2 pi
/// r) at the nose and by e^2 / (2 r) at the gage, so every wear flat drags. Points outside the
/// groove's width meet rock that other cutters cut, and are left out. Formulation 1 (a cutter may
/// not drag its heel).
std::vector<double> heel_drag(const Bit& bit, double advance_per_rev);

}  // namespace tdbd::bit
