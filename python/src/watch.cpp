#include "python/src/watch.hpp"

#include <string>
#include <utility>

namespace tdbd::python {

Watch::Watch(py::object progress) : progress_(std::move(progress)) {
  if (!progress_.is_none() && PyCallable_Check(progress_.ptr()) == 0)
    throw py::type_error(std::string("progress: found ") + Py_TYPE(progress_.ptr())->tp_name +
                         ", expected a function of done and total");
}

bool Watch::is_due(long done, long total) {
  constexpr std::chrono::milliseconds between{100};
  const std::lock_guard lock(clock_);
  const auto now = Clock::now();
  if (now - looked_ < between && done != total) return false;
  looked_ = now;
  return true;
}

void Watch::look(long done, long total) {
  if (interrupted_ || !is_due(done, total)) return;
  const py::gil_scoped_acquire held;
  if (raised_) return;
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!progress_.is_none()) progress_(done, total);
  } catch (const py::error_already_set&) {
    raised_ = std::current_exception();
    interrupted_ = true;
  }
}

void Watch::rethrow() const {
  if (raised_) std::rethrow_exception(raised_);
}

}  // namespace tdbd::python
