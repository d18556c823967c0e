#include "simulation/step/wear_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "bit/mass_properties.hpp"
#include "simulation/step/drive.hpp"
#include "simulation/step/late_start.hpp"

namespace tdbd::simulation {
namespace {

/// A wear step is due where a flat has grown by this share of the largest growth: what is left is
/// for the step that follows.
constexpr double due_share = 0.5;

/// How far flats may grow from here.
void limit_growth(const Case& c, const WearState& s, WearWork& w) {
  w.due_volume.clear();
  w.most_volume.clear();
  for (std::size_t i = 0; i < w.solids.size(); ++i) {
    const bit::WearSolid& solid = w.solids[i];
    const double growth = c.wear.largest_growth * solid.diameter;
    const auto volume = [&](double share) {
      return bit::flat_at(solid, s.cutters[i].height + share * growth).volume;
    };
    w.due_volume.push_back(volume(due_share));
    w.most_volume.push_back(volume(1.0));
  }
}

/// Whether the next step, if it wears no more than twice the last one, makes a flat too large.
bool may_grow_too_far(const WearState& s, const WearWork& w) {
  constexpr double care = 2.0;
  const double step = s.window_time / static_cast<double>(s.window_steps);
  for (std::size_t i = 0; i < s.cutters.size(); ++i) {
    const CutterWear& c = s.cutters[i];
    if (volume_after(s, c, c.window + care * c.last, s.window_time + step) > w.due_volume[i])
      return true;
  }
  return false;
}

bool is_wear_due(const WearPlan& plan, const WearState& s, const WearWork& w) {
  if (s.window_steps == 0) return false;
  return (plan.every_steps > 0 && s.window_steps >= plan.every_steps) ||
         (plan.every > 0.0 && s.window_distance >= plan.every) || may_grow_too_far(s, w);
}

void require_slow_growth(const WearPlan& plan, const WearState& s, const WearWork& w) {
  for (std::size_t i = 0; i < s.cutters.size(); ++i) {
    const CutterWear& c = s.cutters[i];
    if (volume_after(s, c, c.window, s.window_time) > w.most_volume[i])
      throw WearEnd(fmt::format(
          "wear.acceleration: found {:g}, with which the flat of cutter-{} grows in a window of {} "
          "time steps by more than {:g} of its diameter (wear.largest_growth); expected a smaller "
          "acceleration or a larger growth",
          plan.acceleration, w.solids[i].id, s.window_steps, plan.largest_growth));
  }
}

/// The bit of the case with flats at the heights of the state.
bit::Bit bit_at(const Case& c, const WearState& s, const std::vector<bit::WearSolid>& solids) {
  bit::Bit worn = c.bit;
  for (std::size_t i = 0; i < s.cutters.size(); ++i)
    if (s.cutters[i].height > solids[i].start)
      bit::wear_cutter(c.bit, static_cast<int>(i), s.cutters[i].height, worn);
  return worn;
}

/// The case with a worn bit. Of a bit that forces move mass, centre and inertia follow; the string,
/// its rest, and what of it moves with the bit stay.
void wear_case(const Case& c, bit::Bit worn, Case& to) {
  to.bit = std::move(worn);
  if (c.motion.kind != MotionKind::drilling) return;
  const bit::MassProperties fresh = bit::mass_properties(c.bit), now = bit::mass_properties(to.bit);
  dynamics::DrillingSystem& system = to.drilling.system;
  system.mass = c.drilling.system.mass - (fresh.mass - now.mass);
  system.centre_B = now.centre;
  system.gyrostat =
      dynamics::make_gyrostat(c.drilling.system.gyrostat.inertia_B - (fresh.inertia - now.inertia),
                              c.drilling.system.gyrostat.cones);
  to.drilling.start.c_W = c.drilling.start.c_W + (now.centre - fresh.centre);
}

/// The motion with the mass of the worn bit: pose and velocities stay, momenta and the last wrench are
/// those about the new centre, and the ledger of energy starts with what is left.
void carry_motion(const dynamics::DrillingSystem& before, const dynamics::DrillingSystem& now,
                  dynamics::Drilling& d) {
  dynamics::DrillingState& s = d.state;
  const dynamics::DrillingVelocity v = dynamics::velocity(before, s);
  const double stored =
      dynamics::total(dynamics::stored_energy(before, dynamics::drilling_work(before, d).at, s));
  const Vec3 shift_W = s.rotation.q_WB * (now.centre_B - before.centre_B);
  s.c_W += shift_W;
  s.momentum_W = now.mass * (v.v_W + v.w_W.cross(shift_W));
  const Vec3 w_B = s.rotation.q_WB.conjugate() * v.w_W;
  s.rotation.momentum_W = s.rotation.q_WB * (now.gyrostat.carrier_B * w_B);
  d.wrench.torque_W -= shift_W.cross(d.wrench.force_W);
  d.ledger.start +=
      dynamics::total(dynamics::stored_energy(now, dynamics::drilling_work(now, d).at, s)) - stored;
}

/// What rubs on the cutters: forces, paths and areas of their parts that bear.
struct Rubbing {
  double force = 0.0, power = 0.0, area = 0.0;  ///< N, W, m2
};

std::vector<Rubbing> rubbing_of(const bit::Bit& bit, const Work& work,
                                const std::vector<double>& speeds) {
  std::vector<Rubbing> rubbing(bit.cutters.size());
  const auto bears = [&](std::size_t p) {
    return bit.parts[p].cutter >= 0 && bit.parts[p].kind != bit::PartKind::face;
  };
  for (const CutOfPart& cut : work.cuts)
    if (bears(at(cut.part)))
      rubbing[at(bit.parts[at(cut.part)].cutter)].area += cut.cut.contact_area;
  for (std::size_t p = 0; p < speeds.size(); ++p) {
    if (!bears(p)) continue;
    Rubbing& r = rubbing[at(bit.parts[p].cutter)];
    const double force = std::max(0.0, work.loads.parts[p].normal);
    r.force += force;
    r.power += force * speeds[p];
  }
  return rubbing;
}

/// m/s, of each part that bears a load on a cutter, over the rock.
std::vector<double> part_speeds(const bit::Bit& bit, const Pose& X_WB, const Work& work) {
  std::vector<double> speeds(work.loads.parts.size(), 0.0);
  for (std::size_t p = 0; p < speeds.size(); ++p)
    if (bit.parts[p].cutter >= 0 && work.loads.parts[p].normal > 0.0)
      speeds[p] = velocity_at(bit, X_WB, work.velocity, -1, work.loads.parts[p].point_W).norm();
  return speeds;
}

void rub(const Case& c, const Pose& X_WB, const Work& work, const WearWork& w,
         std::vector<CutterRub>& rubs) {
  const std::vector<double> speeds = part_speeds(c.bit, X_WB, work);
  const std::vector<Rubbing> rubbing = rubbing_of(c.bit, work, speeds);
  rubs.assign(c.bit.cutters.size(), {});
  for (std::size_t i = 0; i < rubs.size(); ++i) {
    const Rubbing& r = rubbing[i];
    const double speed = r.force > 0.0 ? r.power / r.force : 0.0;
    rubs[i].temperature =
        bit::flat_temperature(c.wear.heating, {r.force, speed, r.area, w.flats[i].length});
  }
  for (std::size_t p = 0; p < speeds.size(); ++p) {
    if (!(speeds[p] > 0.0)) continue;
    CutterRub& on = rubs[at(c.bit.parts[p].cutter)];
    const double force = work.loads.parts[p].normal;
    on.force += force;
    on.rate += bit::wear_rate(c.wear.part_laws[p], {force, speeds[p], on.temperature});
  }
}

WearRecord record_of(const WearState& s, const WearWork& w) {
  WearRecord r;
  r.distance = s.distance;
  for (std::size_t i = 0; i < s.cutters.size(); ++i) {
    r.width.push_back(w.flats[i].width);
    r.volume.push_back(s.cutters[i].volume);
    r.temperature.push_back(s.rubs[i].temperature);
    r.force.push_back(s.rubs[i].force);
  }
  return r;
}

}  // namespace

std::optional<WearState> start_wear(const Case& c) {
  if (!wears(c.wear)) return std::nullopt;
  WearState s;
  for (const bit::WearSolid& solid : bit::wear_solids(c.bit))
    s.cutters.push_back({.height = solid.start});
  s.rubs.resize(s.cutters.size());
  return s;
}

std::optional<WearWork> wear_work(const Case& c, const State& state) {
  if (!state.wear) return std::nullopt;
  WearWork w;
  w.solids = bit::wear_solids(c.bit);
  w.worn = c;
  wear_case(c, bit_at(c, *state.wear, w.solids), w.worn);
  for (std::size_t i = 0; i < w.solids.size(); ++i)
    w.flats.push_back(bit::flat_at(w.solids[i], state.wear->cutters[i].height));
  limit_growth(c, *state.wear, w);
  return w;
}

void wear_if_due(const Case& c, Simulation& sim) {
  State& state = sim.state;
  WearWork& w = *sim.work.wear;
  if (!is_wear_due(c.wear, *state.wear, w)) return;
  require_slow_growth(c.wear, *state.wear, w);
  WearState next = *state.wear;
  std::vector<bit::WearFlat> flats = w.flats;
  take_wear_step(w.solids, next, flats);
  bit::Bit worn = bit_at(c, next, w.solids);
  state.wear = std::move(next);
  w.flats = std::move(flats);
  const dynamics::DrillingSystem before = w.worn.drilling.system;
  wear_case(c, std::move(worn), w.worn);
  limit_growth(c, *state.wear, w);
  if (state.drive) carry_motion(before, w.worn.drilling.system, *state.drive);
  add(record_of(*state.wear, w), sim.statistics.wear);
  state.rock.near_lists.clear();  // they are by the parts that cut
  const bit::Bit now = state.started.empty() ? w.worn.bit : started_bit(w.worn.bit, state.started);
  std::optional<WearWork> wear = std::move(sim.work.wear);
  sim.work = start_work(wear->worn, state, rock::prepare_cutting_bit(now, c.update.cutting));
  sim.work.wear = std::move(wear);
}

void measure_wear(const Case& c, const Move& move, State& state, Work& work) {
  WearState& s = *state.wear;
  rub(c, move.X_WB1, work, *work.wear, s.rubs);
  const double time = c.wear.acceleration * move.dt;
  for (std::size_t i = 0; i < s.cutters.size(); ++i) {
    s.cutters[i].last = s.rubs[i].rate * time;
    s.cutters[i].window += s.cutters[i].last;
  }
  const double down = move.X_WB1.p.z() - move.X_WB0.p.z();
  s.window_time += time;
  ++s.window_steps;
  s.window_distance += down;
  s.distance += c.wear.acceleration * down;
}

}  // namespace tdbd::simulation
