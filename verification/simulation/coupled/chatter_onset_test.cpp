#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <numbers>

#include "core/temporary_file.hpp"
#include "mesh/files/files.hpp"
#include "simulation/step/simulation.hpp"
#include "verification/simulation/mesh_bit.hpp"

/// A bit of four equal blades drills at the end of a chain. Its cutters cut what the blade ahead
/// left, so its axial motion grows if it is damped too little (regenerative chatter). A prescribed
/// motion measures what the rock does to small motions of the bit; together with the waves of a
/// continuous rod, solved in closed form, that determines the damping at which chatter begins, and
/// how fast it grows.
namespace tdbd::simulation::chatter_onset_test {
namespace {

using Complex = std::complex<double>;

constexpr double turn_time = 0.5;   // s, at 120 rpm
constexpr double rate = 10e-3;      // m/s
constexpr double step_time = 1e-3;  // s
constexpr double bit_mass = 1e4;    // kg, of what is rigid with it
constexpr double length = 500.0;    // m of pipe
constexpr double mud = 0.1;         // 1/s, damping of the chain per mass
constexpr double young = 206e9, density = 7850.0;
const double area = std::numbers::pi / 4.0 * (0.127 * 0.127 - 0.1086 * 0.1086);  // m2

/// Four blades with a flat face and a rounded gage, so that no face is covered.
std::filesystem::path write_bit() {
  const auto folder = bit::test_folder();
  std::string table =
      "bit,cutter,blade,zone,dia_mm,r_tip_mm,phi_deg,h_tip_mm,"
      "profile_angle_deg,back_rake_deg,side_rake_deg\n";
  int cutter = 0;
  for (int blade = 0; blade < 4; ++blade)
    for (const auto& [radius, height, angle] : {std::array{6.0, 0.0, 0.0},
                                                {17.0, 0.0, 0.0},
                                                {28.0, 0.0, 0.0},
                                                {39.0, 0.0, 0.0},
                                                {47.0, 2.5, 35.0},
                                                {52.0, 7.0, 65.0}})
      table += fmt::format("four,{},{},nose,16,{},{},{},{},15,0\n", ++cutter, blade + 1, radius,
                           90 * blade, height, angle);
  write_file(folder / "four.csv", table);
  write_file(folder / "four.toml",
             "name = \"four\"\ntable = \"four.csv\"\ngage_diameter = \"112 mm\"\n"
             "[cutters]\nchamfer = \"0 mm\"\nlength = \"6 mm\"\n");
  return folder;
}

Case read(const std::filesystem::path& folder, const std::string& rock, const std::string& motion,
          double duration) {
  const std::string text = fmt::format(
      "[bit]\nfile = \"four.toml\"\n[rock]\nmaterial = \"berea-sandstone\"\n{}[motion]\n{}[time]\n"
      "step = {}\nduration = {}\n[measure]\nsection_at_face = \"extrapolated\"\n"
      "[forces]\nlaw = \"detournay\"\neps = \"60 MPa\"\nzeta = 0.6\n",
      rock, motion, step_time, duration);
  return read_case(write_file(folder / "case.toml", text), {});
}

std::string leg(double seconds, double speed) {
  return fmt::format(
      "[[motion.legs]]\nduration = {}\nrotary_speed = \"120 rpm\"\nvelocity = [0, 0, {}]\n",
      seconds, speed);
}

/// The loads of the second half of a turn at the rate, when every blade cuts what the one ahead left.
struct Bottom {
  double weight = 0.0, torque = 0.0;  ///< N, N m
};

/// The weight of a turn with another rate over that with the rate: the change by the change of rate, N s/m.
struct Response {
  std::vector<double> after;  ///< at 1, 2, ... steps from the change
};

std::vector<double> weights(const Case& c, const std::filesystem::path& rock, Bottom* bottom) {
  std::vector<double> found;
  Simulation s = start(c);
  const long turn = std::lround(turn_time / step_time);
  while (s.state.steps_done < c.time.steps) {
    step(c, s);
    const double weight = -s.work.loads.force_W.z(), torque = -s.work.loads.torque_W.z();
    const long at = s.state.steps_done;
    if (at > turn) found.push_back(weight);
    if (bottom == nullptr || at > turn || at <= turn / 2) continue;
    bottom->weight += 2.0 * weight / static_cast<double>(turn);
    bottom->torque += 2.0 * torque / static_cast<double>(turn);
    if (at == turn) mesh::write_mesh(rock, mesh::compact(s.state.rock.surface));
  }
  return found;
}

/// Of depths of cut that change by 20 %.
Response response(const std::filesystem::path& folder, double edge, Bottom& bottom) {
  constexpr double change = 0.2 * rate;
  const std::string rock = fmt::format("edge_length = {}\nwall = \"30 mm\"\n", edge);
  const auto run = [&](double speed, Bottom* b) {
    const Case c =
        read(folder, rock, "kind = \"legs\"\n" + leg(turn_time, rate) + leg(turn_time, speed),
             2.0 * turn_time);
    return weights(c, folder / "bottom.ply", b);
  };
  const std::vector<double> steady = run(rate, &bottom), faster = run(rate + change, nullptr);
  Response r;
  for (std::size_t i = 0; i < steady.size(); ++i)
    r.after.push_back((faster[i] - steady[i]) / change);
  return r;
}

/// What the rock pushes back for a motion exp(s t) of the bit: s^2 times the Laplace transform of the
/// response, which stays at its last value once all blades cut what was cut at the new rate.
Complex of_rock(const Response& r, Complex s) {
  constexpr double settled = 0.17;  // s; a blade follows the one ahead in 0.125 s
  const auto n = static_cast<std::size_t>(std::lround(settled / step_time));
  Complex sum = 0.0;
  for (std::size_t i = 0; i < n; ++i)
    sum += r.after[i] * std::exp(-s * step_time * (static_cast<double>(i) + 0.5)) * step_time;
  double last = 0.0;
  for (std::size_t i = n; i < r.after.size(); ++i) last += r.after[i];
  last /= static_cast<double>(r.after.size() - n);
  return s * s * (sum + last * std::exp(-s * settled) / s);
}

/// On exact rock: the weight jumps, since cutters that go down faster cut in a steeper direction, rises in
/// proportion to time until a blade cuts what was cut at the new rate, and stays at what was measured.
Response on_exact_rock(const Response& measured) {
  constexpr double eps = 60e6, blades = 4.0, delay = turn_time / blades;
  constexpr double turning = 2.0 * std::numbers::pi / turn_time;
  double width_over_radius = 0.0;  // of the cutters of a blade, mm of rock that each clears
  for (const auto& [width, radius] :
       {std::pair{11.5, 6.0}, {11.0, 17.0}, {11.0, 28.0}, {9.5, 39.0}, {6.5, 47.0}, {7.0, 52.0}})
    width_over_radius += width / radius;
  const double jump = blades * eps * rate * delay * width_over_radius / turning;
  double last = 0.0;
  const std::size_t n = measured.after.size(), half = n / 2;
  for (std::size_t i = half; i < n; ++i) last += measured.after[i] / static_cast<double>(n - half);
  Response r;
  for (std::size_t i = 0; i < n; ++i) {
    const double share = std::min(1.0, step_time * (static_cast<double>(i) + 0.5) / delay);
    r.after.push_back(jump + share * (last - jump));
  }
  return r;
}

/// The continuous rod below a top that does not move: E A k coth(k L), k^2 = rho (s^2 + mud s)/E.
Complex of_rod(Complex s) {
  const Complex k = std::sqrt(density * (s * s + mud * s) / young);
  return young * area * k / std::tanh(k * length);
}

/// The root of m s^2 + c s + rod + rock near 6.4 Hz: growth and circular frequency, 1/s.
Complex root(const Response& r, double damping) {
  const auto f = [&](Complex s) {
    return bit_mass * s * s + damping * s + of_rod(s) + of_rock(r, s);
  };
  Complex s(0.0, 40.0);
  constexpr double apart = 1e-5, enough = 1e-9;
  for (int i = 0; i < 50; ++i) {
    const Complex change = f(s) * 2.0 * apart / (f(s + apart) - f(s - apart));
    s -= change;
    if (std::abs(change) < enough) return s;
  }
  ADD_FAILURE() << "no root at " << damping << " N s/m";
  return s;
}

/// The bit's axial motion beside a steady one, m, from the bottom of a turn at the rate. The string
/// carries more than it needs at the start, which sets the bit in motion.
std::vector<double> drilled(const std::filesystem::path& folder, double edge, const Bottom& b,
                            double damping, double duration) {
  constexpr double kick = 6000.0;  // N
  const std::string rock = fmt::format(
      "shape = \"file\"\nfile = \"bottom.ply\"\nunit = \"1 m\"\nedge_length = {}\n", edge);
  // A flywheel keeps the bit's rotary speed, and stiff springs its axis.
  const std::string motion = fmt::format(
      "kind = \"drilling\"\nstart = [0, 0, {}]\nrotary_speed = \"120 rpm\"\n"
      "rate_of_penetration = {}\nweight_at_start = {}\ntorque_at_start = {}\n"
      "[string]\nmodel = \"chain\"\nelement_length = \"10 m\"\nmass = {}\ntorsional_inertia = 1e6\n"
      "bending_inertia = 1e6\nlateral_stiffness = 5e8\nlateral_damping = 2e6\n"
      "bending_stiffness = 1e9\nbending_damping = 1e7\naxial_damping = {}\ndampers_to = \"space\"\n"
      "attachment_height = 0\n[string.friction]\naxial_damping = {}\n[[string.sections]]\nlength = "
      "{}\n"
      "outer_diameter = 0.127\ninner_diameter = 0.1086\n",
      rate * turn_time, rate, b.weight + kick, b.torque, bit_mass, damping, mud, length);
  const Case c = read(folder, rock, motion, duration);
  Simulation s = start(c);
  std::vector<double> beside;
  const double from = s.state.drive->state.c_W.z();
  while (s.state.steps_done < c.time.steps) {
    step(c, s);
    const double t = time_at(c.time, s.state.steps_done);
    beside.push_back(s.state.drive->state.c_W.z() - from - rate * t);
  }
  return beside;
}

/// Growth and circular frequency, 1/s, of the part of a motion near a circular frequency: the slopes of
/// the logarithm of its amplitudes over whole periods.
Complex growth(const std::vector<double>& motion, double frequency) {
  const double period = 2.0 * std::numbers::pi / frequency;
  constexpr double first = 0.8;  // s: the chain's other modes have decayed
  const double end = step_time * static_cast<double>(motion.size());
  double n = 0.0, x = 0.0, xx = 0.0;
  Complex y = 0.0, xy = 0.0, before = 0.0;
  for (double t = first; t + period < end; t += period) {
    const auto from = static_cast<std::size_t>(t / step_time),
               to = static_cast<std::size_t>((t + period) / step_time);
    double mean = 0.0;
    for (std::size_t i = from; i < to; ++i) mean += motion[i] / static_cast<double>(to - from);
    Complex amplitude = 0.0;
    for (std::size_t i = from; i < to; ++i)
      amplitude += (motion[i] - mean) *
                   std::exp(Complex(0.0, -frequency * step_time * static_cast<double>(i + 1)));
    Complex logarithm = std::log(amplitude);
    const double whole = 2.0 * std::numbers::pi;
    if (n > 0.0)
      logarithm.imag(logarithm.imag() -
                     whole * std::round((logarithm.imag() - before.imag()) / whole));
    before = logarithm;
    n += 1.0;
    x += t;
    xx += t * t;
    y += logarithm;
    xy += t * logarithm;
  }
  return (n * xy - x * y) / (n * xx - x * x) + Complex(0.0, frequency);
}

struct Onset {
  double theory = 0.0, run = 0.0, exact_rock = 0.0;  ///< damping at the bit, N s/m
};

/// By the line through the growths at two dampings.
double onset(const std::array<double, 2>& damping, const std::array<Complex, 2>& s) {
  return damping[0] + (damping[1] - damping[0]) * s[0].real() / (s[0].real() - s[1].real());
}

Onset find_onset(double edge) {
  const auto folder = write_bit();
  Bottom bottom;
  const Response r = response(folder, edge, bottom);
  const std::array damping{1.7e5, 2.3e5};
  std::array<Complex, 2> theory, run;
  for (std::size_t i = 0; i < 2; ++i) {
    theory[i] = root(r, damping[i]);
    run[i] = growth(drilled(folder, edge, bottom, damping[i], 4.0), theory[i].imag());
    fmt::print(
        "edge {:.1f} mm, damping {:.0f} N s/m: growth {:+.3f} (theory {:+.3f}) 1/s, {:.3f} "
        "({:.3f}) Hz\n",
        1e3 * edge, damping[i], run[i].real(), theory[i].real(),
        run[i].imag() / (2.0 * std::numbers::pi), theory[i].imag() / (2.0 * std::numbers::pi));
  }
  const Response exact = on_exact_rock(r);
  const std::array exact_roots{root(exact, damping[0]), root(exact, damping[1])};
  const Onset found{onset(damping, theory), onset(damping, run), onset(damping, exact_roots)};
  fmt::print("edge {:.1f} mm: onset {:.0f}, theory {:.0f}, exact rock {:.0f} N s/m\n", 1e3 * edge,
             found.run, found.theory, found.exact_rock);
  return found;
}

TEST(ChatterOnset, of_four_blades_on_a_chain_is_that_of_the_delay_equation) {
  constexpr double safety = 1.25,
                   largest = 0.15;  // of a difference between two edges; of the onset
  const Onset fine = find_onset(2e-3), coarse = find_onset(2.8e-3);
  const double uncertainty = safety * std::abs(coarse.run - fine.run);
  EXPECT_NEAR(fine.run, fine.theory, uncertainty);
  EXPECT_LT(uncertainty, largest * fine.theory);
  // Both come from sections ahead of the faces: with shorter edges they come nearer to exact rock.
  constexpr double by_sections = 0.4;  // of the onset
  const double off = std::abs(fine.theory - fine.exact_rock);
  EXPECT_LT(off, std::abs(coarse.theory - coarse.exact_rock));
  EXPECT_LT(off, by_sections * fine.exact_rock);
}

}  // namespace
}  // namespace tdbd::simulation::chatter_onset_test
