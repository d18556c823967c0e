#include "simulation/result/history.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "core/error.hpp"

namespace tdbd::simulation {
namespace {

bool is_of_nodes(const RecordLayout& layout, const RecordColumn& c) {
  return c.axis >= 0 && layout.axes[at(c.axis)].name == "node";
}

/// Columns that a row of many steps has a minimum and a maximum of: what it has means of, of the
/// bit as a whole and of the string's nodes.
bool has_extremes(const RecordLayout& layout, const RecordColumn& c) {
  return (c.axis < 0 || is_of_nodes(layout, c)) && c.over == Over::mean;
}

std::string since_last_row(std::string long_name) {
  const std::string step = "in the step";
  if (const auto at = long_name.find(step); at != std::string::npos)
    long_name.replace(at, step.size(), "since the last row");
  return long_name;
}

/// Most numbers of a row are of parts and cutters. In long runs they are kept to seven digits; cones
/// turn far, so that their angles need all.
bool takes_much_room(const RecordLayout& layout, const RecordColumn& c) {
  return c.axis >= 0 && layout.axes[at(c.axis)].name != "cone" && !is_of_nodes(layout, c);
}

/// The columns of rows that stand for many steps, or for one.
RecordLayout row_layout(RecordLayout layout, Rows rows) {
  const std::vector<RecordColumn> of_step = layout.columns;
  for (RecordColumn& c : layout.columns) {
    if (rows == Rows::of_steps) c.over = Over::point;
    if (rows == Rows::of_windows) c.long_name = since_last_row(c.long_name);
    if (rows == Rows::of_windows && takes_much_room(layout, c)) c.precision = Precision::single;
  }
  if (rows == Rows::of_steps) return layout;
  layout.storage = Storage::deflated;
  for (const RecordColumn& c : of_step) {
    if (!has_extremes(layout, c)) continue;
    layout.columns.push_back(
        {c.name + "_min", c.units, c.long_name + ", least", c.axis, c.csv, Over::minimum});
    layout.columns.push_back(
        {c.name + "_max", c.units, c.long_name + ", greatest", c.axis, c.csv, Over::maximum});
  }
  return layout;
}

/// Calls visit(column, first number, count) for every column.
template <class Visit>
void visit_columns(const RecordLayout& layout, Visit&& visit) {
  std::size_t first = 0;
  for (const RecordColumn& c : layout.columns) {
    const std::size_t count = layout.width(c);
    visit(c, first, count);
    first += count;
  }
}

void take_up(const std::vector<double>& step, HistoryWindow& w) {
  if (w.steps++ == 0) {
    w.sum = w.least = w.greatest = step;
    return;
  }
  for (std::size_t i = 0; i < step.size(); ++i) {
    w.sum[i] += step[i];
    w.least[i] = std::fmin(w.least[i], step[i]);  // what is not known counts in no extreme
    w.greatest[i] = std::fmax(w.greatest[i], step[i]);
  }
}

/// The row of a window whose last step is given.
void row_of_window(const RecordLayout& steps, const std::vector<double>& last,
                   const HistoryWindow& w, std::vector<double>& row) {
  row = last;
  visit_columns(steps, [&](const RecordColumn& c, std::size_t first, std::size_t count) {
    for (std::size_t i = first; i < first + count; ++i) {
      if (c.over == Over::sum) row[i] = w.sum[i];
      if (c.over == Over::mean) row[i] = w.sum[i] / static_cast<double>(w.steps);
    }
  });
  visit_columns(steps, [&](const RecordColumn& c, std::size_t first, std::size_t count) {
    if (!has_extremes(steps, c)) return;
    for (const std::vector<double>* all : {&w.least, &w.greatest}) {
      const auto from = all->begin() + static_cast<std::ptrdiff_t>(first);
      row.insert(row.end(), from, from + static_cast<std::ptrdiff_t>(count));
    }
  });
}

}  // namespace

History::History(const std::filesystem::path& path, const std::vector<HistoryPart>& parts,
                 const HistoryExtent& extent, Rows rows)
    : extent_(extent),
      rows_(rows),
      steps_(step_layout(parts, extent)),
      layout_(row_layout(steps_, rows)),
      record_(path, layout_) {}

void History::take(const HistoryRow& step) {
  numbers_of(step, extent_, numbers_);
  if (numbers_.size() != steps_.row_width())
    throw RunError(fmt::format("a step of {} numbers in a history of {}", numbers_.size(),
                               steps_.row_width()));
  if (rows_ == Rows::of_windows)
    take_up(numbers_, window_);
  else
    window_.steps = 1;
}

bool History::write() {
  if (window_.steps == 0) return false;
  if (rows_ == Rows::of_windows)
    row_of_window(steps_, numbers_, window_, row_);
  else
    row_ = numbers_;
  window_.steps = 0;
  record_.append(row_);
  return true;
}

void History::close() { record_.close(); }

}  // namespace tdbd::simulation
