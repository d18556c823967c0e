#pragma once

#include <functional>

#include "dynamics/drilling/drilling_step.hpp"
#include "dynamics/momenta.hpp"

/// Lumped problems of a bit on a string, without any rock mesh.
namespace tdbd::dynamics {

/// A force law on a fixed cut: what it does to the bit in this state at this velocity.
using LumpedLaw = std::function<void(const DrillingSystem&, const DrillingState&,
                                     const DrillingVelocity&, Wrench&)>;

/// Whether the law sees the momenta that the last wrench predicts, or those after the drift.
enum class LawMomenta { predicted, drifted };

/// Cutting at a state; sets W of `out`.
inline void evaluate(const DrillingSystem& system, const LumpedLaw& law, const DrillingState& state,
                     Wrench& out) {
  out = Wrench{};
  out.cones.assign(system.gyrostat.cones.size(), 0.0);
  if (law) law(system, state, velocity(system, state), out);
}

/// A motion with its work beside it.
struct DrillingRun : Drilling {
  DrillingWork work;
};

/// Continues a run that was started or saved.
inline DrillingRun go_on(const DrillingSystem& system, Drilling from) {
  DrillingRun d{std::move(from), {}};
  d.work = drilling_work(system, d);
  return d;
}

inline DrillingRun start(const DrillingSystem& system, const LumpedLaw& law, DrillingState state) {
  DrillingRun d = go_on(system, start_drilling(system, std::move(state)));
  evaluate(system, law, d.state, d.wrench);
  return d;
}

inline void step(const DrillingSystem& system, const LumpedLaw& law, double h, DrillingRun& d,
                 LawMomenta momenta = LawMomenta::predicted) {
  open_step(system, h, d, d.work);
  Wrench wrench;
  evaluate(system, law,
           momenta == LawMomenta::predicted ? predicted(system, h, d, d.work) : d.state, wrench);
  close_step(system, h, wrench, d, d.work);
}

inline double residual(const DrillingSystem& system, const DrillingRun& d) {
  return residual(stored_energy(system, d.work.at, d.state), d.ledger);
}

/// A bit of 500 kg without cones, hanging in nothing.
inline DrillingSystem plain_bit() {
  DrillingSystem s;
  s.mass = 500.0;
  s.gyrostat = make_gyrostat(Vec3(8.0, 8.0, 2.0).asDiagonal(), {});
  return s;
}

inline DrillingState at_rest(const DrillingSystem& s) {
  DrillingState state;
  const std::vector<double> none(s.gyrostat.cones.size(), 0.0);
  state.rotation = make_state(s.gyrostat, Mat3::Identity(), Vec3::Zero(), none, none);
  return state;
}

}  // namespace tdbd::dynamics
