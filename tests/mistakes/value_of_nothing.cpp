// expect: values<...> binds parameter mm, which nothing in the system uses
#include "pendulum.hpp"

constexpr parameter<"mm"> mm;

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight>, values<mm == 2>> {};

int main() { use<System>(); }
