#include "simulation/step/wear_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "bit/bit.hpp"
#include "bit/cone/cone_measures.hpp"
#include "dynamics/momenta.hpp"
#include "simulation/step/drive.hpp"
#include "simulation/step/step.hpp"
#include "simulation/step/wear.hpp"

namespace tdbd::simulation {

namespace {

std::string worn_out(const bit::WearSolid& s) {
  if (s.cutter >= 0) return fmt::format("the flat of {} is as large as the cutter", s.name);
  return fmt::format("{} has lost {:.3g} mm of its {:.3g} mm", s.name, 1e3 * s.largest,
                     1e3 * s.size);
}

double extrapolated(double window, double previous, double ratio) {
  return std::max(0.0, window + 0.5 * ratio * (window - ratio * previous));
}

}  // namespace

WearAmount worn_after(const WearState& s, const PieceWear& c, const WearAmount& window,
                      double time) {
  const double ratio = s.previous_time > 0.0 ? time / s.previous_time : 0.0;
  return {extrapolated(window.volume, c.previous.volume, ratio),
          extrapolated(window.height, c.previous.height, ratio)};
}

std::optional<bit::WearFlat> flat_after(const bit::WearSolid& solid, const PieceWear& c,
                                        const WearAmount& worn) {
  double volume = c.volume + worn.volume;
  if (worn.height > 0.0) {
    const auto half = bit::flat_of_volume(solid, c.volume + 0.5 * worn.volume, c.height);
    if (!half || half->height + worn.height >= solid.largest) return std::nullopt;
    volume = bit::flat_at(solid, half->height + worn.height).volume + 0.5 * worn.volume;
  }
  return bit::flat_of_volume(solid, volume, c.height);
}

void take_wear_step(const std::vector<bit::WearSolid>& solids, WearState& s,
                    std::vector<bit::WearFlat>& flats) {
  std::vector<bit::WearFlat> next;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const PieceWear& c = s.pieces[i];
    const auto flat = flat_after(solids[i], c, worn_after(s, c, c.window, s.window_time));
    if (!flat)
      throw WearEnd(
          fmt::format("{}; it had lost {:.4g} mm3 before", worn_out(solids[i]), 1e9 * c.volume));
    next.push_back(*flat);
  }
  for (std::size_t i = 0; i < solids.size(); ++i) {
    PieceWear& c = s.pieces[i];
    c.volume = next[i].volume;
    c.height = next[i].height;
    c.previous = std::exchange(c.window, {});
  }
  flats = std::move(next);
  s.previous_time = std::exchange(s.window_time, 0.0);
  s.window_steps = 0;
  s.window_distance = s.window_weight = s.window_torque = 0.0;
  ++s.steps;
}

double wear_ledger_defect(const bit::Bit& fresh, const bit::Bit& worn,
                          const std::vector<bit::WearSolid>& solids, const WearState& s) {
  double beyond = 0.0, worn_volume = 0.0, by_meshes = 0.0;
  for (std::size_t i = 0; i < s.pieces.size(); ++i) {
    const double volume = s.pieces[i].volume;
    if (!(volume > 0.0)) continue;
    const bit::LostVolume lost = bit::lost_volume(fresh, worn, solids[i], s.pieces[i].height);
    beyond += std::abs(lost.beyond_flat - volume);
    worn_volume += volume;
    by_meshes = std::max(by_meshes, std::abs(lost.by_meshes - volume) / lost.whole);
  }
  return std::max(worn_volume > 0.0 ? beyond / worn_volume : 0.0, by_meshes);
}

void add(WearRecord record, WearRecords& to) {
  constexpr std::size_t most = 64;
  if (to.seen++ % to.every != 0) return;
  to.records.push_back(std::move(record));
  if (to.records.size() <= most) return;
  for (std::size_t i = 2; i < to.records.size(); i += 2)
    to.records[i / 2] = std::move(to.records[i]);
  to.records.resize((to.records.size() + 1) / 2);
  to.every *= 2;
}

