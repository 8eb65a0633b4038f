#pragma once

#include <kanexpr/ensemble/hdf5/engine/handle.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace kanexpr::ensembles {

/// Texts of UTF-8, of any length.
inline hdf5_handle type_of_texts() {
  hdf5_handle type(H5Tcopy(H5T_C_S1), &H5Tclose);
  H5Tset_size(type.id(), H5T_VARIABLE);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  return type;
}

inline bool write_attribute(hid_t of, const char* name, hid_t type, hid_t space, const void* values) {
  const hdf5_handle attribute(H5Acreate2(of, name, type, space, H5P_DEFAULT, H5P_DEFAULT), &H5Aclose);
  return attribute && H5Awrite(attribute.id(), type, values) >= 0;
}

inline bool write_attribute(hid_t of, const char* name, std::uint64_t number) {
  const hdf5_handle space(H5Screate(H5S_SCALAR), &H5Sclose);
  return write_attribute(of, name, H5T_NATIVE_UINT64, space.id(), &number);
}

inline bool write_attribute(hid_t of, const char* name, const std::string& text) {
  const hdf5_handle space(H5Screate(H5S_SCALAR), &H5Sclose), type = type_of_texts();
  const char* const first = text.c_str();
  return write_attribute(of, name, type.id(), space.id(), static_cast<const void*>(&first));
}

inline bool write_attribute(hid_t of, const char* name, const std::vector<std::string>& texts) {
  const hsize_t count = texts.size();
  const hdf5_handle space(H5Screate_simple(1, &count, nullptr), &H5Sclose), type = type_of_texts();
  std::vector<const char*> all;
  all.reserve(texts.size());
  for (const std::string& each : texts) all.push_back(each.c_str());
  return write_attribute(of, name, type.id(), space.id(), static_cast<const void*>(all.data()));
}

} // namespace kanexpr::ensembles
