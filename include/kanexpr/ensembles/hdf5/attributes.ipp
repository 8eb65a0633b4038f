#pragma once

#include <kanexpr/ensembles/hdf5/handle.ipp>

#include <cstdint>
#include <string>
#include <vector>

namespace kanexpr::ensembles {

/// The type of texts: UTF-8, of this size in bytes.
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

} // namespace kanexpr::ensembles
