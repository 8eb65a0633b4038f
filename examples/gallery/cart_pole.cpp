// A cart balances a pendulum by what two noisy sensors report.
#include <kanexpr/simulations/trajectory/trajectory.hpp>
#include <loops/balanced_cart.hpp>
#include <parts/page.hpp>
#include <pictures/n_pendulum_cart.hpp>

int main(int count, char** words) {
  using namespace balanced_cart;
  gallery::page page(count, words,
                     {.title = "Cart and pole",
                      .kind = "Control",
                      .see = "The cart moves under the falling pole and brings it back to the middle of the "
                             "track. A Kalman filter "
                             "estimates the speeds from noisy sensors two hundred times a second, and the "
                             "compiler computed the gains.",
                      .source = "Åström & Murray, Feedback Systems (2008), sections 2.2 and 7.4"});
  const state<cart> start(-0.5, upright + 0.2, 0, 0), guess(-0.4, upright + 0.1, 0, 0);
  loop<double> moving(start, guess);
  trajectory<cart> path(parameters_in<double>());
  for (int k = 0; k < 200 * 8; ++k) {
    if (const status s = moving.go_on(); !s) page.refuse(s.cause());
    if (k % 4 == 0) path.add({moving.t, moving.x, moving.control.force});
  }
  double late = 0;
  for (const auto& s : path)
    if (s.t > 4) late = std::max(late, std::abs(s.x[q<1>] - upright));
  page.expect(late < 0.05, "the pole stays within 0.05 rad of the vertical after four seconds");
  page.expect(std::abs(moving.x[q<0>]) < 0.2, "the cart returns to the middle");
  return page.show<n_pendulum_cart::picture>(path, {.at = 0.2});
}
