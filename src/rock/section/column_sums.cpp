#include "rock/section/column_sums.hpp"

#include <algorithm>
#include <bit>

#include "core/simd.hpp"

namespace tdbd::rock {
namespace {

/// A linear function on a piece of a column, given by its values at the ends.
struct Linear {
  double at0, at1;
};

/// A piece of a column.
struct Piece {
  double y0, y1;
};

double value_at(const Piece& p, const Linear& f, double y) {
  return f.at0 + (f.at1 - f.at0) * ((y - p.y0) / (p.y1 - p.y0));
}

/// Rounds to the nearest integer below 2^51: adding the constant puts the integer into the low bits
/// of the mantissa.
std::int64_t units(double x) {
  constexpr double shift = 6755399441055744.0;  // 1.5 * 2^52
  return std::bit_cast<std::int64_t>(x + shift) - std::bit_cast<std::int64_t>(shift);
}

void add_moments(const PolygonMoments& m, double sign, ColumnSums& sums) {
  sums.area += units(sign * sums.per_area * m.area);
  sums.moment_y += units(sign * sums.per_moment * m.moment.x());
  sums.moment_z += units(sign * sums.per_moment * m.moment.y());
}

/// Adds the region between z = lower and z = lower + h.
void add_trapezoid(const Piece& p, const Linear& lower, const Linear& h, double sign,
                   ColumnSums& sums) {
  const double w = sign * (p.y1 - p.y0), sum = h.at0 + h.at1;
  const double squares = h.at0 * h.at0 + h.at0 * h.at1 + h.at1 * h.at1;
  const double products = lower.at0 * (sum + h.at0) + lower.at1 * (sum + h.at1);
  sums.area += units(sums.per_area * 0.5 * w * sum);
  sums.moment_y += units(sums.per_moment * w / 6.0 * (p.y0 * (sum + h.at0) + p.y1 * (sum + h.at1)));
  sums.moment_z += units(sums.per_moment * w / 6.0 * (products + squares));
}

/// The parts of a piece with f <= 0 and f > 0. Either may be empty.
struct Split {
  Piece below, above;
};

Split split(const Piece& p, const Linear& f) {
  if (f.at0 <= 0.0 && f.at1 <= 0.0) return {p, {p.y1, p.y1}};
  if (f.at0 > 0.0 && f.at1 > 0.0) return {{p.y0, p.y0}, p};
  const double y = std::clamp(p.y0 + (p.y1 - p.y0) * (f.at0 / (f.at0 - f.at1)), p.y0, p.y1);
  if (f.at0 <= 0.0) return {{p.y0, y}, {y, p.y1}};
  return {{y, p.y1}, {p.y0, y}};
}

Linear restricted(const Piece& p, const Linear& f, const Piece& part) {
  return {value_at(p, f, part.y0), value_at(p, f, part.y1)};
}

/// Adds a part of edge i over column c, whose length is `length` per unit of y.
void add_engaged(const FaceColumn& c, const Piece& part, double length, std::size_t i,
                 ColumnSums& sums) {
  const double width = part.y1 - part.y0, middle = 0.5 * (part.y0 + part.y1) - c.y0;
  sums.engaged[i] += units(sums.per_length * length * width);
  sums.engaged_moment[i] += units(sums.per_length_moment * length * width * middle);
}

/// For a segment that is above the lower edge, edge i, along the whole piece.
void add_above_lower(const FaceColumn& c, const Piece& p, const Linear& lower, const Linear& h,
                     double sign, std::size_t i, std::size_t count, ColumnSums& sums) {
  add_engaged(c, p, sign * c.lower_length, i, sums);
  const Linear whole{c.upper + c.upper_slope * (p.y0 - c.y0) - lower.at0,
                     c.upper + c.upper_slope * (p.y1 - c.y0) - lower.at1};
  const Linear over{h.at0 - whole.at0, h.at1 - whole.at1};
  if (over.at0 <= 0.0 && over.at1 <= 0.0) return add_trapezoid(p, lower, h, sign, sums);
  const Split parts = split(p, over);
  if (parts.below.y0 < parts.below.y1)
    add_trapezoid(parts.below, restricted(p, lower, parts.below), restricted(p, h, parts.below),
                  sign, sums);
  add_trapezoid(parts.above, restricted(p, lower, parts.above), restricted(p, whole, parts.above),
                sign, sums);
  add_engaged(c, parts.above, sign * c.upper_length, count + i, sums);
}

void add_piece(const FaceColumn& c, const Piece& p, const Linear& segment, double sign,
               std::size_t i, std::size_t count, ColumnSums& sums) {
  const Linear lower{c.lower + c.lower_slope * (p.y0 - c.y0),
                     c.lower + c.lower_slope * (p.y1 - c.y0)};
  const Linear h{segment.at0 - lower.at0, segment.at1 - lower.at1};
  if (h.at0 <= 0.0 && h.at1 <= 0.0) return;
  if (h.at0 > 0.0 && h.at1 > 0.0) return add_above_lower(c, p, lower, h, sign, i, count, sums);
  const Piece part = split(p, h).above;
  if (part.y0 < part.y1)
    add_above_lower(c, part, restricted(p, lower, part), restricted(p, h, part), sign, i, count,
                    sums);
}

/// Adds the part of the vertical edge at y, edge i, that lies below a segment passing there.
void add_end(const FaceColumn& c, double y, const OutlineSegment& s, double sign, std::size_t i,
             ColumnSums& sums) {
  if ((s.from.x() <= y) == (s.to.x() <= y)) return;
  const double lower = c.lower + c.lower_slope * (y - c.y0),
               upper = c.upper + c.upper_slope * (y - c.y0);
  const double share = (y - s.from.x()) / (s.to.x() - s.from.x());
  const double z = s.from.y() + share * (s.to.y() - s.from.y());
  const double height = std::clamp(z, lower, std::max(lower, upper)) - lower;
  sums.engaged[i] += units(sums.per_length * sign * height);
  sums.engaged_moment[i] += units(sums.per_length_moment * sign * 0.5 * height * height);
}

/// Length and first moment of length, in units of ColumnSums.
struct EdgeUnits {
  std::int64_t length, moment;
};

/// The part of a column's lower edge to the left of y.
EdgeUnits lower_edge_to(const FaceColumn& c, double y, const ColumnSums& sums) {
  const double width = std::min(y, c.y1) - c.y0;
  return {units(sums.per_length * c.lower_length * width),
          units(sums.per_length_moment * c.lower_length * 0.5 * width * width)};
}

/// Adds the lower edge between y0, in column i0, and y1, in column i1.
void add_lower_edge(const FaceColumns& face, std::size_t i0, double y0, std::size_t i1, double y1,
                    std::int64_t sign, ColumnSums& sums) {
  for (std::size_t i = i0; i <= i1; ++i) {
    const FaceColumn& c = face.columns[i];
    const EdgeUnits before = i == i0 ? lower_edge_to(c, y0, sums) : EdgeUnits{0, 0},
                    to = lower_edge_to(c, y1, sums);
    sums.engaged[i] += sign * (to.length - before.length);
    sums.engaged_moment[i] += sign * (to.moment - before.moment);
  }
}

/// Adds the areas and moments of below_line of `segments` segments, a multiple of `lanes`, in
/// integer units; for the shift see units().
TDBD_WIDE void add_below(double bottom, const double* y, const double* z, std::size_t segments,
                         ColumnSums& sums) {
  constexpr double shift = 6755399441055744.0;  // 1.5 * 2^52
  constexpr std::int64_t zero = std::bit_cast<std::int64_t>(shift);
  WideLong area{}, moment_y{}, moment_z{};
  const auto add = [](const Wide& x, WideLong& sum) {
    const Wide shifted = x + shift;
    WideLong bits;
    TDBD_LOAD(bits, &shifted);
    sum += bits - zero;
  };
  for (std::size_t k = 0; k < segments; k += lanes) {
    Wide from_y, from_z, to_y, to_z;
    TDBD_LOAD(from_y, y + k);
    TDBD_LOAD(from_z, z + k);
    TDBD_LOAD(to_y, y + k + 1);
    TDBD_LOAD(to_z, z + k + 1);
    const Wide h0 = to_z - bottom, h1 = from_z - bottom, sum = h0 + h1, width = from_y - to_y;
    const Wide y_sum = to_y * (sum + h0) + from_y * (sum + h1);
    const Wide z_sum = 3.0 * bottom * sum + h0 * h0 + h0 * h1 + h1 * h1;
    add(sums.per_area * (0.5 * width * sum), area);
    add(sums.per_moment * (width / 6.0 * y_sum), moment_y);
    add(sums.per_moment * (width / 6.0 * z_sum), moment_z);
  }
  for (std::size_t l = 0; l < lanes; ++l) {
    sums.area += area[l];
    sums.moment_y += moment_y[l];
    sums.moment_z += moment_z[l];
  }
}

}  // namespace

void begin_sums(const FaceColumns& face, ColumnSums& sums) {
  constexpr double units_per_box = 1125899906842624.0;  // 2^50
  const Vec2 size = face.hi_F - face.lo_F;
  const double area = size.x() * size.y(),
               reach = std::max(face.lo_F.cwiseAbs().maxCoeff(), face.hi_F.cwiseAbs().maxCoeff());
  sums.area = sums.moment_y = sums.moment_z = 0;
  sums.engaged.assign(2 * face.columns.size() + 2, 0);
  sums.engaged_moment.assign(sums.engaged.size(), 0);
  sums.per_area = units_per_box / area;
  sums.per_moment = units_per_box / (area * reach);
  sums.per_length = units_per_box / (size.x() + size.y());
  sums.per_length_moment = sums.per_length / (size.x() + size.y());
}

void add_segment(const FaceColumns& face, std::size_t first, std::size_t end,
                 const OutlineSegment& s, ColumnSums& sums) {
  const std::size_t count = face.columns.size();
  const double sign = s.from.x() > s.to.x() ? 1.0 : -1.0;
  const Vec2 &left = sign > 0.0 ? s.to : s.from, &right = sign > 0.0 ? s.from : s.to;
  if (first == 0 && face.left_is_rim)
    add_end(face.columns.front(), face.lo_F.x(), s, sign, 2 * count, sums);
  if (end == count && face.right_is_rim)
    add_end(face.columns.back(), face.hi_F.x(), s, sign, 2 * count + 1, sums);
  const double begin = std::max(left.x(), face.columns[first].y0),
               stop = std::min(right.x(), face.columns[end - 1].y1);
  if (!(begin < stop)) return;
  const double slope = (right.y() - left.y()) / (right.x() - left.x());
  std::size_t i = std::max(first, face.near(begin));
  for (double y = begin; i < end && y < stop; ++i) {
    const FaceColumn& c = face.columns[i];
    if (c.y1 <= y) continue;
    const Piece p{y, std::min(stop, c.y1)};
    const Linear z{left.y() + slope * (p.y0 - left.x()), left.y() + slope * (p.y1 - left.x())};
    add_piece(c, p, z, sign, i, count, sums);
    y = p.y1;
  }
}

void add_inside(const FaceColumns& face, std::span<const double> y, std::span<const double> z,
                ColumnSums& sums) {
  const std::size_t segments = y.size() - 1, packed = segments / lanes * lanes;
  add_below(face.lo_F.y(), y.data(), z.data(), packed, sums);
  for (std::size_t k = packed; k < segments; ++k)
    add_moments(below_line(face.lo_F.y(), {y[k + 1], z[k + 1]}, {y[k], z[k]}), 1.0, sums);
  const double from = y.front(), to = y.back();
  const std::size_t i = face.holding(from), k = face.holding(to);
  add_moments(face.below_lower_edge(face.columns[i], from), -1.0, sums);
  add_moments(face.below_lower_edge(face.columns[k], to), 1.0, sums);
  if (to < from)
    add_lower_edge(face, k, to, i, from, 1, sums);
  else
    add_lower_edge(face, i, from, k, to, -1, sums);
}

namespace {

void raise(std::optional<double>& end, double z) { end = end ? std::max(*end, z) : z; }

/// The engaged interval of a column's lower edge, m from its start along y.
struct EngagedStretch {
  double from, to;
};

EngagedStretch engaged_stretch(const FaceColumn& c, double length, double middle) {
  const double half = 0.5 * length / c.lower_length, width = c.y1 - c.y0;
  return {std::clamp(middle - half, 0.0, width), std::clamp(middle + half, 0.0, width)};
}

}  // namespace

EngagedEnds engaged_ends(const FaceColumns& face, const ColumnSums& sums) {
  EngagedEnds ends;
  for (std::size_t i = 0; i < face.columns.size(); ++i) {
    const FaceColumn& c = face.columns[i];
    if (sums.engaged[i] <= 0 || !(c.lower_length > 0.0)) continue;
    const double length = static_cast<double>(sums.engaged[i]) / sums.per_length;
    const double middle =
        static_cast<double>(sums.engaged_moment[i]) / sums.per_length_moment / length;
    const EngagedStretch s = engaged_stretch(c, length, middle);
    const double left = c.lower + s.from * c.lower_slope, right = c.lower + s.to * c.lower_slope;
    if (c.lower_slope <= 0.0) raise(ends[0], left);
    if (c.lower_slope >= 0.0) raise(ends[1], right);
  }
  return ends;
}

}  // namespace tdbd::rock
