#pragma once

#include <hdf5.h>

#include <string>

namespace kanexpr::ensembles {

/// While it exists, keeps the first error of HDF5 on this thread, instead of printing errors.
class hdf5_errors {
public:
  hdf5_errors() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, &keep, this);
  }
  hdf5_errors(const hdf5_errors&) = delete;
  hdf5_errors& operator=(const hdf5_errors&) = delete;
  ~hdf5_errors() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }

  /// The message of the operating system if it refused an operation, else that of HDF5; empty if there is
  /// none.
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

} // namespace kanexpr::ensembles
