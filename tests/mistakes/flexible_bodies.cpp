// Flexible bodies with wrong data or words, and nodes at wrong places.
#include "flexible_bodies.hpp"

// expect: flexible body B is not given by flexible_body_data<amplitudes, nodes>
namespace f1 {
struct B : flexible_body<B, O, N, number> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace f1

// expect: flexible body B has an argument that is not one of its words; the only word is by<...>
namespace f2 {
struct B : flexible_body<B, O, N, bar, O> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace f2

// expect: flexible body B has by<...> with too few or too many symbols; write a coordinate for each
// expect: amplitude, followed by a speed for each
namespace f3 {
struct B : flexible_body<B, O, N, bar, by<q, p, u>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace f3

// expect: flexible body B has by<...> twice
namespace f4 {
struct B : flexible_body<B, O, N, bar, by<q, u>, by<q, u>> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace f4

// expect: node Tip is node 13 of Bar, which has no such node
namespace f5 {
struct Tip : node<Tip, Bar, 13> {};
struct Bob : particle<Bob, Tip, 0.5> {};
struct System : system_of<bodies<Bar, Bob>> {};
void f() { use<System>(); }
} // namespace f5

// expect: flexible body Bar, to which node Tip belongs, is not listed in bodies<...>
namespace f6 {
struct Tip : node<Tip, Bar, 12> {};
struct Bob : particle<Bob, Tip, 0.5> {};
struct System : system_of<coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>> {};
void f() { use<System>(); }
} // namespace f6

// expect: node Tip belongs to Bob, which is not a flexible_body<...>
namespace f7 {
struct Bob : particle<Bob, O, 0.5> {};
struct Tip : node<Tip, Bob, "tip"> {};
struct Hat : particle<Hat, Tip, 0.5> {};
struct System : system_of<coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob, Hat>> {};
void f() { use<System>(); }
} // namespace f7

// expect: a motion is declared for node Tip, which moves with its body
namespace f8 {
struct Tip : node<Tip, Bar, 12>, fixed_in<N> {};
struct Bob : particle<Bob, Tip, 0.5> {};
struct System : system_of<bodies<Bar, Bob>> {};
void f() { use<System>(); }
} // namespace f8

// expect: the flexible body B has no mass
namespace f9 {
struct B : flexible_body<B, O, N, without_mass> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace f9

// expect: flexible body B has more than 99 amplitudes; build such a body at run time
namespace f10 {
constexpr flexible_body_data<100, 0> large{.mass = 1};
struct B : flexible_body<B, O, N, large> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace f10

// expect: flexible body Bar, to which node Tip belongs, is not listed in bodies<...>
namespace f11 {
struct Tip : node<Tip, Bar, 12> {};
struct Bob : particle<Bob, Tip, 0.5> {};
struct System : system_of<bodies<Bob>> {};
void f() { use<System>(); }
} // namespace f11

// expect: flexible body B has an amplitude with a negative stiffness
namespace f12 {
constexpr flexible_body_data<1, 0> soft{.mass = 1, .modal_mass = {1}, .stiffness = {-1}};
struct B : flexible_body<B, O, N, soft> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace f12

// expect: flexible body B has an amplitude with a negative damping
namespace f13 {
constexpr flexible_body_data<1, 0> lively{.mass = 1, .modal_mass = {1}, .damping = {-1}};
struct B : flexible_body<B, O, N, lively> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace f13

// expect: flexible body B has a term with an index of no amplitude
namespace f14 {
constexpr flexible_body_data<1, 0, 1> other{
    .mass = 1, .modal_mass = {1}, .elastic_terms = {{.coefficient = 2, .amplitudes = {0, 0, 1, -1}}}};
struct B : flexible_body<B, O, N, other> {};
struct System : system_of<bodies<B>> {};
void f() { use<System>(); }
} // namespace f14
