#pragma once

#include <hdf5.h>

#include <utility>

namespace kanexpr::ensembles {

/// Owns an object of HDF5.
class hdf5_handle {
public:
  using closing = herr_t (*)(hid_t);

  hdf5_handle() = default;
  hdf5_handle(hid_t id, closing by) : id_(id), close_(by) {}
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
  closing close_ = nullptr;
};

} // namespace kanexpr::ensembles