namespace {

/// A wear step is due if a flat has grown by this share of the largest growth. The rest is a
/// reserve for the next time step.
constexpr double due_share = 0.5;

double most_growth(const WearPlan& plan, const bit::WearSolid& solid) {
  return plan.largest_growth * solid.size;
}

/// Computes how far flats may grow from now on.
void limit_growth(const WearPlan& plan, const WearState& s, WearWork& w) {
  w.due.clear();
  for (std::size_t i = 0; i < w.solids.size(); ++i) {
    const double growth = due_share * most_growth(plan, w.solids[i]);
    const bit::WearFlat flat = bit::flat_at(w.solids[i], s.pieces[i].height + growth);
    w.due.push_back({flat.volume - s.pieces[i].volume, growth});
  }
}

/// Whether the next step could make a flat too large if it wears at most twice as much as the last
/// one. The flat grows with its height, so the shares of both kinds of wear may be added.
bool next_step_may_exceed_growth(const WearState& s, const WearWork& w) {
  constexpr double care = 2.0;
  const double step = s.window_time / static_cast<double>(s.window_steps);
  for (std::size_t i = 0; i < s.pieces.size(); ++i) {
    const PieceWear& c = s.pieces[i];
    const WearAmount ahead = worn_after(
        s, c, {c.window.volume + care * c.last.volume, c.window.height + care * c.last.height},
        s.window_time + step);
    if (ahead.volume / w.due[i].volume + ahead.height / w.due[i].height > 1.0) return true;
  }
  return false;
}

bool is_wear_due(const WearPlan& plan, const WearState& s, const WearWork& w) {
  if (s.window_steps == 0) return false;
  return (plan.every_steps > 0 && s.window_steps >= plan.every_steps) ||
         (plan.every > 0.0 && s.window_distance >= plan.every) || next_step_may_exceed_growth(s, w);
}

void require_slow_growth(const WearPlan& plan, const WearState& s, const WearWork& w) {
  for (std::size_t i = 0; i < s.pieces.size(); ++i) {
    const PieceWear& c = s.pieces[i];
    const auto flat = flat_after(w.solids[i], c, worn_after(s, c, c.window, s.window_time));
    const double reached = flat ? flat->height : w.solids[i].largest;
    if (reached - c.height > most_growth(plan, w.solids[i]))
      throw WearEnd(fmt::format(
          "wear.acceleration: found {:g}, with which the flat of {} grows in a window of {} "
          "time steps by more than {:g} of its {} (wear.largest_growth); expected a smaller "
          "acceleration or a larger growth",
          plan.acceleration, w.solids[i].name, s.window_steps, plan.largest_growth,
          w.solids[i].cutter >= 0 ? "diameter" : "size"));
  }
}

/// The bit of the case with flats at the heights of the state.
bit::Bit bit_at(const Case& c, const WearState& s, const std::vector<bit::WearSolid>& solids) {
  bit::Bit worn = c.bit;
  for (std::size_t i = 0; i < s.pieces.size(); ++i)
    if (s.pieces[i].height > solids[i].start)
      bit::wear_piece(c.bit, solids[i], s.pieces[i].height, worn);
  return worn;
}

/// The case with a worn bit. In free motion mass, centre and inertia are updated; the string, its
/// slack position and its moving mass do not change.
void wear_case(const Case& c, bit::Bit worn, Case& to) {
  to.bit = std::move(worn);
  if (c.motion.kind != MotionKind::drilling) return;
  const bit::MassProperties fresh = bit::mass_properties(c.bit), now = bit::mass_properties(to.bit);
  dynamics::DrillingSystem& system = to.drilling.system;
  system.mass = c.drilling.system.mass - (fresh.mass - now.mass);
  system.centre_B = now.centre;
  std::vector<dynamics::Cone> cones = c.drilling.system.gyrostat.cones;
  for (std::size_t k = 0; k < cones.size(); ++k)
    cones[k].axial_inertia = bit::cone_mass(to.bit, static_cast<int>(k)).axial_inertia;
  system.gyrostat = dynamics::make_gyrostat(
      c.drilling.system.gyrostat.inertia_B - (fresh.inertia - now.inertia), cones);
  to.drilling.start.c_W = c.drilling.start.c_W + (now.centre - fresh.centre);
}

/// Continues the motion with the mass of the worn bit. Pose and velocities do not change; momenta
/// and the last wrench are converted to the new centre of mass, and the initial energy of the
/// ledger is adjusted.
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
  for (std::size_t k = 0; k < now.gyrostat.cones.size(); ++k) {
    const dynamics::Cone& cone = now.gyrostat.cones[k];
    s.rotation.cone_momenta[k] = cone.axial_inertia * (v.cone_rates[k] + cone.axis_B.dot(w_B));
  }
  s.rotation.momentum_W = s.rotation.q_WB * (now.gyrostat.carrier_B * w_B +
                                             dynamics::cone_momentum_sum(now.gyrostat, s.rotation));
  d.wrench.torque_W -= shift_W.cross(d.wrench.force_W);
  d.ledger.start +=
      dynamics::total(dynamics::stored_energy(now, dynamics::drilling_work(now, d).at, s)) - stored;
}

