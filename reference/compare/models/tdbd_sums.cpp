#include "reference/compare/models/tdbd_sums.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bit/cone/tracking.hpp"
#include "bit/cutter/cutter.hpp"
#include "reference/compare/models/roller_case.hpp"

namespace tdbd::reference {
namespace {

using simulation::CutOfPart;

/// Penetration at which the ring of a row is evaluated, typical of prints.
constexpr double usual_print = 1e-3;  // m

bool is_of_face(bit::PartKind kind) { return kind == bit::PartKind::face; }

/// The area that a step's cut sweeps in the half-plane through the axis: the area normal to the
/// motion, projected along the circle about the axis.
double area_in_half_plane(const forces::PartCut& cut) {
  const double along = cut.velocity.head<2>().norm();
  return along > 0.0 ? cut.cut_area * cut.velocity.norm() / along : 0.0;
}

/// Adds a cut to its piece and to the pieces that contain it.
void add_cut(const simulation::Case& c, const simulation::Simulation& s, const CutOfPart& cut,
             TdbdSums& sums) {
  const simulation::PartLoad& load = s.work.loads.parts[at(cut.part)];
  for (int i = sums.piece_of_part[at(cut.part)]; i >= 0; i = sums.pieces[at(i)].whole) {
    Piece& piece = sums.pieces[at(i)];
    piece.normal += load.normal;
    piece.drag += load.tangential;
    piece.weight -= load.force_W.z();
    piece.weight_now -= load.force_W.z();
    if (is_of_face(cut.cut.kind))
      piece.area += area_in_half_plane(
          simulation::cut_at(c.bit, s.state.place.X_WB, s.work.velocity, c.time.step, cut));
    if (cut.cut.kind == bit::PartKind::tooth) ++piece.contacts;
  }
}

void add_cuts(const simulation::Case& c, const simulation::Simulation& s, TdbdSums& sums) {
  for (Piece& piece : sums.pieces) piece.weight_now = 0.0;
  double teeth = 0.0;
  int last = -1;
  for (const CutOfPart& cut : s.work.cuts) {
    // A part that touches rock below and beside it has two consecutive cuts and one load.
    if (std::exchange(last, cut.part) == cut.part) continue;
    add_cut(c, s, cut, sums);
    if (cut.cut.kind == bit::PartKind::tooth) teeth += 1.0;
  }
  sums.teeth.push_back(teeth);
  for (Piece& piece : sums.pieces)
    piece.largest_weight = std::max(piece.largest_weight, piece.weight_now);
}

void add_backwards(const simulation::Case& c, const simulation::Simulation& s, TdbdSums& sums) {
  const Pose& X_WB = s.state.place.X_WB;
  for (const bit::Cutter& cutter : c.bit.cutters) {
    const Vec3 tip_W = X_WB * bit::tip_B(cutter);
    const Vec3 v_W = simulation::velocity_at(c.bit, X_WB, s.work.velocity, -1, tip_W);
    if (v_W.dot(X_WB.R * cutter.X_BC.R.col(0)) < 0.0) ++sums.backwards;
  }
}

int add_piece(TdbdSums& sums, const std::string& name, double radius, int whole) {
  Piece piece;
  piece.name = name;
  piece.radius = radius;
  piece.whole = whole;
  sums.pieces.push_back(piece);
  return static_cast<int>(sums.pieces.size()) - 1;
}

/// Adds a cone with its rows. The parts of the shell belong to the cone alone.
void start_cone(const simulation::Case& c, std::size_t k, TdbdSums& sums) {
  const bit::Cone& cone = c.bit.cones[k];
  const int whole = add_piece(sums, cone.name, 0.0, -1);
  std::vector<int> rows;
  for (std::size_t r = 0; r < cone.layout.rows.size(); ++r)
    rows.push_back(add_piece(sums, row_name(cone.name, r),
                             bit::print_ring(cone, cone.layout.rows[r], usual_print).radius,
                             whole));
  for (std::size_t p = 0; p < c.bit.parts.size(); ++p) {
    const bit::Part& part = c.bit.parts[p];
    if (part.cone != static_cast<int>(k)) continue;
    if (part.row < 0) {
      sums.piece_of_part[p] = whole;
      continue;
    }
    const int row = rows[at(part.row)];
    sums.piece_of_part[p] = add_piece(sums, part.name, sums.pieces[at(row)].radius, row);
  }
}

}  // namespace

TdbdSums start_sums(const simulation::Case& c) {
  TdbdSums sums;
  sums.series.step = c.time.step;
  sums.piece_of_part.assign(c.bit.parts.size(), -1);
  for (const bit::Cutter& cutter : c.bit.cutters)
    add_piece(sums, simulation::cutter_name(cutter), cutter.tip_radius, -1);
  for (std::size_t p = 0; p < c.bit.parts.size(); ++p)
    sums.piece_of_part[p] = c.bit.parts[p].cutter;
  for (std::size_t k = 0; k < c.bit.cones.size(); ++k) start_cone(c, k, sums);
  return sums;
}

void add_step(const simulation::Case& c, const simulation::Simulation& s, TdbdSums& sums) {
  const simulation::BitLoads& loads = s.work.loads;
  sums.series.weight.push_back(-loads.force_W.z());
  sums.series.torque.push_back(-loads.torque_W.z());
  const Vec3 force_B = s.state.place.X_WB.R.transpose() * loads.force_W;
  sums.lateral_B += force_B.head<2>();
  sums.side += force_B.head<2>().norm();
  sums.squares += s.state.place.X_WB.p.head<2>().squaredNorm();
  add_cuts(c, s, sums);
  add_backwards(c, s, sums);
}

std::vector<double> removed_by_piece(const TdbdSums& sums, const simulation::Simulation& s) {
  std::vector<double> removed(sums.pieces.size());
  for (std::size_t p = 0; p < sums.piece_of_part.size(); ++p)
    for (int i = sums.piece_of_part[p]; i >= 0; i = sums.pieces[at(i)].whole)
      removed[at(i)] += s.state.ledger.removed_by_part[p].value();
  return removed;
}

void set_piece_quantities(const simulation::Case& c, const TdbdSums& sums,
                          const std::vector<double>& volumes, Findings& f) {
  const double steps = static_cast<double>(sums.series.weight.size());
  for (std::size_t i = 0; i < sums.pieces.size(); ++i) {
    const Piece& piece = sums.pieces[i];
    const auto tell = [&](PartQuantity q, double value) {
      f.parts.push_back({piece.name, piece.radius, q, value});
    };
    tell(PartQuantity::volume_per_revolution, volumes[i]);
    tell(PartQuantity::force_into_rock, piece.normal / steps);
    tell(PartQuantity::drag, piece.drag / steps);
    if (c.bit.cones.empty()) {
      tell(PartQuantity::area, piece.area / steps);
      continue;
    }
    tell(PartQuantity::weight, piece.weight / steps);
    tell(PartQuantity::largest_weight, piece.largest_weight);
    tell(PartQuantity::teeth_in_contact, static_cast<double>(piece.contacts) / steps);
  }
}

}  // namespace tdbd::reference
