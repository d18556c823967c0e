#pragma once

#include <memory>

#include "simulation/case/case.hpp"

namespace tdbd::sweep {

/// The prepared bit of a case. Points of a sweep mostly share one, and preparing it takes longer than
/// all else before a run's first step; so the last few are kept. Threads may call it at once.
std::shared_ptr<const rock::CuttingBit> prepared_bit(const simulation::Case& c);

}  // namespace tdbd::sweep
