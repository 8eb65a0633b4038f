#pragma once

#include <kanexpr/exporting/text/fill_template.hpp>

#include <string_view>

/// The text of Python modules.
namespace kanexpr::exporting::python_templates {

inline constexpr std::string_view module = template_text(
#include <kanexpr/exporting/python/module.py.in>
);

inline constexpr std::string_view function = template_text(
#include <kanexpr/exporting/python/function.py.in>
);

} // namespace kanexpr::exporting::python_templates
