#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::reference {

/// Computes how far each cutter's heel drags, m, in the order of bit.cutters: the largest height,
/// along the profile's normal, of its body above the groove that its own edge has cut. If it is <=
/// 0, the cutter is relieved. No cutter of a bit may drag its heel; with the wrong sign of back
/// rake all do.
///
/// The bit turns steadily and moves down by advance_per_rev (m) per revolution, so the groove under
/// a point that trails the edge by the angle a was cut higher by advance a / (2 pi). A wear flat
/// follows its path, not the groove: a flat of length e protrudes by advance e / (2 pi r) at the
/// nose and by e^2 / (2 r) at the gage, so every wear flat drags. Points outside the groove's width
/// meet rock that other cutters cut, and are omitted.
std::vector<double> heel_drag(const bit::Bit& bit, double advance_per_rev);

}  // namespace tdbd::reference
