#pragma once

#include <kanexpr/base/digest.hpp>
#include <kanexpr/derivation/image.hpp>
#include <kanexpr/lower/fixed_tape.hpp>

#include <concepts>

/// Hashes that identify models and code across runs and builds of a program.
namespace kanexpr::derivation {

/// Adds the user functions to a digest. User functions are identified only by their names, whereas entities
/// are identified by their effect on the derivation.
template <class Holder>
constexpr void take_externals(base::digest& all, const Holder& externals, int count) {
  for (int i = 0; i < count; ++i) all.take(externals[i]->called.view());
}

/// Returns the digest of a stored derivation. It is a template, so that files that do not derive anything do
/// not instantiate the code it needs.
template <std::same_as<image> Image>
constexpr std::uint64_t digest_of(const Image& of) {
  base::digest all;
  for (int count : {of.graph.size, of.numbers, of.integers, of.externals}) all.take(count);
  const auto& nodes = of.graph.nodes.value;
  for (int i = 0; i < of.graph.size; ++i) all.take(nodes[i].op), all.take(nodes[i].a), all.take(nodes[i].b);
  for (int i = 0; i < of.numbers; ++i)
    all.take(of.numerators[i]), all.take(of.denominators[i]), all.take(of.reals[i]);
  for (int i = 0; i < of.integers; ++i) all.take(of.integer[i]);
  take_externals(all, of.external, of.externals);
  return all.value();
}

template <lower::tape_sizes sizes>
constexpr std::uint64_t digest_of(const lower::fixed_tape<sizes>& of) {
  base::digest all;
  for (int count : {sizes.steps, sizes.numbers, sizes.loads, sizes.results, sizes.linear_steps,
                    sizes.operands, sizes.externals})
    all.take(count);
  for (int i = 0; i < sizes.steps; ++i)
    all.take(of.op[i]), all.take(static_cast<int>(of.paired[i])), all.take(of.a[i]), all.take(of.b[i]);
  for (int i = 0; i < sizes.numbers; ++i)
    all.take(of.numbers[i].numerator), all.take(of.numbers[i].denominator), all.take(of.numbers[i].real);
  for (int i = 0; i < sizes.loads; ++i) all.take(of.loads[i].from), all.take(of.loads[i].position);
  for (int i = 0; i < sizes.results; ++i) all.take(of.results[i]);
  for (int i = 0; i < sizes.linear_steps; ++i) {
    const lower::linear_step& step = of.linear_steps[i];
    all.take(step.op);
    for (int each : {step.order, step.step, step.factors, step.operands}) all.take(each);
  }
  for (int i = 0; i < sizes.operands; ++i) all.take(of.operands[i]);
  take_externals(all, of.externals, sizes.externals);
  return all.value();
}

} // namespace kanexpr::derivation
