// What JavaScript calls. Texts and arrays belong to the program until the next call that makes such a one.

#include <emscripten.h>

#include <array>
#include <fstream>
#include <string>
#include <vector>

#include "bit/report/bit_output.hpp"
#include "core/error.hpp"
#include "mesh/files/ply.hpp"
#include "mesh/surface.hpp"
#include "simulation/start/rock_start.hpp"
#include "simulation/step/step.hpp"
#include "web/session.hpp"

namespace tdbd::web {
namespace {

std::optional<Session> session;
std::string text;

/// Numbers of a mesh: places (m), corners, and one number for each vertex or triangle.
struct MeshArrays {
  std::vector<double> positions;
  std::vector<int> triangles, numbers;
};
MeshArrays shown;

/// Calls act; what it throws becomes the text, and the answer -1.
template <class Act>
int guarded(Act&& act) {
  try {
    return act();
  } catch (const std::exception& e) {
    text = error_message_of(e);
    return -1;
  }
}

void show(const mesh::TriangleMesh& m, std::vector<int> numbers) {
  shown.positions.clear();
  shown.triangles.clear();
  for (const Vec3& x : m.positions)
    shown.positions.insert(shown.positions.end(), {x.x(), x.y(), x.z()});
  for (const mesh::Triangle& t : m.triangles)
    shown.triangles.insert(shown.triangles.end(), {t[0], t[1], t[2]});
  shown.numbers = std::move(numbers);
}

const char* kept(std::string made) {
  text = std::move(made);
  return text.c_str();
}

}  // namespace
}  // namespace tdbd::web

using namespace tdbd;
using namespace tdbd::web;

extern "C" {

/// Reads a case and builds its rock. 0, or -1 with what is wrong in tdbd_text().
EMSCRIPTEN_KEEPALIVE int tdbd_start(const char* path) {
  session.reset();
  return guarded([&] {
    simulation::Case c = simulation::read_case(path, {});
    simulation::Simulation s = simulation::start(c);
    session.emplace(Session{std::move(c), std::move(s)});
    return 0;
  });
}

/// Makes so many steps, fewer where the case ends. Returns how many, or -1 with what failed in tdbd_text().
EMSCRIPTEN_KEEPALIVE int tdbd_step(int steps) {
  return guarded([&] {
    int made = 0;
    for (; made < steps && session->state.state.steps_done < session->of.time.steps; ++made)
      simulation::step(session->of, session->state);
    return made;
  });
}

EMSCRIPTEN_KEEPALIVE const char* tdbd_text() { return text.c_str(); }
EMSCRIPTEN_KEEPALIVE const char* tdbd_facts() { return kept(facts_json(*session)); }
EMSCRIPTEN_KEEPALIVE const char* tdbd_look() { return kept(look_json(*session)); }

/// s; N and N m of the last step, not a number without forces.
EMSCRIPTEN_KEEPALIVE double tdbd_time() {
  return simulation::time_at(session->of.time, session->state.state.steps_done);
}
EMSCRIPTEN_KEEPALIVE double tdbd_wob() { return weight_on_bit(*session); }
EMSCRIPTEN_KEEPALIVE double tdbd_tob() { return torque_on_bit(*session); }

/// Takes the rock's surface into the arrays; the numbers are the part that cut each vertex last, -1: none.
EMSCRIPTEN_KEEPALIVE void tdbd_show_rock() {
  const rock::Rock& rock = session->state.state.rock;
  std::vector<int> slots;
  const mesh::TriangleMesh m = mesh::compact(rock.surface, &slots);
  for (int& slot : slots) slot = rock.last_part[at(slot)];
  show(m, std::move(slots));
}

/// Takes the bit at rest, in its own frame; the numbers are the part of each triangle.
EMSCRIPTEN_KEEPALIVE void tdbd_show_bit() {
  std::vector<int> owner;
  const mesh::TriangleMesh m = bit::merged_mesh(session->of.bit, Pose{}, &owner);
  show(m, std::move(owner));
}

EMSCRIPTEN_KEEPALIVE const double* tdbd_positions() { return shown.positions.data(); }
EMSCRIPTEN_KEEPALIVE const int* tdbd_triangles() { return shown.triangles.data(); }
EMSCRIPTEN_KEEPALIVE const int* tdbd_numbers() { return shown.numbers.data(); }
EMSCRIPTEN_KEEPALIVE int tdbd_vertex_count() {
  return static_cast<int>(shown.positions.size() / 3);
}
EMSCRIPTEN_KEEPALIVE int tdbd_triangle_count() {
  return static_cast<int>(shown.triangles.size() / 3);
}

/// Writes the surface as `tdbd run` writes rock_final.ply. 0, or -1 with what is wrong in tdbd_text().
EMSCRIPTEN_KEEPALIVE int tdbd_write_rock(const char* path) {
  return guarded([&] {
    const long steps = session->state.state.steps_done;
    std::ofstream file(path, std::ios::binary);
    mesh::write_ply(file, mesh::compact(session->state.state.rock.surface),
                    simulation::comments_of(
                        {steps, simulation::time_at(session->of.time, steps), session->of.hash}));
    file.close();
    if (!file) throw RunError(std::string("cannot write ") + path);
    return 0;
  });
}

}  // extern "C"
