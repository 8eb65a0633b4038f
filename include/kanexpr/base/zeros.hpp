#pragma once

#include <type_traits>

namespace kanexpr::base {

/// An array of numbers that are initially zero, for marks at the nodes of a graph.
///
/// In constant evaluation, writing a single element takes as long as a function call. The members of a class
/// are all set to zero in one step, however, and only those that are written later take time and memory.
/// Therefore, arrays have a fixed size there, of which the rest remains unused.
///
/// g++ remembers every address that is computed from a pointer. The most frequent loops therefore use
/// `elements<true>()` in constant evaluation, a reference to that array of fixed size: it costs a third of
/// the time and almost no memory. At run time they use `elements<false>()`, a pointer.
template <class Number>
class zeros {
public:
  static constexpr int room = 1 << 22; ///< in constant evaluation

  /// What `elements` refers to.
  template <bool is_constant>
  using array = std::conditional_t<is_constant, Number[room], Number*>;

  constexpr zeros() = default;
  constexpr explicit zeros(int size) : size_(size) {
    if (__builtin_is_constant_evaluated() && size <= room) {
      block_ = new block();
      data_ = block_->value;
    } else {
      data_ = new Number[static_cast<unsigned>(size)]();
    }
  }
  zeros(const zeros&) = delete;
  zeros& operator=(const zeros&) = delete;
  constexpr zeros(zeros&& other) noexcept { swap(other); }
  constexpr zeros& operator=(zeros&& other) noexcept {
    swap(other);
    return *this;
  }
  constexpr ~zeros() {
    if (block_ != nullptr)
      delete block_;
    else
      delete[] data_;
  }

  /// Adds zeros at the end.
  constexpr void grow(int size) {
    if (size <= size_) return;
    if (block_ != nullptr && size <= room) {
      size_ = size;
      return;
    }
    zeros more(size);
    for (int i = 0; i < size_; ++i) more.data_[i] = data_[i];
    swap(more);
  }

  template <bool is_constant>
  constexpr auto& elements() {
    if constexpr (is_constant)
      return block_->value;
    else
      return data_;
  }
  template <bool is_constant>
  constexpr const auto& elements() const {
    if constexpr (is_constant)
      return block_->value;
    else
      return data_;
  }

  constexpr int size() const { return size_; }
  constexpr Number& operator[](int i) { return data_[i]; }
  constexpr const Number& operator[](int i) const { return data_[i]; }
  constexpr Number* begin() { return data_; }
  constexpr const Number* begin() const { return data_; }
  constexpr Number* end() { return data_ + size_; }
  constexpr const Number* end() const { return data_ + size_; }

private:
  struct block {
    Number value[room]{};
  };

  constexpr void swap(zeros& other) noexcept {
    block* const kept = block_;
    Number* const data = data_;
    const int size = size_;
    block_ = other.block_, data_ = other.data_, size_ = other.size_;
    other.block_ = kept, other.data_ = data, other.size_ = size;
  }

  block* block_ = nullptr; ///< only in constant evaluation
  Number* data_ = nullptr;
  int size_ = 0;
};

} // namespace kanexpr::base
