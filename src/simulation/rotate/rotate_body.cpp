#include "simulation/rotate/rotate_body.hpp"

#include <fmt/format.h>

#include <cmath>

#include "bit/bit.hpp"
#include "bit/files/part_keys.hpp"
#include "bit/files/unit_question.hpp"
#include "core/error.hpp"
#include "core/tolerance.hpp"
#include "dynamics/momenta.hpp"
#include "mesh/files/files.hpp"
#include "rotation/screw.hpp"
#include "simulation/case/rotate_keys.hpp"

namespace tdbd::simulation {
namespace {

using dynamics::InertiaCheck;

/// rad. Around this angle, adjacent doubles are still only about a thousandth of a turn apart.
constexpr double most_turned = 1e13;

/// Computes the inertia of a solid of uniform density about its centre of mass, along the axes of
/// its file.
Mat3 read_mesh_inertia(Config& c) {
  const std::string file = c.read(body_keys::mesh);
  const double density = c.read(body_keys::density);
  const double unit = c.read(body_keys::unit);
  if (file.empty()) return Mat3::Identity();
  try {
    const mesh::TriangleMesh m = mesh::read_mesh(file, unit);
    const std::size_t mistakes = c.problem_count();
    const std::string mesh_key(body_keys::mesh);
    bit::report_mesh_faults(c, mesh_key, file, {{"body", m}},
                            "a closed mesh whose triangles face outward");
    if (c.read(body_keys::unit_check))
      bit::unit_error(c, std::string(body_keys::unit), m, unit, bit::body_along);
    if (c.problem_count() == mistakes) return bit::mass_properties(m, density).inertia;
  } catch (const InputError& e) {
    c.problem(body_keys::mesh, e.what(), "a mesh that can be read");
  }
  return Mat3::Identity();
}

/// Reads an inertia tensor, or a mesh with a density.
Mat3 read_inertia(Config& c) {
  if (!c.has(body_keys::mesh)) return c.read(body_keys::inertia);
  if (c.has(body_keys::inertia)) {
    c.read(body_keys::inertia);
    c.problem(body_keys::inertia, "mesh as well", "one of the two");
  }
  return read_mesh_inertia(c);
}

/// Returns how far a matrix deviates from a rotation.
double rotation_defect(const Mat3& R) {
  const double defect = (R.transpose() * R - Mat3::Identity()).cwiseAbs().maxCoeff();
  return R.determinant() > 0.0 ? defect : std::max(defect, 2.0);
}

/// Reads the attitude, bit to space: a rotation vector or a matrix.
Mat3 read_attitude(Config& c) {
  if (!c.has(body_keys::attitude)) {
    const Vec3 r = c.read(body_keys::rotation_vector);
    if (r.stableNorm() <= most_turned) return rotation::exp(r);
    c.problem(body_keys::rotation_vector, fmt::format("an angle of {:.3g} rad", r.stableNorm()),
              fmt::format("at most {:.0e} rad, beyond which no digit of an attitude is left",
                          most_turned));
    return Mat3::Identity();
  }
  const Mat3 R = c.read(body_keys::attitude);
  if (c.has(body_keys::rotation_vector)) {
    c.read(body_keys::rotation_vector);
    c.problem(body_keys::attitude, "rotation_vector as well", "one of the two");
  } else if (const double defect = rotation_defect(R); defect > tolerance::rotation) {
    c.problem(body_keys::attitude, fmt::format("a matrix that misses a rotation by {:.3g}", defect),
              fmt::format("a rotation to {}", tolerance::rotation));
    return Mat3::Identity();
  }
  return R;
}

/// Cones and their initial state.
struct Cones {
  std::vector<dynamics::Cone> cones;
  std::vector<double> spins, angles;
};

Cones read_cones(Config& c) {
  Cones all;
  for (Config cone : c.tables(cone_keys::table)) {
    const Vec3 axis = cone.read(cone_keys::axis);
    if (!(axis.norm() > 0.0))
      cone.problem(cone_keys::axis, fmt::format("an axis of length {}", axis.norm()),
                   "a direction");
    all.cones.push_back({axis, cone.read(cone_keys::axial_inertia)});
    all.spins.push_back(cone.read(cone_keys::spin));
    all.angles.push_back(cone.read(cone_keys::angle));
  }
  return all;
}

/// Records the inertia problem `why` at the key that causes it: that of the body alone, of one cone
/// alone, or of all cones together.
void report_inertia_problem(Config& c, const std::string& why, const Mat3& inertia,
                            const std::vector<dynamics::Cone>& cones, InertiaCheck check) {
  const std::string expected =
      check == InertiaCheck::on
          ? "what a body can have (body.check = \"off\" admits the inertias of published "
            "benchmarks that no body has)"
          : "a positive definite inertia, also without the cones' axial inertias";
  if (const std::string alone = dynamics::inertia_problem(inertia, {}, check); !alone.empty())
    return c.problem(c.has("body.mesh") ? "body.mesh" : "body.inertia", alone, expected);
  for (std::size_t k = 0; k < cones.size(); ++k)
    if (const std::string one = dynamics::inertia_problem(inertia, {cones[k]}, check); !one.empty())
      return c.problem(fmt::format("cones[{}].axial_inertia", k),
                       fmt::format("{} kg m2: {}", cones[k].axial_inertia, one), expected);
  c.problem("cones", why, expected);
}

/// Records, at the key that causes it, that the energy at the start is not finite.
void report_infinite_energy(Config& c, const dynamics::Gyrostat& body, const Vec3& w_B,
                            const std::vector<double>& spins) {
  constexpr const char* found = "a kinetic energy that is not finite";
  constexpr const char* expected = "numbers whose squares and inverses are numbers";
  if (!std::isfinite(w_B.squaredNorm())) return c.problem("body.angular_velocity", found, expected);
  for (std::size_t k = 0; k < spins.size(); ++k) {
    if (!std::isfinite(spins[k] * spins[k]))
      return c.problem(fmt::format("cones[{}].spin", k), found, expected);
    if (!std::isfinite(1.0 / body.cones[k].axial_inertia))
      return c.problem(fmt::format("cones[{}].axial_inertia", k), found, expected);
  }
  c.problem(c.has("body.mesh") ? "body.mesh" : "body.inertia", found, expected);
}

}  // namespace

BodyStart read_body_start(Config& c) {
  const std::size_t mistakes = c.problem_count();
  Config body = c.table(body_keys::table);
  const Mat3 inertia = read_inertia(body);
  const InertiaCheck check = body.read(body_keys::check);
  const Mat3 R_WB = read_attitude(body);
  const Vec3 w_B = body.read(body_keys::angular_velocity);
  const Cones cones = read_cones(c);
  if (c.problem_count() != mistakes) return {};
  if (const std::string why = dynamics::inertia_problem(inertia, cones.cones, check);
      !why.empty()) {
    report_inertia_problem(c, why, inertia, cones.cones, check);
    return {};
  }
  BodyStart start{dynamics::make_gyrostat(inertia, cones.cones, check), {}};
  start.state = dynamics::make_state(start.body, R_WB, w_B, cones.spins, cones.angles);
  if (!std::isfinite(dynamics::kinetic_energy(start.body, start.state)))
    report_infinite_energy(c, start.body, w_B, cones.spins);
  return start;
}

}  // namespace tdbd::simulation
