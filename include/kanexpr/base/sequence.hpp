#pragma once

#include <initializer_list>

namespace kanexpr::base {

/// A growable array for constant evaluation.
///
/// The compiler interprets every call, so this thin class halves the time of a derivation compared with
/// `std::vector`.
template <class Element>
class sequence {
public:
  constexpr sequence() = default;
  constexpr explicit sequence(int size) { resize(size); }
  constexpr explicit sequence(int size, const Element& value) { resize(size, value); }
  constexpr sequence(std::initializer_list<Element> values) {
    reserve(static_cast<int>(values.size()));
    for (const Element& value : values) push(value);
  }
  constexpr sequence(const sequence& other) {
    reserve(other.size_);
    for (int i = 0; i < other.size_; ++i) data_[i] = other.data_[i];
    size_ = other.size_;
  }
  constexpr sequence(sequence&& other) noexcept {
    if (other.capacity_ != 0) swap(other);
  }
  constexpr sequence& operator=(const sequence& other) {
    sequence copy(other);
    swap(copy);
    return *this;
  }
  constexpr sequence& operator=(sequence&& other) noexcept {
    if (other.capacity_ != 0 || capacity_ != 0) swap(other);
    return *this;
  }
  constexpr ~sequence() { delete[] data_; }

  constexpr int size() const { return size_; }
  constexpr bool empty() const { return size_ == 0; }
  constexpr Element& operator[](int i) { return data_[i]; }
  constexpr const Element& operator[](int i) const { return data_[i]; }
  constexpr Element& back() { return data_[size_ - 1]; }
  constexpr const Element& back() const { return data_[size_ - 1]; }
  constexpr Element* begin() { return data_; }
  constexpr Element* end() { return data_ + size_; }
  constexpr const Element* begin() const { return data_; }
  constexpr const Element* end() const { return data_ + size_; }

  constexpr int push(const Element& value) {
    if (size_ == capacity_) return push_and_grow(value);
    data_[size_] = value;
    return size_++;
  }
  constexpr int push(Element&& value)
    requires(!__is_trivially_copyable(Element))
  {
    if (size_ == capacity_) return push_and_grow(static_cast<Element&&>(value));
    data_[size_] = static_cast<Element&&>(value);
    return size_++;
  }
  constexpr void append(const sequence& values) {
    for (const Element& value : values) push(value);
  }
  constexpr void pop() { --size_; }
  constexpr void clear() { size_ = 0; }
  constexpr void resize(int size) {
    if constexpr (!__is_trivially_constructible(Element)) {
      if (size > capacity_) { // the default constructor has initialized the new elements already
        reserve(size);
        size_ = size;
        return;
      }
    }
    resize(size, Element{});
  }
  constexpr void resize(int size, const Element& value) {
    reserve(size);
    for (int i = size_; i < size; ++i) data_[i] = value;
    size_ = size;
  }
  constexpr void reserve(int capacity) {
    if (capacity <= capacity_) return;
    Element* const grown = new Element[static_cast<unsigned>(capacity)];
    for (int i = 0; i < size_; ++i) grown[i] = static_cast<Element&&>(data_[i]);
    delete[] data_;
    data_ = grown;
    capacity_ = capacity;
  }
  constexpr bool contains(const Element& value) const { return find(value) >= 0; }
  constexpr bool contains_all(const sequence& values) const {
    for (const Element& value : values)
      if (!contains(value)) return false;
    return true;
  }
  /// Returns the position of the first element equal to `value`, or -1.
  constexpr int find(const Element& value) const {
    for (int i = 0; i < size_; ++i)
      if (data_[i] == value) return i;
    return -1;
  }

private:
  /// Arrays of large elements are usually short and start with a small capacity, because all of it is
  /// initialized.
  struct element {
    Element value;
  };
  static constexpr int first_capacity = sizeof(element) > 40 ? 2 : 8;

  constexpr int push_and_grow(Element value) { // by value, because it may be an element of this array
    reserve(capacity_ < first_capacity ? first_capacity : 2 * capacity_);
    data_[size_] = static_cast<Element&&>(value);
    return size_++;
  }
  constexpr void swap(sequence& other) noexcept {
    Element* const data = data_;
    const int size = size_, capacity = capacity_;
    data_ = other.data_, size_ = other.size_, capacity_ = other.capacity_;
    other.data_ = data, other.size_ = size, other.capacity_ = capacity;
  }

  Element* data_ = nullptr;
  int size_ = 0;
  int capacity_ = 0;
};

} // namespace kanexpr::base
