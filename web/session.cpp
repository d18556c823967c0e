#include "web/session.hpp"

#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "bit/bit.hpp"
#include "bit/report/bit_output.hpp"
#include "core/provenance.hpp"

namespace tdbd::web {
namespace {

using Json = nlohmann::ordered_json;

Json pose_json(const Pose& X) {
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) rows.push_back(X.R(i, k));
    rows.push_back(X.p(i));
  }
  return rows;
}

/// Of the bit, then of each cone.
Json poses_json(const Session& s) {
  Json poses = Json::array();
  const std::vector<double> angles = simulation::angles_of(s.state.state.cones);
  for (const Pose& X : bit::body_poses(s.of.bit, s.state.state.place.X_WB, angles, 0.0).X_WB)
    poses.push_back(pose_json(X));
  return poses;
}

bool has_loads(const Session& s) {
  return s.of.forces.forces == simulation::Forces::on && s.state.state.steps_done > s.of.time.first;
}

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double weight_on_bit(const Session& s) {
  return has_loads(s) ? -s.state.work.loads.force_W.z() : unknown;
}

double torque_on_bit(const Session& s) {
  return has_loads(s) ? -s.state.work.loads.torque_W.z() : unknown;
}

std::string facts_json(const Session& s) {
  Json parts = Json::array();
  for (const bit::Part& p : s.of.bit.parts)
    parts.push_back(
        {{"name", p.name}, {"kind", bit::kind_name(p.kind)}, {"body", bit::body_of(p)}});
  Json warnings = Json::array();
  for (const simulation::CaseWarning& w : s.of.warnings) warnings.push_back(with_place(w));
  const Json facts{{"title", s.of.bit.name},
                   {"case_hash", s.of.hash},
                   {"warnings", warnings},
                   {"resolved", s.of.resolved},
                   {"steps", s.of.time.steps},
                   {"step_s", s.of.time.step},
                   {"gage_radius_m", s.of.bit.gage_radius},
                   {"version", provenance().version},
                   {"commit", provenance().commit},
                   {"parts", parts}};
  return facts.dump();
}

std::string look_json(const Session& s) {
  const simulation::State& now = s.state.state;
  Json by_part = Json::array();
  for (const CompensatedSum& sum : now.ledger.removed_by_part) by_part.push_back(sum.value());
  const Json look{{"steps", now.steps_done},
                  {"done", now.steps_done >= s.of.time.steps},
                  {"time_s", simulation::time_at(s.of.time, now.steps_done)},
                  {"revolutions", (now.place.turned - now.start_turned) / (2.0 * std::numbers::pi)},
                  {"removed_m3", now.ledger.removed.value()},
                  {"removed_by_part_m3", by_part},
                  {"wob_n", weight_on_bit(s)},  // dump() writes what is no number as null
                  {"tob_n_m", torque_on_bit(s)},
                  {"triangles", now.rock.surface.triangle_count()},
                  {"poses", poses_json(s)}};
  return look.dump();
}

}  // namespace tdbd::web
