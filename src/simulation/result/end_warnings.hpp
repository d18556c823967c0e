#pragma once

#include <vector>

#include "simulation/case/case_warning.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// What only the run shows to be doubtful, at `motion`: a bit body, or a part that rubs, that is deeper in rock than the
/// rock's edge length and than 1 mm; a bit that removed no rock; and, of a bit that forces move, a mean
/// advance that no bit has: more in a revolution than its narrowest cutting part is wide, so that its body would have to
/// cut, or more in one step; and stick-slip with sections as they are ahead of the faces. Follows from the case and from what a checkpoint holds.
std::vector<CaseWarning> end_warnings(const Case& c, const Simulation& s);

}  // namespace tdbd::simulation
