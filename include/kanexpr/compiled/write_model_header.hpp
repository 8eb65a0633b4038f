#pragma once

#include <kanexpr/compiled/surveyed.hpp>

#include <fstream>
#include <ostream>
#include <string>
#include <string_view>

namespace kanexpr::compiled {

/// Writes the header of a linked model (see `linked_model.hpp`): the surveys of its systems, as constants.
class model_header {
public:
  model_header(const std::string& path, std::string_view model) : out_(path, std::ios::binary) {
    out_ << "// Written by kanexpr_add_model: sizes and names of the systems, whose functions are in a "
            "library.\n"
            "#pragma once\n\n#include <kanexpr/compiled/linked_model.hpp>\n\n#include \""
         << model << "\"\n";
  }

  /// `spelled` is the name of the system from everywhere, "pendulum::System".
  template <class System>
  void add(std::string_view spelled) {
    add(survey_of<System>, spelled);
  }

  /// Whether all was written.
  bool close() {
    out_.close();
    return static_cast<bool>(out_);
  }

private:
  void add(const deriving::survey& known, std::string_view spelled) {
    out_ << "\ntemplate <>\nstruct kanexpr::compiled::surveyed<" << spelled
         << "> {\n  using system = " << spelled
         << ";\n  static constexpr bool is_linked = true;\n"
            "  static constexpr kanexpr::deriving::survey survey = [] {\n"
            "    kanexpr::deriving::survey s;\n";
    set("takes_rates_as_speeds", known.takes_rates_as_speeds);
    set("coordinates", known.coordinates);
    set("speeds", known.speeds);
    set("parameters", known.parameters);
    set("inputs", known.inputs);
    set("auxiliary_speeds", known.auxiliary_speeds);
    set("constraints", known.constraints);
    set("configuration_constraints", known.configuration_constraints);
    set("redundant_constraints", known.redundant_constraints);
    set("quaternions", known.quaternions);
    for (int i = 0; i < known.symbols(); ++i) {
      out_ << "    s.names[" << i << "] = \"" << known.names[i].view() << "\";\n";
      if (known.dependent[i]) out_ << "    s.dependent[" << i << "] = true;\n";
      if (known.quaternion_of[i] != 0)
        out_ << "    s.quaternion_of[" << i << "] = " << known.quaternion_of[i] << ";\n";
      if (known.is_mass[i]) out_ << "    s.is_mass[" << i << "] = true;\n";
      if (known.is_moment[i]) out_ << "    s.is_moment[" << i << "] = true;\n";
    }
    add(known.inertial);
    out_ << "    return s;\n  }();\n  static constexpr kanexpr::mechanics::sentence mistake{};\n"
            "  static constexpr bool follows_from_unparsed = false;\n};\n"
            "template <>\nstruct kanexpr::equations_of_motion<"
         << spelled << "> : kanexpr::compiled::linked_equations<" << spelled
         << "> {};\ntemplate <>\nstruct kanexpr::linearization<" << spelled
         << "> : kanexpr::compiled::linked_linearization<" << spelled
         << "> {};\ntemplate <auto... wanted>\n"
            "  requires(!requires { sizeof(kanexpr::compiled::derives<"
         << spelled << ", wanted...>); })\nstruct kanexpr::function<" << spelled
         << ", wanted...> : kanexpr::compiled::not_derived_here {};\n";
  }
  void add(const deriving::inertial_values& known) {
    set("inertial.steps", known.steps);
    for (int i = 0; i < known.steps; ++i) {
      out_ << "    s.inertial.operation[" << i << "] = static_cast<kanexpr::symbolic::operation>("
           << static_cast<int>(known.operation[i]) << ");\n";
      set("inertial.a", i, known.a[i]);
      set("inertial.b", i, known.b[i]);
      if (known.operation[i] == symbolic::operation::constant)
        out_ << "    s.inertial.number[" << i << "] = " << std::hexfloat << known.number[i]
             << std::defaultfloat << ";\n";
    }
    set("inertial.named", known.named);
    for (int i = 0; i < known.named; ++i)
      out_ << "    s.inertial.names[" << i << "] = \"" << known.names[i].view() << "\";\n";
    set("inertial.count", known.count);
    for (int i = 0; i < known.count; ++i) {
      const deriving::inertial_values::of_body& body = known.bodies[i];
      const std::string member = "inertial.bodies[" + std::to_string(i) + "].";
      set((member + "called").c_str(), body.called);
      set((member + "about").c_str(), body.about);
      set((member + "mass").c_str(), body.mass);
      for (int k = 0; k < 6; ++k) set((member + "inertia").c_str(), k, body.inertia[k]);
      for (int k = 0; k < 3; ++k) set((member + "way").c_str(), k, body.way[k]);
    }
  }
  void set(const char* member, int place, int value) {
    if (value != 0) out_ << "    s." << member << "[" << place << "] = " << value << ";\n";
  }
  void set(const char* member, int value) {
    if (value != 0) out_ << "    s." << member << " = " << value << ";\n";
  }

  std::ofstream out_;
};

} // namespace kanexpr::compiled
