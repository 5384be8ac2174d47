#include "app/python/given.h"

#include "hexoderm/base/spelling_suggestion.h"
#include "hexoderm/base/text.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <vector>

namespace hexoderm::python {
namespace {

namespace py = pybind11;

/// What pybind11 knows of a function, which its dispatcher holds as `self`.
const py::detail::function_record& recordOf(py::handle function) {
  const py::handle plain = py::detail::get_function(function);
  return *py::reinterpret_borrow<py::capsule>(PyCFunction_GET_SELF(plain.ptr()))
              .get_pointer<py::detail::function_record>();
}

/// The arguments of a function as errors need them.
struct Signature {
  std::string function;
  std::vector<std::string> names;     ///< without self
  std::vector<std::string> required;  ///< those without a default
  std::size_t by_place = 0;           ///< how many may be given without a name
  bool has_self = false;
};

Signature signatureOf(const py::detail::function_record& record, const char* name) {
  Signature signature;
  signature.has_self = record.is_method || record.is_constructor;
  signature.function = record.is_constructor ? std::string(py::str(record.scope.attr("__name__"))) : name;
  for (std::size_t k = signature.has_self ? 1 : 0; k < record.args.size(); ++k) {
    signature.names.emplace_back(record.args[k].name);
    if (!record.args[k].value) signature.required.emplace_back(record.args[k].name);
  }
  signature.by_place = record.nargs_pos - (signature.has_self ? 1 : 0);
  return signature;
}

[[noreturn]] void explain(const Signature& signature, const py::args& args, const py::kwargs& named) {
  const std::string call = signature.function + "()";
  for (const auto& [key, value] : named) {
    const std::string name = py::str(key);
    if (std::ranges::find(signature.names, name) != signature.names.end()) continue;
    const std::optional<std::string> meant = spellingSuggestion(name, signature.names);
    throw py::type_error(call + " has no argument " + name +
                         (meant ? "; did you mean " + *meant + "?" : "; it has " + inARow(signature.names)));
  }
  const std::size_t placed = args.size() - (signature.has_self && !args.empty() ? 1 : 0);
  if (placed > signature.by_place) {
    const std::string most = std::to_string(signature.by_place);
    throw py::type_error(call +
                         (signature.by_place == 0   ? " takes no argument"
                          : signature.by_place == 1 ? " takes at most 1 argument"
                                                    : " takes at most " + most + " arguments") +
                         " without a name, found " + std::to_string(placed));
  }
  for (std::size_t k = placed; k < signature.names.size(); ++k) {
    const std::string& name = signature.names[k];
    const bool is_required = std::ranges::find(signature.required, name) != signature.required.end();
    if (is_required && !named.contains(name.c_str())) throw py::type_error(call + " needs " + name);
  }
  throw py::type_error(call + ": an argument is given twice, or is of another type than help() says");
}

}  // namespace

std::string foundText(py::handle object) {
  constexpr std::size_t kMax = 40;
  const std::string type = Py_TYPE(object.ptr())->tp_name;
  const std::string text = py::repr(object);
  return text.size() > kMax || text.find('\n') != std::string::npos ? type : type + ": " + text;
}

void failFor(const char* name, const std::string& expected, py::handle found) {
  throw py::type_error(std::string(name) + ": expected " + expected + ", found " + foundText(found));
}

void explainMisfits(py::handle scope, const char* name) {
  const py::object function = scope.attr(name);
  const py::handle plain = py::detail::get_function(function);
  const py::detail::function_record& record = recordOf(function);
  const Signature signature = signatureOf(record, name);
  const std::string doc = py::str(function.attr("__doc__"));
  const auto refuse = [signature](const py::args& args, const py::kwargs& named) { explain(signature, args, named); };
  if (signature.has_self) {
    const py::cpp_function added(refuse, py::name(name), py::is_method(scope), py::sibling(plain));
  } else {
    const py::cpp_function added(refuse, py::name(name), py::scope(scope), py::sibling(plain));
  }
  // As if there were no overload: help() is about the function itself.
  PyMethodDef* const definition = reinterpret_cast<PyCFunctionObject*>(plain.ptr())->m_ml;
  std::free(const_cast<char*>(definition->ml_doc));
  definition->ml_doc = ::strdup(doc.c_str());
}

}  // namespace hexoderm::python
