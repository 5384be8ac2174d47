#include "app/python/bindings.h"

#include "hexoderm/util/error.h"

#include <cstring>
#include <exception>
#include <string>
#include <system_error>

namespace hexoderm::python {
namespace {

namespace py = pybind11;

/// The exceptions of the module. They live as long as the interpreter, which may translate an error at any time.
struct Exceptions {
  PyObject* error = nullptr;
  PyObject* invalid_argument = nullptr;
  PyObject* format_error = nullptr;
  PyObject* storage_error = nullptr;
  PyObject* device_error = nullptr;
};
Exceptions exceptions;

PyObject* addException(py::module_& module, const char* name, const char* doc, const py::tuple& bases) {
  PyObject* type = PyErr_NewExceptionWithDoc((std::string("hexoderm.") + name).c_str(), doc, bases.ptr(), nullptr);
  if (type == nullptr) throw py::error_already_set();
  module.attr(name) = py::handle(type);
  return type;
}

/// A text may quote the bytes of a file's name, which need not be UTF-8.
void raise(PyObject* type, const char* text) {
  const py::object message = py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(text, static_cast<Py_ssize_t>(std::strlen(text)), "surrogateescape"));
  if (message) PyErr_SetObject(type, message.ptr());
}

void translate(std::exception_ptr error) {
  if (!error) return;
  try {
    std::rethrow_exception(std::move(error));
  } catch (const InvalidArgument& e) {
    raise(exceptions.invalid_argument, e.what());
  } catch (const FormatError& e) {
    raise(exceptions.format_error, e.what());
  } catch (const StorageError& e) {
    raise(exceptions.storage_error, e.what());
  } catch (const DeviceError& e) {
    raise(exceptions.device_error, e.what());
  } catch (const Error& e) {
    raise(exceptions.error, e.what());
  } catch (const std::system_error& e) {  // of std::filesystem, above all
    raise(exceptions.storage_error, e.what());
  }
}

}  // namespace

void bindErrors(py::module_& module) {
  const py::handle exception = PyExc_Exception;
  const py::handle value_error = PyExc_ValueError;
  const py::handle os_error = PyExc_OSError;
  exceptions.error = addException(
      module, "Error", "Base of what Hexoderm raises; the text says what is wrong, where, and what was expected.",
      py::make_tuple(exception));
  const py::handle error = exceptions.error;
  exceptions.invalid_argument = addException(module, "InvalidArgument", "An argument or option is out of its range.",
                                             py::make_tuple(error, value_error));
  exceptions.format_error =
      addException(module, "FormatError", "A file is not what its format says.", py::make_tuple(error, value_error));
  exceptions.storage_error =
      addException(module, "StorageError", "Reading or writing failed: missing, not permitted, full.",
                   py::make_tuple(error, os_error));
  exceptions.device_error =
      addException(module, "DeviceError", "A device or the way to it failed.", py::make_tuple(error, os_error));
  py::register_exception_translator(translate);
}

}  // namespace hexoderm::python
