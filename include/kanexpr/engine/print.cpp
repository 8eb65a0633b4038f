#include <kanexpr/mechanics/model/vector_text.hpp>
#include <kanexpr/symbolic/print/plain.hpp>
#include <kanexpr/symbolic/print/typeset.hpp>
