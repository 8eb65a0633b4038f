#pragma once

#include <hdf5.h>

#include <string>
#include <string_view>

namespace kanexpr::ensembles {

/// Keeps the first error that HDF5 has while this lives, of this thread. HDF5 prints none then.
class hdf5_errors {
public:
  hdf5_errors() {
    had_any_ = H5Eget_auto2(H5E_DEFAULT, &before_, &data_) >= 0;
    H5Eset_auto2(H5E_DEFAULT, &note, this);
  }
  hdf5_errors(const hdf5_errors&) = delete;
  hdf5_errors& operator=(const hdf5_errors&) = delete;
  ~hdf5_errors() {
    if (had_any_) H5Eset_auto2(H5E_DEFAULT, before_, data_);
  }

  /// In the words of the system, where it is to blame; empty: there was none.
  const std::string& first() const { return first_; }

private:
  static herr_t note(hid_t stack, void* self) {
    std::string& first = static_cast<hdf5_errors*>(self)->first_;
    if (first.empty()) H5Ewalk2(stack, H5E_WALK_UPWARD, &take_innermost, &first);
    return 0;
  }
  static herr_t take_innermost(unsigned place, const H5E_error2_t* error, void* into) {
    constexpr std::string_view of_system = "error message = '";
    if (place > 0 || !error->desc) return 0;
    std::string_view text = error->desc;
    if (const auto at = text.find(of_system); at != text.npos) {
      text.remove_prefix(at + of_system.size());
      text = text.substr(0, text.find('\''));
    }
    *static_cast<std::string*>(into) = text;
    return 0;
  }

  H5E_auto2_t before_ = nullptr;
  void* data_ = nullptr;
  bool had_any_ = false;
  std::string first_{};
};

} // namespace kanexpr::ensembles
