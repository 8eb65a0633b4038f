#pragma once

#include <kanexpr/exporting/text/fill_template.hpp>

#include <string_view>

/// The text of headers for C++.
namespace kanexpr::exporting::cpp_templates {

inline constexpr std::string_view header = template_text(
#include <kanexpr/exporting/cpp/header.hpp.in>
);

inline constexpr std::string_view structure = template_text(
#include <kanexpr/exporting/cpp/structure.hpp.in>
);

inline constexpr std::string_view function = template_text(
#include <kanexpr/exporting/cpp/function.hpp.in>
);

} // namespace kanexpr::exporting::cpp_templates
