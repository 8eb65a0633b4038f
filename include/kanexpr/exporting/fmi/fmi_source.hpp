#pragma once

#include <kanexpr/exporting/text/fill_template.hpp>

#include <string_view>

/// The parts of an FMU. Their C code is the same for all models and relies on `counts`, which comes before
/// it. Memory is allocated only when an instance is created; instances share nothing.
namespace kanexpr::exporting::fmi_source {

inline constexpr std::string_view model_description = template_text(
#include <kanexpr/exporting/fmi/model_description.xml.in>
);

inline constexpr std::string_view build_description = template_text(
#include <kanexpr/exporting/fmi/build_description.xml.in>
);

inline constexpr std::string_view counts = template_text(
#include <kanexpr/exporting/fmi/counts.c.in>
);

/// Types of FMI 3.0 as defined by the standard, and the instance.
inline constexpr std::string_view declarations = template_text(
#include <kanexpr/exporting/fmi/declarations.c.in>
);

/// Used by functions that have checks.
inline constexpr std::string_view failure = template_text(
#include <kanexpr/exporting/fmi/failure.c.in>
);

/// Constraints, events and steps of fixed length, based on the functions that evaluate the model.
inline constexpr std::string_view events_and_steps = template_text(
#include <kanexpr/exporting/fmi/events_and_steps.c.in>
);

/// Creation, modes and steps of an instance.
inline constexpr std::string_view lifecycle = template_text(
#include <kanexpr/exporting/fmi/lifecycle.c.in>
);

/// Values and derivatives.
inline constexpr std::string_view values = template_text(
#include <kanexpr/exporting/fmi/values.c.in>
);

} // namespace kanexpr::exporting::fmi_source
