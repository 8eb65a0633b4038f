// expect: k states no unit, so its value is a number, not a quantity
#include <kanexpr/boost_units.hpp>
#include <kanexpr/compiled/named_values.hpp>

using namespace kanexpr;

constexpr parameter<"k"> k;

int main() {
  const named_value stiffness{k, 5. * boost::units::si::newtons / boost::units::si::meters};
  return stiffness.value > 0;
}
