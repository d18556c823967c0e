#include "string/side_force.hpp"

#include <algorithm>
#include <cmath>

#include "core/types.hpp"

namespace tdbd::string {
namespace {

/// Depths at which the string is divided, ascending, from 0 to its end.
std::vector<double> cuts_of(const std::vector<Section>& sections, const Survey& survey,
                            const std::vector<FrictionBelow>& friction, int elements) {
  const double total = total_length(sections);
  std::vector<double> cuts;
  for (int i = 0; i <= 2 * elements; ++i) cuts.push_back(total * i / (2 * elements));
  double end = 0.0;
  for (const Section& s : sections) cuts.push_back(end += s.length);
  for (const Survey::Arc& a : survey.arcs) cuts.push_back(a.depth);
  for (const FrictionBelow& f : friction) cuts.push_back(f.depth);
  std::erase_if(cuts, [&](double x) { return x < 0.0 || x > total; });
  std::sort(cuts.begin(), cuts.end());
  const double equal = 1e-12 * total;
  cuts.erase(
      std::unique(cuts.begin(), cuts.end(), [&](double x, double y) { return y - x <= equal; }),
      cuts.end());
  return cuts;
}

FrictionBelow friction_at(const std::vector<FrictionBelow>& friction, double depth) {
  FrictionBelow here;
  for (const FrictionBelow& f : friction)
    if (depth >= f.depth) here = f;
  return here;
}

void add_piece(Contact& contact, const Survey& survey, const Span& span, int element, int node) {
  const double middle = 0.5 * (span.top + span.bottom);
  const Vec3 t = tangent_at(survey, middle);
  const Vec3 bend = tangent_at(survey, span.bottom) - tangent_at(survey, span.top);
  const Vec3 d = bend - bend.dot(t) * t;
  const double weight = span.section->weight * (span.bottom - span.top);
  const Vec3 n = weight * (Vec3::UnitZ() - t.z() * t);
  contact.a.push_back(d.squaredNorm());
  contact.b.push_back(d.dot(n));
  contact.c.push_back(n.squaredNorm());
  contact.element.push_back(element);
  contact.node.push_back(node);
}

/// The node that gets the friction of a piece around `node`.
int rubbing(int node, int elements) { return std::clamp(node, 1, std::max(elements - 1, 1)); }

/// Sums over the pieces of a node, weighted by length and by side force without tension.
struct Mean {
  double length = 0.0, pressed = 0.0;
  void add(double value, double part, double push) {
    length += value * part;
    pressed += value * push;
  }
};

/// Means for each node, weighted by side force, or by length if there is no side force.
std::vector<double> means(const std::vector<Mean>& sums, const std::vector<Mean>& ones) {
  std::vector<double> values;
  for (std::size_t i = 0; i < sums.size(); ++i)
    values.push_back(ones[i].pressed > 0.0  ? sums[i].pressed / ones[i].pressed
                     : ones[i].length > 0.0 ? sums[i].length / ones[i].length
                                            : 0.0);
  return values;
}

double press(const Contact& c, std::size_t piece, double tension) {
  return std::sqrt(std::max(0.0, (c.a[piece] * tension + 2.0 * c.b[piece]) * tension + c.c[piece]));
}

}  // namespace

Contact make_contact(const std::vector<Section>& sections, const Survey& survey,
                     const std::vector<FrictionBelow>& friction, int elements) {
  const double length = total_length(sections) / elements;
  Contact contact;
  contact.weight.assign(at(elements) + 1, 0.0);
  std::vector<Mean> radius(at(elements) + 1), resting = radius, sliding = radius, ones = radius;
  const std::vector<double> cuts = cuts_of(sections, survey, friction, elements);
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const double middle = 0.5 * (cuts[k] + cuts[k + 1]);
    const int element = std::clamp(static_cast<int>(middle / length), 0, elements - 1);
    const int cell = std::clamp(static_cast<int>(std::lround(middle / length)), 0, elements);
    const FrictionBelow here = friction_at(friction, middle);
    const double fall = position_at(survey, cuts[k + 1]).z() - position_at(survey, cuts[k]).z();
    for (const Span& s : spans_between(sections, cuts[k], cuts[k + 1])) {
      const std::size_t node = at(rubbing(cell, elements));
      const double part = s.bottom - s.top;
      contact.weight[at(cell)] += s.section->weight * fall * part / (cuts[k + 1] - cuts[k]);
      add_piece(contact, survey, s, element, static_cast<int>(node));
      const double push = std::sqrt(contact.c.back());
      radius[node].add(s.section->contact_radius, part, push);
      resting[node].add(here.resting, part, push);
      sliding[node].add(here.sliding, part, push);
      ones[node].add(1.0, part, push);
    }
  }
  contact.radius = means(radius, ones);
  contact.resting = means(resting, ones);
  contact.sliding = means(sliding, ones);
  return contact;
}

void side_forces(const Contact& c, const std::vector<double>& tension,
                 std::vector<double>& side_force) {
  std::fill(side_force.begin(), side_force.end(), 0.0);
  for (std::size_t p = 0; p < c.a.size(); ++p)
    side_force[at(c.node[p])] += press(c, p, tension[at(c.element[p])]);
}

double side_force_at(const Contact& c, int node, double above, double below) {
  // Pieces are sorted by node. Those of a node lie in its two elements, also next to the ends.
  const auto first = std::lower_bound(c.node.begin(), c.node.end(), node);
  double sum = 0.0;
  for (auto p = first; p != c.node.end() && *p == node; ++p) {
    const auto piece = static_cast<std::size_t>(p - c.node.begin());
    sum += press(c, piece, c.element[piece] < node ? above : below);
  }
  return sum;
}

}  // namespace tdbd::string
