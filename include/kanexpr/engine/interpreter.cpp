#include <kanexpr/runtime/checked_code.hpp>

namespace kanexpr::runtime {

template class interpreter<double>;
template class interpreter<float>;
template class checked_code<double>;
template class checked_code<float>;

} // namespace kanexpr::runtime
