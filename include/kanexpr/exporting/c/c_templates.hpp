#pragma once

#include <kanexpr/exporting/text/fill_template.hpp>

#include <string_view>

/// The text around the functions in C.
namespace kanexpr::exporting::c_templates {

inline constexpr std::string_view header = template_text(
#include <kanexpr/exporting/c/header.h.in>
);

inline constexpr std::string_view source = template_text(
#include <kanexpr/exporting/c/source.c.in>
);

inline constexpr std::string_view reduction_of_double = template_text(
#include <kanexpr/exporting/c/reduction_of_double.c.in>
);

/// Without hardware for `double`, fused operations give exact remainders.
inline constexpr std::string_view reduction_of_float = template_text(
#include <kanexpr/exporting/c/reduction_of_float.c.in>
);

inline constexpr std::string_view sine_and_cosine = template_text(
#include <kanexpr/exporting/c/sine_and_cosine.c.in>
);

} // namespace kanexpr::exporting::c_templates
