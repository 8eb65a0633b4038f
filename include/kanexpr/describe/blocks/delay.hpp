#pragma once

#include <kanexpr/describe/blocks/block.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <utility>

namespace kanexpr {

namespace describe {

/// The coefficient s_ij of the equations of a delay.
constexpr double legendre_sign(int i, int j) { return i < j || (i - j) % 2 == 0 ? -1.0 : 1.0; }
/// The coefficient (−1)^i of the input.
constexpr double legendre_sign_of_input(int i) { return i % 2 == 0 ? 1.0 : -1.0; }

/// The equations of a delay of the time T, T ṁ_i = (2i + 1) (Σ_j s_ij m_j + (−1)^i x) for i < n, where s_ij
/// is −1 if i < j and (−1)^(i−j+1) otherwise. m_i are the coefficients of the input of the last T seconds as
/// a series of Legendre polynomials. The output Σ m_i is that of the Padé approximant of e^(−Ts) with a
/// numerator of degree n − 1 and a denominator of degree n, whose realization by powers of s is poorly
/// scaled. Voelker & Eliasmith, Improving spiking dynamical networks: accurate delays, higher-order synapses,
/// and time cells, Neural Computation 30 (2018), 569–609.
template <class Self, int order, auto x, auto time>
struct legendre_delay {
  template <int i>
  static constexpr symbol<symbolic::symbol_kind::speed, joint_name<"m", Self>, i + 1, of_state_variable> m{};

  template <int i, int j>
  static constexpr auto sum_from() {
    if constexpr (j + 1 == order)
      return legendre_sign(i, j) * m<j>;
    else
      return legendre_sign(i, j) * m<j> + sum_from<i, j + 1>();
  }
  template <int i>
  static constexpr auto sum_of_all() {
    if constexpr (i + 1 == order)
      return m<i>;
    else
      return m<i> + sum_of_all<i + 1>();
  }

  template <int i>
  static constexpr auto equation =
      time * dot(m<i>) == (2.0 * i + 1) * (sum_from<i, 0>() + legendre_sign_of_input(i) * x);

  static constexpr block_record record(const arguments& fits) {
    return [&]<int... i>(std::integer_sequence<int, i...>) {
      return requiring<positive_of<"the time of ", time>>(
          states_of_block<Self, m<i>...>::template with<equation<i>...>(fits));
    }(std::make_integer_sequence<int, order>());
  }
};

} // namespace describe

/// Delays an input by the time T, approximately: `struct Late : delay<Late, order, x, T> {}`, with `order`
/// state variables m_Late1, m_Late2, …. `Late::output` follows x(t − T) as far as x contains frequencies up
/// to about `order`/T rad/s; its transfer function is the Padé approximant of e^(−Ts) with a numerator of
/// degree `order` − 1 and a denominator of degree `order`.
template <class Self, int order, auto... input_and_time>
  requires(order >= 1 && order <= 20)
struct delay : describe::block_words {
private:
  using series = describe::legendre_delay<Self, order, describe::argument_or_zero<0, input_and_time...>(),
                                          describe::argument_or_zero<1, input_and_time...>()>;

public:
  static constexpr auto output = series::template sum_of_all<0>();

  static constexpr describe::block_record block =
      series::record(describe::arguments_of("delay<Self, order, input, time>", sizeof...(input_and_time), 2));
};

} // namespace kanexpr
