// expect: has more than 512 symbols
#include "pendulum.hpp"

#include <utility>

template <int first, int... i>
constexpr auto sum_of(std::integer_sequence<int, i...>) {
  return (parameter<"k", first + i>{} + ...);
}
template <class Numbers>
struct pulled_often;
template <int... i>
struct pulled_often<std::integer_sequence<int, i...>>
    : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                  loads<weight, force<P, sum_of<32 * i>(std::make_integer_sequence<int, 32>()) * N::x>...>> {
};

int main() { use<pulled_often<std::make_integer_sequence<int, 16>>>(); }
