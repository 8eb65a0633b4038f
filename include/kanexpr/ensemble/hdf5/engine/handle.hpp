#pragma once

#include <hdf5.h>

#include <utility>

namespace kanexpr::ensembles {

/// An object of HDF5, which this closes.
class hdf5_handle {
public:
  using closing = herr_t (*)(hid_t);

  hdf5_handle() = default;
  hdf5_handle(hid_t id, closing by) : id_(id), close_(by) {}
  hdf5_handle(hdf5_handle&& other) noexcept
      : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  hdf5_handle& operator=(hdf5_handle&& other) noexcept {
    std::swap(id_, other.id_), std::swap(close_, other.close_);
    return *this;
  }
  hdf5_handle(const hdf5_handle&) = delete;
  hdf5_handle& operator=(const hdf5_handle&) = delete;
  ~hdf5_handle() { close(); }

  /// Whether it could be made or opened.
  explicit operator bool() const { return id_ >= 0; }
  hid_t id() const { return id_; }

  bool close() {
    const hid_t id = std::exchange(id_, H5I_INVALID_HID);
    return id < 0 || close_(id) >= 0;
  }

private:
  hid_t id_ = H5I_INVALID_HID;
  closing close_ = nullptr;
};

} // namespace kanexpr::ensembles
