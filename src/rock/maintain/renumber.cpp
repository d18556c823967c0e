#include "rock/maintain/renumber.hpp"

#include <algorithm>

namespace tdbd::rock {
namespace {

/// Renumbers a list and drops vertices that were removed while they were listed.
void renumber_list(const std::vector<int>& number, std::vector<int>& vertices) {
  std::size_t kept = 0;
  for (const int v : vertices)
    if (number[at(v)] >= 0) vertices[kept++] = number[at(v)];
  vertices.resize(kept);
}

/// Renumbers the vertices in Rock::carried, pressed and left. Removed vertices are dropped.
void renumber_contacts(const std::vector<int>& number, Rock& rock) {
  for (CarriedDisplacement& c : rock.carried) {
    c.v = number[at(c.v)];
    for (int& v : c.from) v = number[at(v)];
  }
  for (std::vector<PressedVertex>& part : rock.pressed) {
    std::erase_if(part, [&](PressedVertex& p) { return (p.v = number[at(p.v)]) < 0; });
    std::ranges::sort(part, {}, &PressedVertex::v);
  }
  std::erase_if(rock.left, [&](LeftVertex& l) { return (l.v = number[at(l.v)]) < 0; });
  std::ranges::sort(rock.left, comes_before);
}

}  // namespace

void renumber(Rock& rock, double cube, RenumberWork& work) {
  order_of_space(rock.surface, cube, work.placed, work.order);
  mesh::renumber(rock.surface, work.order, work.mesh);
  mesh::take_in_order(work.order, rock.last_part, work.parts);
  mesh::take_in_order(work.order, rock.touched, work.mesh.bytes);
  mesh::take_in_order(work.order, rock.moved_in, work.moved_in);
  rock.notes.of.assign(rock.surface.stars.size(), 0);  // rings begin at other neighbours now
  renumber_list(work.mesh.number, rock.touched_list);
  renumber_contacts(work.mesh.number, rock);
  rock.grid.renumber(work.mesh.number, rock.surface.vertex_slots(), work.blocks);
}

}  // namespace tdbd::rock
