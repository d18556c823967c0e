#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/wear/wear_law.hpp"
#include "dynamics/drilling/drilling_system.hpp"
#include "forces/law.hpp"
#include "forces/rock/rock_material.hpp"
#include "rock/section/breakout.hpp"
#include "simulation/case/force_keys.hpp"
#include "simulation/case/run_keys.hpp"
#include "string/section.hpp"
#include "string/statics.hpp"

namespace tdbd::simulation {

/// What a run measures in every step, for forces.
struct MeasurePlan {
  SectionMeasure section = *measure_keys::section.fallback;
  double section_lead = *measure_keys::section_lead.fallback;  ///< over the rock's edge length
  rock::SectionAtFace section_at_face = *measure_keys::section_at_face.fallback;
  ContactMeasure contact = *measure_keys::contact.fallback;
  double contact_gap = *measure_keys::contact_gap.fallback;    ///< over the rock's edge length
  long section_every = *measure_keys::section_every.fallback;  ///< steps
};

/// Whether a run computes forces at all.
enum class Forces { off, on };

/// The force laws of a run, by kind of part or by part, and the rock that they act in.
struct ForcePlan {
  Forces forces = Forces::off;
  CutMeasure cut = *force_keys::cut.fallback;
  ChamferMeasure chamfer = *force_keys::chamfer_contact.fallback;
  FlatMeasure flat = FlatMeasure::triangles;
  std::array<forces::Law, bit::part_kinds.size()> laws;  ///< by PartKind
  std::vector<forces::Law> part_laws;  ///< by part, if areas give laws (case_areas.hpp); else empty
  std::vector<std::vector<std::string>> part_areas;  ///< by part: areas that select it; or empty
  forces::Formation rock;
};

/// The law of a kind of part, where no area gives another one.
inline const forces::Law& law_of(const ForcePlan& plan, bit::PartKind kind) {
  return plan.laws[static_cast<std::size_t>(kind)];
}

/// The law of a part of this kind. `part`: index into Bit::parts.
inline const forces::Law& law_of(const ForcePlan& plan, bit::PartKind kind, int part) {
  return plan.part_laws.empty() ? law_of(plan, kind)
                                : plan.part_laws[static_cast<std::size_t>(part)];
}

/// Whether parts of this kind have a force, where no area gives another law.
inline bool has_law(const ForcePlan& plan, bit::PartKind kind) {
  return !std::holds_alternative<forces::NoForce>(law_of(plan, kind));
}

/// Whether a part of this kind has a force.
inline bool has_law(const ForcePlan& plan, bit::PartKind kind, int part) {
  return !std::holds_alternative<forces::NoForce>(law_of(plan, kind, part));
}

/// The same of the part at this place in the bit.
inline bool has_law(const ForcePlan& plan, const bit::Bit& bit, std::size_t part) {
  return has_law(plan, bit.parts[part].kind, static_cast<int>(part));
}

/// How the bit wears.
struct WearPlan {
  std::vector<bit::WearLaw> part_laws;  ///< by part; empty: the bit does not wear
  bit::FlatHeating heating;
  double acceleration = 1.0;     ///< multiplies the rates of the laws
  double from = 0.0;             ///< s, before which the bit does not wear
  long every_steps = 0;          ///< time steps between two wear steps, at most; 0: no limit
  double every = 0.0;            ///< m down between two wear steps, at most; 0: no limit
  double largest_growth = 0.01;  ///< of a flat's height in a wear step, over bit::WearSolid::size
};

/// Whether the bit wears.
inline bool wears(const WearPlan& plan) { return !plan.part_laws.empty(); }

/// Rock that breaks out beside faces.
struct SpallingPlan {
  std::vector<std::optional<rock::BreakoutRule>> rules;  ///< per cutter; empty: no rock breaks out
  std::vector<std::uint8_t> beds;  ///< per bed of the formation: whether its rock breaks out
};

/// Whether rock breaks out beside any face.
inline bool spalls(const SpallingPlan& plan) { return !plan.rules.empty(); }

/// What a string on a chain is made of and where it lies.
struct StringPlan {
  std::vector<string::Section> sections;
  string::Survey survey;
  std::vector<string::FrictionBelow> friction;          ///< by depth, downward
  double threshold = 0.0;                               ///< m/s
  double axial_damping = 0.0, torsional_damping = 0.0;  ///< 1/s
  double axial_loss_time = 0.0;                         ///< s
  double torsional_loss_time = 0.0;                     ///< s
  double hole_diameter = 0.0;                           ///< m; 0: not given
};

/// What is recorded of a string on a chain.
struct ChainOutput {
  std::vector<int> nodes;  ///< in the history
  long profile_every = 0;  ///< steps between profiles of all nodes; 0: none
};

/// The bit, the string, the wall and the rock's mount of a bit that forces move, and how they start
/// (thesis: eqs. 2.1 to 2.3).
struct DrillingPlan {
  dynamics::DrillingSystem system;
  dynamics::DrillingState start;
  // Of a string on a chain.
  StringPlan string;
  string::ChainState chain;           ///< at the start
  string::SteadyMotion start_motion;  ///< of that chain
};

}  // namespace tdbd::simulation
