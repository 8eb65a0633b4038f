#include <kanexpr/compiled/values_reader.ipp>
#include <kanexpr/runtime/interpreter.hpp>

template class kanexpr::runtime::interpreter<double>;
template class kanexpr::runtime::interpreter<float>;
template class kanexpr::runtime::interpreter<double, kanexpr::lower::tape_view>;
template class kanexpr::runtime::checked_code<double>;
template class kanexpr::runtime::checked_code<float>;
