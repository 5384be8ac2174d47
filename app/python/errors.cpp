#include "app/python/bindings.h"

#include "hexoderm/base/error.h"

#include <array>
#include <cstring>
#include <exception>
#include <string>
#include <system_error>

namespace hexoderm::python {
namespace {

namespace py = pybind11;

template <class... Kinds>
bool isA(const std::exception& error) {
  return (... || (dynamic_cast<const Kinds*>(&error) != nullptr));
}

/// An exception of the module. It lives as long as the interpreter, which may translate an error at any time.
struct Exception {
  const char* name;
  const char* doc;
  PyObject** of_python;  ///< its base, beside Error
  bool (*stands_for)(const std::exception& error);
  PyObject* type = nullptr;
};
/// The first one is the base of the others, and stands for what none of them does.
std::array<Exception, 5> exceptions = {{
    {"Error", "Base of what Hexoderm raises; the text says what is wrong, where, and what was expected.",
     &PyExc_Exception, isA<Error>},
    {"InvalidArgument", "An argument or option is out of its range.", &PyExc_ValueError, isA<InvalidArgument>},
    {"FormatError", "A file is not what its format says.", &PyExc_ValueError, isA<FormatError>},
    // A system_error is one of std::filesystem, above all.
    {"StorageError", "Reading or writing failed: missing, not permitted, full.", &PyExc_OSError,
     isA<StorageError, std::system_error>},
    {"DeviceError", "A device or the way to it failed.", &PyExc_OSError, isA<DeviceError>},
}};

/// A text may quote the bytes of a file's name, which need not be UTF-8.
void raise(PyObject* type, const char* text) {
  const py::object message = py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(text, static_cast<Py_ssize_t>(std::strlen(text)), "surrogateescape"));
  if (message) PyErr_SetObject(type, message.ptr());
}

void translate(std::exception_ptr thrown) {
  if (!thrown) return;
  try {
    std::rethrow_exception(thrown);
  } catch (const std::exception& error) {
    for (auto exception = exceptions.rbegin(); exception != exceptions.rend(); ++exception) {
      if (exception->stands_for(error)) return raise(exception->type, error.what());
    }
    throw;
  }
}

}  // namespace

void bindErrors(py::module_& module) {
  for (Exception& exception : exceptions) {
    const py::handle of_python(*exception.of_python);
    const py::tuple bases = &exception == &exceptions.front()
                                ? py::make_tuple(of_python)
                                : py::make_tuple(py::handle(exceptions.front().type), of_python);
    exception.type = PyErr_NewExceptionWithDoc((std::string("hexoderm.") + exception.name).c_str(), exception.doc,
                                               bases.ptr(), nullptr);
    if (exception.type == nullptr) throw py::error_already_set();
    module.attr(exception.name) = py::handle(exception.type);
  }
  py::register_exception_translator(translate);
}

}  // namespace hexoderm::python
