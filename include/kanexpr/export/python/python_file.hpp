#pragma once

#include <kanexpr/export/text/fill_template.hpp>
#include <kanexpr/export/text/names_in_c.hpp>
#include <kanexpr/export/text/scalar.hpp>

#include <string>
#include <vector>

namespace kanexpr::exporting {

/// Writes NAME.py, a module that calls the functions of NAME.c through ctypes, with names and plain lists.
class python_file {
public:
  python_file(const exported_system& s, precision number) : mapped_(names_in_c(s)), number_(number) {}

  std::string text() const {
    const exported_system& s = mapped_.system;
    std::vector<std::string> states = s.coordinates;
    states.insert(states.end(), s.speeds.begin(), s.speeds.end());
    std::string all =
        fill_template(R"("""Equations of motion of @name@. Compile @name@.c to a library next to this file:

    cc -std=c99 -O2 -fno-math-errno -shared -fPIC @name@.c -o lib@name@.so -lm

Vectors are dictionaries with the names as keys, or sequences in the order of `states`,
`parameters`, `inputs` and `speeds`.
"""

import ctypes
import pathlib

states = @states@
speeds = @speeds@
parameters = @parameters@
inputs = @inputs@

_library = ctypes.CDLL(str(pathlib.Path(__file__).resolve().with_name("lib@name@.so")))


class Singular(ArithmeticError):
    """The requested result does not exist at this state."""


def _vector(values, names, what):
    if isinstance(values, dict):
        for name in values:
            if name not in names:
                raise KeyError(f"{name} is not one of the {what} " + ", ".join(names))
        missing = [name for name in names if name not in values]
        if missing:
            raise KeyError(f"the {what} lack a value for " + ", ".join(missing))
        values = [values[name] for name in names]
    values = list(values)
    if len(values) != len(names):
        raise ValueError(f"expected {len(names)} {what}, got {len(values)}")
    return (ctypes.@number@ * len(names))(*values)


def _call(function, t, vectors, sizes, causes):
    results = [(ctypes.@number@ * (rows * columns))() for rows, columns in sizes]
    status = function(ctypes.@number@(t), *vectors, *results)
    failed = [cause for bit, cause in enumerate(causes) if status >> bit & 1]
    if failed:
        raise Singular("; ".join(failed))
    found = [
        list(result) if columns == 1 else [list(result[i * columns : (i + 1) * columns]) for i in range(rows)]
        for result, (rows, columns) in zip(results, sizes)
    ]
    return found[0] if len(found) == 1 else tuple(found)
)",
                      {{"name", s.name},
                       {"states", tuple(states)},
                       {"speeds", tuple(s.speeds)},
                       {"parameters", tuple(s.parameters)},
                       {"inputs", tuple(s.inputs)},
                       {"number", std::string("c_") + number_.type()}});
    for (const exported_function& f : s.functions) all += definition(f);
    return all;
  }

private:
  static std::string tuple(const std::vector<std::string>& names) {
    std::string all = "(";
    for (const std::string& each : names) all += '"' + each + "\", ";
    if (names.size() > 1) all.resize(all.size() - 2);
    return names.size() == 1 ? all.substr(0, all.size() - 1) + ')' : all + ')';
  }

  std::string definition(const exported_function& f) const {
    std::string sizes, called, causes;
    for (const exported_result& each : f.results) {
      sizes += "(" + std::to_string(each.rows) + ", " + std::to_string(each.columns) + "), ";
      called += (called.empty() ? "" : ", ") + each.name;
    }
    for (const std::string& each : f.causes()) causes += "\n    \"" + each + "\",";
    return fill_template(
        R"(

_@function@ = _library.@name@_@function@
_@function@.restype = ctypes.c_ulonglong
_@function@_causes = (@causes@)


def @function@(x@h@, p=(), r=()@a@, t=0.0):
    """Returns @called@."""
    vectors = [_vector(x, states, "states"), _vector(p, parameters, "parameters"), _vector(r, inputs, "inputs")]
@more@    return _call(_@function@, t, vectors, [@sizes@], _@function@_causes)
)",
        {{"function", f.name},
         {"name", mapped_.system.name},
         {"causes", causes + (causes.empty() ? "" : "\n")},
         {"h", f.takes_step ? ", h" : ""},
         {"a", f.takes_rates ? ", a=()" : ""},
         {"more", more_vectors(f)},
         {"called", called},
         {"sizes", sizes.substr(0, sizes.size() - 2)}});
  }

  /// The arguments that a function takes in addition to states, parameters and inputs.
  std::string more_vectors(const exported_function& f) const {
    if (f.takes_step) return std::string("    vectors.insert(1, ctypes.c_") + number_.type() + "(h))\n";
    return f.takes_rates ? "    vectors.append(_vector(a, speeds, \"rates of the speeds\"))\n" : "";
  }

  system_with_c_names mapped_;
  scalar number_;
};

} // namespace kanexpr::exporting
