#include <kanexpr/mechanics/model/vector_text.hpp>
#include <kanexpr/symbolic/limits/limits.hpp>
#include <kanexpr/symbolic/printing/latex_form.hpp>
#include <kanexpr/symbolic/printing/plain_text_form.hpp>
