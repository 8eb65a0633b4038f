#include <kanexpr/mechanics/model/vector_text.hpp>
#include <kanexpr/symbolic/printing/plain.hpp>
#include <kanexpr/symbolic/printing/typeset.hpp>
