#pragma once

#include <string>
#include <vector>

#include "core/config/config.hpp"
#include "simulation/case/case_warning.hpp"
#include "simulation/case/plans.hpp"

namespace tdbd::simulation {

/// Reads [forces.areas.NAME] (bit/areas/area_keys.hpp, force_keys) and sets plan.part_laws and
/// part_areas.
/// An area with `law` or `coefficients` gives its parts that law, as a table [forces.KIND] does for
/// a kind. An area with neither changes coefficients of the law that its parts have. Each
/// coefficient of a part follows from the most particular area that gives it; an area with a law
/// gives all of its coefficients. Parts that no area selects keep the law of their kind.
/// Notes as mistakes: those of bit::read_areas; two areas of equal rank that give a part different
/// laws or coefficients; a law that does not know the kind of one of the area's parts; parts of
/// several laws where none is named; an area that gives nothing. Coefficients that no part feels are
/// added to `warnings`. `where`: names the bit in messages.
void read_force_areas(Config& forces, const bit::Bit& bit, const std::string& where,
                      ForcePlan& plan, std::vector<CaseWarning>& warnings);

}  // namespace tdbd::simulation