/// Friction on a piece: forces, power and areas of its bearing parts.
struct Rubbing {
  double force = 0.0, power = 0.0;     ///< N, W
  double area = 0.0, body_area = 0.0;  ///< m2, in total, and of the body
};

std::vector<Rubbing> rubbing_of(const bit::Bit& bit, const Work& work, const WearWork& w,
                                const std::vector<double>& speeds) {
  std::vector<Rubbing> rubbing(w.solids.size());
  const auto bears = [&](std::size_t p) {
    return w.piece_of_part[p] >= 0 && bit.parts[p].kind != bit::PartKind::face;
  };
  for (const CutOfPart& cut : work.cuts) {
    if (!bears(at(cut.part))) continue;
    const bit::Part& part = bit.parts[at(cut.part)];
    Rubbing& r = rubbing[at(w.piece_of_part[at(cut.part)])];
    r.area += cut.cut.contact_area;
    if (part.kind == bit::PartKind::cutter_body) r.body_area += cut.cut.contact_area;
  }
  for (std::size_t p = 0; p < speeds.size(); ++p) {
    if (!bears(p)) continue;
    Rubbing& r = rubbing[at(w.piece_of_part[p])];
    const double force = std::max(0.0, work.loads.parts[p].normal);
    r.force += force;
    r.power += force * speeds[p];
  }
  return rubbing;
}

/// Speed relative to the rock of each part that wears and bears a load, m/s.
std::vector<double> part_speeds(const bit::Bit& bit, const Pose& X_WB, const Work& work,
                                const WearWork& w) {
  std::vector<double> speeds(work.loads.parts.size(), 0.0);
  for (std::size_t p = 0; p < speeds.size(); ++p)
    if (w.piece_of_part[p] >= 0 && work.loads.parts[p].normal > 0.0)
      speeds[p] =
          velocity_at(bit, X_WB, work.velocity, bit.parts[p].cone, work.loads.parts[p].point_W)
              .norm();
  return speeds;
}

/// Share of a part's wear that its bearing flat loses.
double flat_share(const Case& c, std::size_t part, const Work& work, const Rubbing& r) {
  const bit::Part& p = c.bit.parts[part];
  if (!has_measured_flat(c.forces, c.bit, p) || !(r.body_area > 0.0)) return 0.0;
  const double area = work.measures.sections[at(p.cutter)].flat_area;
  return area > 0.0 ? std::min(1.0, area / r.body_area) : 0.0;
}

void rub(const Case& c, const Pose& X_WB, const Work& work, const WearWork& w,
         std::vector<PieceRub>& rubs) {
  const std::vector<double> speeds = part_speeds(c.bit, X_WB, work, w);
  const std::vector<Rubbing> rubbing = rubbing_of(c.bit, work, w, speeds);
  rubs.assign(w.solids.size(), {});
  for (std::size_t i = 0; i < rubs.size(); ++i) {
    const Rubbing& r = rubbing[i];
    const double speed = r.force > 0.0 ? r.power / r.force : 0.0;
    rubs[i].temperature =
        bit::flat_temperature(c.wear.heating, {r.force, speed, r.area, w.flats[i].length});
  }
  for (std::size_t p = 0; p < speeds.size(); ++p) {
    if (!(speeds[p] > 0.0)) continue;
    const std::size_t piece = at(w.piece_of_part[p]);
    PieceRub& on = rubs[piece];
    const double force = work.loads.parts[p].normal;
    on.force += force;
    const double rate = bit::wear_rate(c.wear.part_laws[p], {force, speeds[p], on.temperature});
    on.rate += rate;
    on.flat_rate += flat_share(c, p, work, rubbing[piece]) * rate;
  }
}

/// Record after a wear step. `before` is the state before it, with its window.
WearRecord record_of(const WearPlan& plan, const WearState& before, const WearState& s,
                     const WearWork& w) {
  WearRecord r;
  r.distance = s.distance;
  r.weight = before.window_weight / before.window_time;
  r.torque = before.window_torque / before.window_time;
  r.rate = plan.acceleration * before.window_distance / before.window_time;
  for (std::size_t i = 0; i < s.pieces.size(); ++i) {
    r.height.push_back(w.flats[i].height);
    r.width.push_back(w.flats[i].width);
    r.volume.push_back(s.pieces[i].volume);
    r.temperature.push_back(s.rubs[i].temperature);
    r.force.push_back(s.rubs[i].force);
  }
  return r;
}

}  // namespace

