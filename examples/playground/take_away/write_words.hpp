#pragma once

#include "playground/session.hpp"
#include "playground/take_away/cpp_words.hpp"
#include "playground/take_away/files.hpp"
#include "playground/take_away/in_cpp.hpp"

#include <string>

namespace playground {

/// The values of symbols as a constant of a type of the compiled equations; empty if there are none.
inline std::string values_in_cpp(const session& of, const std::string& type, int first, int count) {
  if (count == 0) return "";
  std::string text = "inline const equations_of_motion<System>::" + type + " initial_" + type + '{';
  for (int i = first; i < first + count; ++i)
    text += (i == first ? "{" : ", {") + std::string(of.moving().known().names[i].view()) + ", " +
            number_in_cpp(of.value(i), true) + '}';
  return text + "};\n";
}

/// The model as C++ types, with its state, parameters and inputs of this moment.
inline files write_words(const session& of, const std::string& name) {
  const auto& known = of.moving().known();
  const int states = of.moving().states();
  const std::string values = "\n// at the moment at which the model was taken away\n" +
                             values_in_cpp(of, "state", 0, states) +
                             values_in_cpp(of, "parameters", states, known.parameters) +
                             values_in_cpp(of, "inputs", states + known.parameters, known.inputs);
  const cpp_words written(of.lines(), inertial_frame_of(of.lines()));
  return {.all = {{name + ".hpp", written.header(name, values)}}};
}

} // namespace playground
