#include <cstring>
#include <filesystem>

#include "core/error.hpp"
#include "core/units.hpp"
#include "python/src/bindings.hpp"

namespace tdbd::python {
namespace {

/// Converts to a Python string; bytes of file names that are not UTF-8 are shown as \xNN.
py::object text_of(const std::string& message) {
  return py::reinterpret_steal<py::object>(PyUnicode_DecodeUTF8(
      message.data(), static_cast<Py_ssize_t>(message.size()), "backslashreplace"));
}

/// Raises an exception of the package. The message names Python's arguments and functions instead
/// of options and commands.
void raise(const char* name, const std::string& message) {
  const py::module_ errors = py::module_::import("tdbd.errors");
  const py::object text = errors.attr("in_python_words")(text_of(message));
  PyErr_SetObject(py::object(errors.attr(name)).ptr(), text.ptr());
}

/// Raises OSError; Python selects FileNotFoundError, PermissionError, ... from the number.
void raise_os_error(const std::filesystem::filesystem_error& e) {
  const py::tuple what =
      py::make_tuple(e.code().value(), text_of(e.code().message()), text_of(e.path1().string()));
  PyErr_SetObject(PyExc_OSError, what.ptr());
}

}  // namespace

void add_errors() {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const FolderError& e) {
      raise("FolderError", e.what());
    } catch (const InputError& e) {
      raise("CaseError", e.what());
    } catch (const UnitError& e) {
      PyErr_SetObject(PyExc_ValueError, text_of(e.what()).ptr());
    } catch (const RunError& e) {
      raise("RunError", e.what());
    } catch (const std::filesystem::filesystem_error& e) {
      raise_os_error(e);
    }
  });
}

}  // namespace tdbd::python
