#pragma once

#include <kanexpr/base/members.hpp>
#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <optional>
#include <type_traits>

namespace kanexpr::runtime {

/// Calls `use` for each expression of a system or of one of its parts, in the order of the members.
template <class Use>
class each_expression {
public:
  explicit each_expression(const Use& use) : use_(use) {}

  template <class Part>
  void operator()(Part& part) const {
    if constexpr (std::is_scalar_v<Part>)
      return;
    else if constexpr (requires { Part::each_member(part, *this); })
      Part::each_member(part, *this);
    else
      for_each_member(part, *this);
  }
  template <class Part>
  void operator()(base::sequence<Part>& parts) const {
    for (Part& each : parts) (*this)(each);
  }
  template <class Part>
  void operator()(const base::sequence<Part>& parts) const {
    for (const Part& each : parts) (*this)(each);
  }
  template <class Part>
  void operator()(std::optional<Part>& part) const {
    if (part) (*this)(*part);
  }
  template <class Part>
  void operator()(const std::optional<Part>& part) const {
    if (part) (*this)(*part);
  }
  void operator()(symbolic::expression& e) const { use_(e); }
  void operator()(const symbolic::expression& e) const { use_(e); }
  void operator()(base::name&) const {}
  void operator()(const base::name&) const {}

private:
  const Use& use_;
};

} // namespace kanexpr::runtime
