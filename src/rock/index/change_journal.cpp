#include "rock/index/change_journal.hpp"

#include "core/wide.hpp"

namespace tdbd::rock {
namespace {

void note(ChangeJournal& j, int v, Single x, Single y, Single z) {
  if (j.v.size() == ChangeJournal::most) pass_over(j, 0);
  const std::size_t i = j.v.size();
  if (i % single_lanes == 0)
    for (auto* column : {&j.x, &j.y, &j.z}) column->resize(i + single_lanes, nowhere);
  j.v.push_back(v);
  j.x[i] = x;
  j.y[i] = y;
  j.z[i] = z;
}

}  // namespace

void note_place(ChangeJournal& journal, int v, const Vec3& x_W) {
  note(journal, v, static_cast<Single>(x_W.x()), static_cast<Single>(x_W.y()),
       static_cast<Single>(x_W.z()));
}

void note_removal(ChangeJournal& journal, int v) { note(journal, v, nowhere, nowhere, nowhere); }

void pass_over(ChangeJournal& journal, long changes) {
  journal.first = journal.end() + changes;
  if (journal.v.empty()) return;
  journal.v.clear();
  for (auto* column : {&journal.x, &journal.y, &journal.z}) column->clear();
}

}  // namespace tdbd::rock
