#pragma once

#include <kanexpr/robots/header_text.hpp>
#include <kanexpr/robots/plan.hpp>

#include <string>
#include <utility>
#include <vector>

namespace kanexpr::robots {

/// A header as far as it has been written: the declarations, the loads, and the parameters in use.
struct header_draft {
  const robot& source;
  model_options options;
  robots::plan plan;
  std::vector<std::string> types, loads{};
  std::vector<std::pair<std::string, double>> values{}; ///< the parameters, with their values in the file
  std::string declarations{};                           ///< the declarations

  header_draft(const robot& r, const model_options& o)
      : source(r), options(o), plan(plan_of(r, o)), types(r.links.size()) {}

  const std::string& name(int link) const { return plan.links[static_cast<std::size_t>(link)]; }
  /// The type that has the axes and the origin of a link; N for a link that coincides with the ground.
  std::string& type(int link) { return types[static_cast<std::size_t>(link)]; }

  std::string value(const std::string& called, double of_file) {
    if (options.bind == binding::numbers) return header_text::digits(of_file);
    values.emplace_back(called, of_file);
    return called;
  }

  void write_struct(const std::string& called, const std::string& word,
                    const std::vector<std::string>& arguments) {
    std::vector<std::string> all{called};
    all.insert(all.end(), arguments.begin(), arguments.end());
    declarations += header_text::wrapped("struct " + called + " : " + word + "<", all) + "> {};\n";
  }

  std::string symbols_along(const std::string& axes, const std::string& called, const vector3& v) {
    const std::string x = value("x_" + called, v[0]), y = value("y_" + called, v[1]),
                      z = value("z_" + called, v[2]);
    return x + " * " + axes + "::x + " + y + " * " + axes + "::y + " + z + " * " + axes + "::z";
  }
};

} // namespace kanexpr::robots