std::vector<bit::WearSolid> solids_of(const Case& c) {
  std::vector<std::uint8_t> wears;
  for (const bit::WearLaw& law : c.wear.part_laws)
    wears.push_back(std::holds_alternative<bit::NoWear>(law) ? 0 : 1);
  return bit::wear_solids(c.bit, wears);
}

std::optional<WearState> start_wear(const Case& c) {
  if (!wears(c.wear)) return std::nullopt;
  WearState s;
  for (const bit::WearSolid& solid : solids_of(c)) s.pieces.push_back({.height = solid.start});
  s.rubs.resize(s.pieces.size());
  return s;
}

std::optional<WearWork> wear_work(const Case& c, const State& state) {
  if (!state.wear) return std::nullopt;
  WearWork w;
  w.solids = solids_of(c);
  w.piece_of_part.assign(c.bit.parts.size(), -1);
  for (std::size_t i = 0; i < w.solids.size(); ++i)
    for (const int p : w.solids[i].parts) w.piece_of_part[at(p)] = static_cast<int>(i);
  w.worn = c;
  wear_case(c, bit_at(c, *state.wear, w.solids), w.worn);
  for (std::size_t i = 0; i < w.solids.size(); ++i)
    w.flats.push_back(bit::flat_at(w.solids[i], state.wear->pieces[i].height));
  limit_growth(c.wear, *state.wear, w);
  return w;
}

namespace {

void take_wear_step(const Case& c, Simulation& sim) {
  State& state = sim.state;
  WearWork& w = *sim.work.wear;
  require_slow_growth(c.wear, *state.wear, w);
  WearState next = *state.wear;
  std::vector<bit::WearFlat> flats = w.flats;
  take_wear_step(w.solids, next, flats);
  bit::Bit worn = bit_at(c, next, w.solids);
  const WearState last = std::exchange(*state.wear, std::move(next));
  w.flats = std::move(flats);
  const dynamics::DrillingSystem before = w.worn.drilling.system;
  wear_case(c, std::move(worn), w.worn);
  limit_growth(c.wear, *state.wear, w);
  if (state.drive) carry_motion(before, w.worn.drilling.system, *state.drive);
  add(record_of(c.wear, last, *state.wear, w), sim.statistics.wear);
  state.rock.near_lists.clear();  // they are stored per group of cutting parts
  const bit::Bit now = state.started.empty() ? w.worn.bit : started_bit(w.worn.bit, state.started);
  std::optional<WearWork> wear = std::move(sim.work.wear);
  sim.work = start_work(wear->worn, state, rock::prepare_cutting_bit(now, c.update.cutting));
  sim.work.wear = std::move(wear);
}

}  // namespace

void wear_if_due(const Case& c, Simulation& s) {
  if (is_wear_due(c.wear, *s.state.wear, *s.work.wear)) take_wear_step(c, s);
}

void wear_at_end(const Case& c, Simulation& s) {
  if (s.work.wear && s.state.wear->window_steps > 0) take_wear_step(c, s);
}

void measure_wear(const Case& c, const Move& move, State& state, Work& work) {
  WearState& s = *state.wear;
  rub(c, move.X_WB1, work, *work.wear, s.rubs);
  if (time_at(c.time, state.steps_done - c.time.first) < c.wear.from) return;
  const double time = c.wear.acceleration * move.dt;
  for (std::size_t i = 0; i < s.pieces.size(); ++i) {
    PieceWear& worn = s.pieces[i];
    const PieceRub& rub = s.rubs[i];
    const double area = work.wear->flats[i].area;
    worn.last = {(rub.rate - rub.flat_rate) * time,
                 rub.flat_rate > 0.0 ? rub.flat_rate * time / area : 0.0};
    worn.window.volume += worn.last.volume;
    worn.window.height += worn.last.height;
  }
  const double down = move.X_WB1.p.z() - move.X_WB0.p.z();
  s.window_time += time;
  ++s.window_steps;
  s.window_distance += down;
  s.window_weight -= work.loads.force_W.z() * time;
  s.window_torque -= work.loads.torque_W.z() * time;
  s.distance += c.wear.acceleration * down;
}

}  // namespace tdbd::simulation
