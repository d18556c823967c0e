#include "dynamics/drilling/resisted_flow.hpp"

#include "dynamics/drilling/stability.hpp"
#include "dynamics/drilling/wall_secants.hpp"
#include "dynamics/momenta.hpp"

namespace tdbd::dynamics {
namespace {

using Complex = std::complex<double>;
constexpr int wall_directions = 3;

/// Allocates columns for all dampers that the system may have, and for the wall.
void set_sizes(const DrillingSystem& s, FlowWork& w) {
  const int n = freedoms(s), most = n + 1 + wall_directions;
  if (w.directions.rows() == n && w.directions.cols() == most) return;
  w.directions.setZero(n, most);
  w.mobile.setZero(n, most);
  w.mobility.setZero(most, most);
  for (Eigen::VectorXd* v : {&w.momenta, &w.start, &w.pushed, &w.change, &w.mean}) v->setZero(n);
  for (Eigen::VectorXd* v :
       {&w.coefficients, &w.end_speeds, &w.speeds, &w.pushes, &w.impulses, &w.lags, &w.losses})
    v->setZero(most);
  w.entries.assign(at(most), nullptr);
}

/// Adds a direction of the bit. Returns its column.
int add_direction(const Direction& d, double coefficient, double EnergyLedger::*entry,
                  FlowWork& w) {
  const int i = w.resisting++;
  w.directions.col(i).setZero();
  w.directions.col(i).head<3>() = d.force_W;
  w.directions.col(i).segment<3>(3) = d.torque_W;
  w.coefficients[i] = coefficient;
  w.end_speeds[i] = 0.0;
  w.entries[at(i)] = entry;
  return i;
}

/// Whether the rate of the top is part of the state.
bool top_follows_bit(const DrillingSystem& s) {
  return s.string.damper_end == DamperEnd::top && s.top.axial == AxialMode::load &&
         s.top.following_time > 0.0;
}

/// Rate of the upper end of the dampers of the string, m/s along +z.
double rate_of_damper_end(const DrillingSystem& s, const DrillingState& state) {
  if (s.string.damper_end == DamperEnd::space) return 0.0;
  return top_follows_bit(s) ? state.top_rate : value_at(s.top.rate, state.rotation.time);
}

void add_string_dampers(const DrillingSystem& s, const Configuration& at,
                        const DrillingState& state, FlowWork& w) {
  const bool turns = s.string.damper_end == DamperEnd::top;
  const double rate = rate_of_damper_end(s, state);
  const double speed = turns ? value_at(s.top.speed, state.rotation.time) : 0.0;
  for (const PrincipalDamper& d : s.dampers) {
    if (d.coefficient == 0.0) continue;
    const Direction direction{d.axis_W, at.pull.arm_W.cross(d.axis_W)};
    const int i = add_direction(direction, d.coefficient, &EnergyLedger::damped_string, w);
    w.end_speeds[i] = rate * d.axis_W.z();
  }
  for (const PrincipalDamper& d : s.turn_dampers) {
    if (d.coefficient == 0.0) continue;
    const Direction direction{Vec3::Zero(), d.axis_W};
    const int i = add_direction(direction, d.coefficient, &EnergyLedger::damped_string, w);
    w.end_speeds[i] = speed * d.axis_W.z();
  }
}

void add_other_dampers(const DrillingSystem& s, FlowWork& w) {
  const int cones = cones_of(s);
  const auto add = [&](int freedom, double coefficient, double EnergyLedger::*entry) {
    if (coefficient == 0.0) return;
    const int i = add_direction({}, coefficient, entry, w);
    w.directions(freedom, i) = 1.0;
  };
  for (int k = 0; k < cones; ++k)
    add(6 + k, s.bearing_damping[at(k)], &EnergyLedger::damped_bearings);
  if (s.rock.mass > 0.0) add(6 + cones, s.rock.damping, &EnergyLedger::damped_rock);
}

void add_wall(const WallContact& contact, FlowWork& w) {
  const std::array<Direction, 3> d = contact_directions(contact);
  add_direction(d[0], 0.0, &EnergyLedger::wall_friction, w);
  add_direction(d[1], 0.0, &EnergyLedger::wall_friction, w);
  add_direction(d[2], 0.0, &EnergyLedger::wall_loss, w);
}

/// Projects momenta and forces onto the directions.
void project(const DrillingSystem& s, const Configuration& at, FlowWork& w) {
  const int q = w.resisting;
  velocities_of(s, at, w.momenta, w.start);
  velocities_of(s, at, w.force, w.pushed);
  for (int i = 0; i < q; ++i) velocities_of(s, at, w.directions.col(i), w.mobile.col(i));
  for (int i = 0; i < q; ++i) {
    w.speeds[i] = w.directions.col(i).dot(w.start) - w.end_speeds[i];
    w.pushes[i] = w.directions.col(i).dot(w.pushed);
    for (int j = 0; j < q; ++j) w.mobility(i, j) = w.directions.col(i).dot(w.mobile.col(j));
  }
}

/// Mean product of two modes over the time, for the integrals of the losses. It is computed from
/// the values at the ends if the modes are damped enough, otherwise by Gauss's rule, whose error is
/// then below rounding.
double mean_product(const FlowWork& w, double z_k, double z_l, int k, int l) {
  const double z = z_k + z_l;
  if (std::abs(z) > 0.5)
    return (w.mode_start[k] * w.mode_start[l] - w.mode_end[k] * w.mode_end[l] +
            w.mode_push[k] * w.mode_mean[l] + w.mode_mean[k] * w.mode_push[l]) /
           z;
  return gauss_mean([&](double x) {
    const auto value = [&](double z_i, int i) {
      const FlowFunctions f = flow_functions(z_i * x);
      return f.decay * w.mode_start[i] + x * f.mean * w.mode_push[i];
    };
    return value(z_k, k) * value(z_l, l);
  });
}

/// Computes the modes, unless they are those of the previous call: the flows of a step share their
/// geometry.
void find_modes(FlowWork& w) {
  if (w.decomposed.rows() == w.scaled.rows() && w.decomposed == w.scaled) return;
  w.modes.compute(w.scaled);
  w.decomposed = w.scaled;
}

/// Exact flow of the dampers, by the modes of sqrt(c) A^T M^-1 A sqrt(c).
void exponential(double time, FlowWork& w) {
  const int q = w.dampers;
  w.scales = w.coefficients.head(q).cwiseSqrt();
  w.scaled.resize(q, q);
  for (int i = 0; i < q; ++i)
    for (int j = 0; j < q; ++j) w.scaled(i, j) = w.scales[i] * w.mobility(i, j) * w.scales[j];
  find_modes(w);
  const Eigen::MatrixXd& V = w.modes.eigenvectors();
  w.mode_start.noalias() = V.transpose() * w.scales.cwiseProduct(w.speeds.head(q));
  w.mode_push.noalias() = V.transpose() * (time * w.scales.cwiseProduct(w.pushes.head(q)));
  w.mode_end.resize(q);
  w.mode_mean.resize(q);
  w.mode_lag.resize(q);
  for (int k = 0; k < q; ++k) {
    const FlowFunctions f = flow_functions(w.modes.eigenvalues()[k] * time);
    const double a = w.mode_start[k], b = w.mode_push[k];
    w.mode_end[k] = f.decay * a + f.mean * b;
    w.mode_mean[k] = f.mean * a + f.second * b;
    w.mode_lag[k] = (2.0 * f.second - f.mean) * a + (2.0 * f.third - f.second) * b;
  }
  w.impulses.head(q).noalias() = V * w.mode_mean;
  w.lags.head(q).noalias() = V * w.mode_lag;
  w.impulses.head(q).array() *= -time * w.scales.array();
  w.lags.head(q).array() *= time * w.scales.array();
}

/// Integrals of c v^2 over the flow computed by exponential().
void damper_losses(double time, FlowWork& w) {
  const int q = w.dampers;
  const Eigen::MatrixXd& V = w.modes.eigenvectors();
  w.products.resize(q, q);
  for (int k = 0; k < q; ++k)
    for (int l = 0; l <= k; ++l)
      w.products(k, l) = w.products(l, k) =
          mean_product(w, w.modes.eigenvalues()[k] * time, w.modes.eigenvalues()[l] * time, k, l);
  for (int i = 0; i < q; ++i) {
    double sum = 0.0;
    for (int k = 0; k < q; ++k)
      for (int l = 0; l < q; ++l) sum += V(i, k) * w.products(k, l) * V(i, l);
    w.losses[i] = time * sum;
  }
}

/// Eliminates the dampers from the equations of the Lobatto method, so that only the wall remains.
/// With S = sqrt(c time),
///   (1 - i + S G S) S h = S g - S G_w (g_t, g_t, g_r) time h_w.
WallResponse eliminate_dampers(double time, FlowWork& w) {
  const int q = w.dampers;
  const Complex factor(1.0, -1.0);
  WallResponse r;
  r.gain = w.mobility.block<3, 3>(q, q).cast<Complex>();
  r.free = factor * w.speeds.segment<3>(q) + time * w.pushes.segment<3>(q).cast<Complex>();
  if (q > 0) {
    w.scales = (time * w.coefficients.head(q)).cwiseSqrt();
    w.damped.resize(q, q);
    w.answers.resize(q, 1 + wall_directions);
    for (int i = 0; i < q; ++i) {
      for (int j = 0; j < q; ++j)
        w.damped(i, j) = w.scales[i] * w.mobility(i, j) * w.scales[j] + (i == j ? factor : 0.0);
      w.answers(i, 0) = w.scales[i] * (factor * w.speeds[i] + time * w.pushes[i]);
      for (int j = 0; j < wall_directions; ++j)
        w.answers(i, 1 + j) = w.scales[i] * w.mobility(i, q + j);
    }
    w.solver.compute(w.damped);
    w.stages.resize(q);
    for (int j = 0; j <= wall_directions; ++j) {
      w.stages = w.answers.col(j);
      w.answers.col(j) = w.solver.solve(w.stages);
    }
    for (int i = 0; i < wall_directions; ++i)
      for (int k = 0; k < q; ++k) {
        const double coupling = w.mobility(q + i, k) * w.scales[k];
        r.free[i] -= coupling * w.answers(k, 0);
        for (int j = 0; j < wall_directions; ++j) r.gain(i, j) -= coupling * w.answers(k, 1 + j);
      }
  }
  r.free /= factor;
  r.gain *= time / factor;
  return r;
}

/// Complex stage values h of every direction. The two stages of the method are Re h - Im h and Re h
/// + Im h, the end.
void lobatto(const WallLaw& law, double time, FlowWork& w) {
  const int q = w.dampers;
  const WallResponse response = eliminate_dampers(time, w);
  const WallSecants g = find_wall_secants(law, response, w.speeds.segment<3>(q));
  const Eigen::Vector3cd h_w = contact_speeds(response, g);
  w.coefficients.segment<3>(q) = Vec3(g.slip, g.slip, g.radial);
  const auto take = [&](int i, const Complex& h) {
    const double c = w.coefficients[i] * time;
    w.impulses[i] = -c * h.real();
    w.lags[i] = -c * h.imag();
    w.losses[i] = c * std::norm(h);
  };
  for (int i = 0; i < q; ++i) {
    Complex h = w.answers(i, 0);
    for (int j = 0; j < wall_directions; ++j)
      h -= w.answers(i, 1 + j) * (time * w.coefficients[q + j]) * h_w[j];
    take(i, h / w.scales[i]);
  }
  for (int j = 0; j < wall_directions; ++j) take(q + j, h_w[j]);
}

/// Distributes the numerical loss of the Lobatto method, l^T A^T M^-1 A l / 2, over the directions
/// in proportion to their losses at the stages.
void share_method_loss(FlowWork& w) {
  const int q = w.resisting;
  double beside = 0.0;
  for (int i = 0; i < q; ++i)
    for (int j = 0; j < q; ++j) beside += 0.5 * w.lags[i] * w.mobility(i, j) * w.lags[j];
  const double sum = w.losses.head(q).sum();
  if (sum > 0.0) w.losses.head(q) *= 1.0 + std::max(beside, 0.0) / sum;
}

void record(const FlowWork& w, EnergyLedger& ledger) {
  for (int i = 0; i < w.resisting; ++i) {
    ledger.*w.entries[at(i)] += w.losses[i];
    ledger.top += w.impulses[i] * w.end_speeds[i];
  }
}

WallLaw wall_law(const Wall& wall, double depth) {
  const double spring = mean_wall_stiffness(wall) * depth;
  return {wall.friction, wall.slip_speed, spring, wall.stiffness * depth - spring};
}

}  // namespace

std::array<Direction, 3> contact_directions(const WallContact& c) {
  return {Direction{c.tangent_W, c.touch_arm_W.cross(c.tangent_W)},
          Direction{Vec3::UnitZ(), c.touch_arm_W.cross(Vec3::UnitZ())},
          Direction{c.outward_W, c.ring_arm_W.cross(c.outward_W)}};
}

void follow_bit(const DrillingSystem& s, const Configuration& at, double time,
                DrillingState& state) {
  if (!top_follows_bit(s)) return;
  const Vec3 w_W = at.mobility_W * (state.rotation.momentum_W -
                                    at.R_WB * cone_momentum_sum(s.gyrostat, state.rotation));
  const double speed = state.momentum_W.z() / s.mass + w_W.cross(at.pull.arm_W).z();
  state.top_rate -= (speed - state.top_rate) * std::expm1(-time / s.top.following_time);
}

bool wall_resists(const Wall& wall) { return wall.friction > 0.0 || wall.restitution < 1.0; }

void resisted_flow(const DrillingSystem& s, const Configuration& at, double time,
                   DrillingState& state, EnergyLedger* ledger, FlowWork& w) {
  set_sizes(s, w);
  w.resisting = 0;
  add_string_dampers(s, at, state, w);
  add_other_dampers(s, w);
  w.dampers = w.resisting;
  const bool rubs = at.contact.depth > 0.0 && wall_resists(s.wall);
  if (rubs) add_wall(at.contact, w);
  momenta_column(s, state, w.momenta);
  project(s, at, w);
  if (rubs) {
    lobatto(wall_law(s.wall, at.contact.depth), time, w);
    share_method_loss(w);
  } else if (w.dampers > 0) {
    exponential(time, w);
  }
  if (ledger != nullptr) {
    if (!rubs && w.dampers > 0) damper_losses(time, w);
    record(w, *ledger);
  }
  w.change = time * w.force;
  w.mean = w.start + 0.5 * time * w.pushed;
  for (int i = 0; i < w.resisting; ++i) {
    w.change += w.impulses[i] * w.directions.col(i);
    w.mean += 0.5 * (w.impulses[i] - w.lags[i]) * w.mobile.col(i);
  }
  add_impulse_column(s, w.change, state);
}

}  // namespace tdbd::dynamics
