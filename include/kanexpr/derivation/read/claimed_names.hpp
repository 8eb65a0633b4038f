#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/read/listed_by.hpp>
#include <kanexpr/derivation/read/reading.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// The names in use; each must have only one meaning in a system.
class claimed_names {
public:
  constexpr explicit claimed_names(reading& all) : reading_(all) {}

  /// The stored names, if there is no mistake.
  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.claimed_);
  }

  constexpr int size() const { return claimed_.size(); }
  constexpr void forget_all_but(int known) {
    while (claimed_.size() > known) claimed_.pop();
  }

  /// `mark` identifies the symbol with the name among those of its kind.
  constexpr void claim(const base::name& called, symbol_list list, int mark = 0) {
    const int length = called.length, last = length > 0 ? length - 1 : 0;
    for (const claimed& other : claimed_) // names often differ only in the last letter
      if (other.called.length == length && other.called.letters[last] == called.letters[last] &&
          other.called == called)
        fail_by_second_use(called, list, other.list, other.mark == mark);
    claimed_.push({called, list, mark});
  }

  /// Checks that a symbol found by its name is the one that claimed the name.
  constexpr void check_mark(const base::name& called, int mark, std::string_view kind) {
    for (const claimed& c : claimed_)
      if (c.mark != mark && c.called.length == called.length && c.called == called)
        reading_.fail({"two ", kind, "s are called ", called.view()});
  }

private:
  struct claimed {
    base::name called{};
    symbol_list list{};
    int mark = 0;
  };

  constexpr void fail_by_second_use(const base::name& called, symbol_list list, symbol_list before,
                                    bool is_the_same) {
    if (before == list && !is_the_same)
      reading_.fail({"two of the ", derivation::called(list), " are called ", called.view()});
    else if (before == list)
      reading_.fail({called.view(), " is listed twice among the ", derivation::called(list),
                     listed_by(reading_.from, called).ending()});
    else if (before == symbol_list::values)
      reading_.fail(
          {"parameter ", called.view(), " is bound to a value, but is also in the list of parameters"});
    else
      reading_.fail({"the name ", called.view(), " is used twice: among the ", derivation::called(before),
                     " and among the ", derivation::called(list)});
  }

  reading& reading_;
  sequence<claimed> claimed_{};
};

} // namespace kanexpr::derivation
