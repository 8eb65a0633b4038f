#pragma once

#include <kanexpr/describe/system.hpp>

namespace kanexpr {

namespace describe {

/// Inputs added after those of a system without a list of inputs.
template <auto... symbols>
struct added_inputs : phrase_list<"inputs", &system_record::added_inputs, symbols...> {};

/// A word that the system does not contain yet. Inputs are added by a separate word, because a new list of
/// inputs would have to include those that the system mentions.
template <class Word>
struct added_word {
  using type = Word;
};
template <auto... symbols>
struct added_word<inputs<symbols...>> {
  using type = added_inputs<symbols...>;
};

/// Merges two words of the same kind.
template <class Word, class Added>
struct merged_words {
  static constexpr bool is_one = false;
};
template <template <auto...> class Word, auto... existing, auto... added>
struct merged_words<Word<existing...>, Word<added...>> {
  static constexpr bool is_one = true;
  using type = Word<existing..., added...>;
};
template <template <class...> class Word, class... Existing, class... Added>
struct merged_words<Word<Existing...>, Word<Added...>> {
  static constexpr bool is_one = true;
  using type = Word<Existing..., Added...>;
};
template <auto... existing, auto... added>
struct merged_words<added_inputs<existing...>, inputs<added...>> {
  static constexpr bool is_one = true;
  using type = added_inputs<existing..., added...>;
};

/// Adds words to a system. `Before` contains the words that were already compared and are of different kinds.
template <method by, class Before, class After, class... Added>
struct extended_words;
template <class... Words>
struct word_list {};

template <method by, class... Words>
struct extended_words<by, word_list<>, word_list<Words...>> {
  using type = system_of_words<by, Words...>;
};
template <method by, class... Before, class Word, class... After, class Added, class... More>
struct extended_words<by, word_list<Before...>, word_list<Word, After...>, Added, More...>
    : extended_words<by, word_list<Before..., Word>, word_list<After...>, Added, More...> {};
template <method by, class... Before, class Word, class... After, class Added, class... More>
  requires(merged_words<Word, Added>::is_one)
struct extended_words<by, word_list<Before...>, word_list<Word, After...>, Added, More...>
    : extended_words<by, word_list<>,
                     word_list<Before..., typename merged_words<Word, Added>::type, After...>, More...> {};
template <method by, class... Before, class Added, class... More>
struct extended_words<by, word_list<Before...>, word_list<>, Added, More...>
    : extended_words<by, word_list<>, word_list<Before..., typename added_word<Added>::type>, More...> {};

/// Marks the extension of something that is not a system.
template <class Base>
struct extends_no_system {
  using extended_base = Base;
};

template <class Base, class... Added>
struct extension {
  static auto words(const volatile void*) -> system_of_words<method::kane, extends_no_system<Base>>;
  template <method by, class... Words>
  static auto words(const system_of_words<by, Words...>*) ->
      typename extended_words<by, word_list<>, word_list<Words...>, Added...>::type;

  using type = decltype(words(static_cast<const Base*>(nullptr)));
};

} // namespace describe

/// A system with additional loads, inputs or other words, which follow the existing ones. The system may list
/// its inputs or only mention them: `struct Pushed : extended<System, inputs<F>, loads<force<P, F * N::x>>>
/// {};`
template <class System, class... Words>
struct extended : describe::extension<System, Words...>::type {};

} // namespace kanexpr
