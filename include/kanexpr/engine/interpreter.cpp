#include <kanexpr/runtime/guarded_code.hpp>

namespace kanexpr::runtime {

template class interpreter<double>;
template class interpreter<float>;
template class guarded_code<double>;
template class guarded_code<float>;

} // namespace kanexpr::runtime
