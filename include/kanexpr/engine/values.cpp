#include <kanexpr/compiled/engine/values_reader.hpp>
