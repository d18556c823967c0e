#include "rock/index/change_journal.hpp"

#include "core/wide.hpp"

namespace tdbd::rock {
namespace {

void note(VertexChanges& c, int v, Single x, Single y, Single z) {
  const std::size_t i = c.v.size();
  if (i % single_lanes == 0)
    for (auto* column : {&c.x, &c.y, &c.z}) column->resize(i + single_lanes, nowhere);
  c.v.push_back(v);
  c.x[i] = x;
  c.y[i] = y;
  c.z[i] = z;
}

}  // namespace

void note_place(VertexChanges& changes, int v, const Vec3& x_W) {
  note(changes, v, static_cast<Single>(x_W.x()), static_cast<Single>(x_W.y()),
       static_cast<Single>(x_W.z()));
}

void note_removal(VertexChanges& changes, int v) { note(changes, v, nowhere, nowhere, nowhere); }

void clear(VertexChanges& changes) {
  changes.v.clear();
  for (auto* column : {&changes.x, &changes.y, &changes.z}) column->clear();
}

void pass_over(ChangeJournal& journal, long changes) {
  journal.first = journal.end() + changes;
  if (!journal.changes.v.empty()) clear(journal.changes);
}

void keep_bounded(ChangeJournal& journal) {
  if (journal.changes.v.size() >= ChangeJournal::most) pass_over(journal, 0);
}

}  // namespace tdbd::rock
