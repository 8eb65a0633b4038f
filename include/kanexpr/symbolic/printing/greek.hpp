#pragma once

#include <array>
#include <string_view>

namespace kanexpr::symbolic::printing {

/// A Greek letter: its name, which is also its LaTeX command, and the letter itself.
struct greek_letter {
  std::string_view name{}, letter{};
};

inline constexpr std::array<greek_letter, 36> greek_letters{
    {{"alpha", "α"},     {"beta", "β"},    {"gamma", "γ"},  {"delta", "δ"},   {"epsilon", "ε"},
     {"zeta", "ζ"},      {"eta", "η"},     {"theta", "θ"},  {"iota", "ι"},    {"kappa", "κ"},
     {"lambda", "λ"},    {"mu", "μ"},      {"nu", "ν"},     {"xi", "ξ"},      {"pi", "π"},
     {"rho", "ρ"},       {"sigma", "σ"},   {"tau", "τ"},    {"upsilon", "υ"}, {"phi", "φ"},
     {"chi", "χ"},       {"psi", "ψ"},     {"omega", "ω"},  {"varphi", "φ"},  {"Gamma", "Γ"},
     {"Delta", "Δ"},     {"Theta", "Θ"},   {"Lambda", "Λ"}, {"Xi", "Ξ"},      {"Pi", "Π"},
     {"Sigma", "Σ"},     {"Upsilon", "Υ"}, {"Phi", "Φ"},    {"Psi", "Ψ"},     {"Omega", "Ω"},
     {"varepsilon", "ε"}}};

/// Returns the letter with a name; empty if there is none.
constexpr std::string_view greek_letter_called(std::string_view name) {
  for (const greek_letter& each : greek_letters)
    if (each.name == name) return each.letter;
  return {};
}

} // namespace kanexpr::symbolic::printing
