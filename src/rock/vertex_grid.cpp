#include "rock/vertex_grid.hpp"

namespace tdbd::rock {

VertexGrid::VertexGrid(const mesh::Box& box_W, double cell)
    : lo_(box_W.lo), inverse_cell_(1.0 / cell) {
  const Vec3 n = box_W.size() * inverse_cell_;
  nx_ = 1 + static_cast<int>(n.x());
  ny_ = 1 + static_cast<int>(n.y());
  nz_ = 1 + static_cast<int>(n.z());
  head_.assign(
      static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_) * static_cast<std::size_t>(nz_),
      -1);
}

void VertexGrid::link(int v, int cell) {
  Link& l = links_[static_cast<std::size_t>(v)];
  int& head = head_[static_cast<std::size_t>(cell)];
  l = {head, -1, cell};
  if (head >= 0) links_[static_cast<std::size_t>(head)].previous = v;
  head = v;
}

void VertexGrid::insert(int v, const Vec3& x_W) {
  if (static_cast<std::size_t>(v) >= links_.size()) links_.resize(static_cast<std::size_t>(v) + 1);
  link(v, index(cell_at(x_W)));
}

void VertexGrid::remove(int v) {
  Link& l = links_[static_cast<std::size_t>(v)];
  if (l.previous >= 0)
    links_[static_cast<std::size_t>(l.previous)].next = l.next;
  else
    head_[static_cast<std::size_t>(l.cell)] = l.next;
  if (l.next >= 0) links_[static_cast<std::size_t>(l.next)].previous = l.previous;
  l = {};
}

void VertexGrid::move(int v, const Vec3& x_W) {
  const int cell = index(cell_at(x_W));
  if (cell == links_[static_cast<std::size_t>(v)].cell) return;
  remove(v);
  link(v, cell);
}

}  // namespace tdbd::rock
