#pragma once

#include "playground/session.hpp"
#include "playground/take_away/cpp_words.hpp"
#include "playground/take_away/files.hpp"
#include "playground/take_away/in_cpp.hpp"

#include <kanexpr/base/library_words.hpp>
#include <kanexpr/exporting/text/identifiers.hpp>

#include <cmath>
#include <string>

namespace playground {

/// A name for a namespace, with an underscore if it would mean something else: class_.
inline std::string namespace_called(const std::string& name) {
  kanexpr::exporting::identifiers used;
  used.reserve_words();
  used.reserve_words_of_mathematics();
  used.reserve(kanexpr::base::library_words::words_of_the_library);
  used.reserve("main std kanexpr Eigen");
  return used.unique(name);
}

/// The values of symbols as a constant of a type of the compiled equations; empty if there are none.
inline std::string values_in_cpp(const session& of, const std::string& type, int first, int count) {
  if (count == 0) return "";
  std::string text = "inline const equations_of_motion<System>::" + type + " initial_" + type + '{';
  for (int i = first; i < first + count; ++i)
    text += (i == first ? "{" : ", {") + std::string(of.moving().known().names[i].view()) + ", " +
            number_in_cpp(of.value(i), true) + '}';
  return text + "};\n";
}

/// Why the values of this moment cannot be written, if so.
inline std::string mistake_in_values(const session& of) {
  for (int i = 0; i < of.moving().known().symbols(); ++i)
    if (!std::isfinite(of.value(i)))
      return "the value of " + std::string(of.moving().known().names[i].view()) +
             " is not finite; go back to the start";
  return "";
}

/// The model as C++ types, with its state, parameters and inputs of this moment.
inline files write_words(const session& of, const std::string& name) {
  if (const std::string mistake = mistake_in_values(of); !mistake.empty()) return {.mistake = mistake};
  const auto& known = of.moving().known();
  const int states = of.moving().states();
  const std::string values = "\n// at the moment at which the model was taken away\n" +
                             values_in_cpp(of, "state", 0, states) +
                             values_in_cpp(of, "parameters", states, known.parameters) +
                             values_in_cpp(of, "inputs", states + known.parameters, known.inputs);
  const cpp_words written(of.lines(), inertial_frame_of(of.lines()));
  if (!written.mistake().empty()) return {.mistake = written.mistake()};
  return {.all = {{name + ".hpp", written.header(namespace_called(name), values)}}};
}

} // namespace playground
