#pragma once

#include <kanexpr/ensembles/study_interface.hpp>

#include <hdf5.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// HDF5 objects and errors.
namespace kanexpr::ensembles {

/// Owns an HDF5 object.
class hdf5_handle {
public:
  hdf5_handle() = default;
  hdf5_handle(hid_t id, herr_t (*closing)(hid_t)) : id_(id), close_(closing) {}
  hdf5_handle(hdf5_handle&& other) noexcept : id_(other.release()), close_(other.close_) {}
  hdf5_handle& operator=(hdf5_handle&& other) noexcept {
    std::swap(id_, other.id_), std::swap(close_, other.close_);
    return *this;
  }
  ~hdf5_handle() { close(); }

  /// False if the object could not be created or opened.
  explicit operator bool() const { return id_ >= 0; }
  hid_t id() const { return id_; }
  hid_t release() { return std::exchange(id_, H5I_INVALID_HID); }
  bool close() {
    const hid_t id = release();
    return id < 0 || close_(id) >= 0;
  }

private:
  hid_t id_ = H5I_INVALID_HID;
  herr_t (*close_)(hid_t) = nullptr;
};

/// During its lifetime, records the first HDF5 error on this thread, and prevents HDF5 from printing errors.
class hdf5_errors {
public:
  hdf5_errors() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, &keep, this);
  }
  hdf5_errors(const hdf5_errors&) = delete;
  hdf5_errors& operator=(const hdf5_errors&) = delete;
  ~hdf5_errors() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }

  /// Returns the message of the operating system if it refused an operation, otherwise that of HDF5; empty if
  /// there was no error.
  const std::string& first() const { return first_; }

private:
  static herr_t keep(hid_t stack, void* self) {
    std::string& first = static_cast<hdf5_errors*>(self)->first_;
    if (first.empty()) H5Ewalk2(stack, H5E_WALK_UPWARD, &take_innermost, &first);
    return 0;
  }
  static herr_t take_innermost(unsigned place, const H5E_error2_t* error, void* into) {
    if (place > 0 || error->desc == nullptr) return 0;
    const std::string begin = "error message = '", text = error->desc;
    const auto at = text.find(begin), from = at == text.npos ? 0 : at + begin.size();
    *static_cast<std::string*>(into) = text.substr(from, at == text.npos ? at : text.find('\'', from) - from);
    return 0;
  }

  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
  std::string first_{};
};

/// Returns the type of a UTF-8 string of the given size in bytes.
inline hdf5_handle text_type(std::size_t size = H5T_VARIABLE) {
  hdf5_handle type(H5Tcopy(H5T_C_S1), &H5Tclose);
  H5Tset_size(type.id(), size);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  if (size != H5T_VARIABLE) H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
  return type;
}

/// Writes an attribute of one value or, if `count` is not 0, of several values.
inline bool write_attribute(hid_t of, const char* name, hid_t type, const void* values, hsize_t count = 0) {
  const hdf5_handle space(count > 0 ? H5Screate_simple(1, &count, nullptr) : H5Screate(H5S_SCALAR),
                          &H5Sclose);
  const hdf5_handle attribute(H5Acreate2(of, name, type, space.id(), H5P_DEFAULT, H5P_DEFAULT), &H5Aclose);
  return attribute && H5Awrite(attribute.id(), type, values) >= 0;
}
inline bool write_attribute(hid_t of, const char* name, std::uint64_t number) {
  return write_attribute(of, name, H5T_NATIVE_UINT64, &number);
}
inline bool write_attribute(hid_t of, const char* name, const std::string& text) {
  const char* const first = text.c_str();
  return write_attribute(of, name, text_type().id(), static_cast<const void*>(&first));
}
inline bool write_attribute(hid_t of, const char* name, const std::vector<std::string>& texts) {
  std::vector<const char*> all;
  all.reserve(texts.size());
  for (const std::string& each : texts) all.push_back(each.c_str());
  return write_attribute(of, name, text_type().id(), static_cast<const void*>(all.data()), all.size());
}

/// The type of rows with named columns, packed one after another.
class row_type {
public:
  row_type() = default;
  row_type(std::initializer_list<std::pair<column_label, hid_t>> first,
           std::span<const column_label> numbers = {}) {
    for (const auto& [label, column] : first) add(label, column);
    for (const column_label& each : numbers) add(each, H5T_NATIVE_DOUBLE);
  }

  /// After a failure, for example because the name already exists, the type is invalid.
  void add(const column_label& label, hid_t column) {
    const std::size_t offset = size_;
    size_ += H5Tget_size(column);
    units_.push_back(label.unit);
    if (offset == 0)
      type_ = {H5Tcreate(H5T_COMPOUND, size_), &H5Tclose};
    else if (type_)
      H5Tset_size(type_.id(), size_);
    if (type_ && H5Tinsert(type_.id(), label.name.c_str(), offset, column) < 0) type_ = {};
  }

  explicit operator bool() const { return static_cast<bool>(type_); }
  hid_t id() const { return type_.id(); }
  std::size_t size() const { return size_; } ///< the size of a row in bytes
  const std::vector<std::string>& units() const { return units_; }

private:
  hdf5_handle type_{};
  std::size_t size_ = 0;
  std::vector<std::string> units_{};
};

} // namespace kanexpr::ensembles
