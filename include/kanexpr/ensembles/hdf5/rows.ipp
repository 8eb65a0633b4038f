#pragma once

#include <kanexpr/ensembles/hdf5/attributes.ipp>
#include <kanexpr/ensembles/layout.hpp>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr::ensembles {

/// The columns of a row, packed one after another.
class row_columns {
public:
  void add(column_label label, hid_t type) {
    types_.emplace_back(H5Tcopy(type), &H5Tclose);
    labels_.push_back(std::move(label));
    size_ += H5Tget_size(type);
  }
  void add(const std::vector<column_label>& labels) {
    for (const column_label& each : labels) add(each, H5T_NATIVE_DOUBLE);
  }

  std::size_t size() const { return size_; }
  hdf5_handle type() const {
    hdf5_handle all(H5Tcreate(H5T_COMPOUND, size_), &H5Tclose);
    std::size_t offset = 0;
    for (std::size_t i = 0; i < labels_.size(); ++i) {
      if (H5Tinsert(all.id(), labels_[i].name.c_str(), offset, types_[i].id()) < 0) return {};
      offset += H5Tget_size(types_[i].id());
    }
    return all;
  }
  std::vector<std::string> units() const {
    std::vector<std::string> all;
    all.reserve(labels_.size());
    for (const column_label& each : labels_) all.push_back(each.unit);
    return all;
  }

private:
  std::vector<column_label> labels_{};
  std::vector<hdf5_handle> types_{};
  std::size_t size_ = 0;
};

/// A dataset to which rows are appended. Its functions return false on errors of HDF5.
class growing_rows {
  static constexpr std::size_t chunk_bytes = 131072; // several fit into HDF5's cache of a dataset

public:
  bool create(hid_t file, const char* name, const row_columns& columns, int compression) {
    prepare(columns);
    const hsize_t none = 0, most = H5S_UNLIMITED, chunk = chunk_rows_;
    const hdf5_handle space(H5Screate_simple(1, &none, &most), &H5Sclose);
    const hdf5_handle how(H5Pcreate(H5P_DATASET_CREATE), &H5Pclose);
    if (!type_ || H5Pset_chunk(how.id(), 1, &chunk) < 0 || H5Pset_obj_track_times(how.id(), false) < 0 ||
        (compression > 0 && H5Pset_deflate(how.id(), static_cast<unsigned>(compression)) < 0))
      return false;
    rows_ = {H5Dcreate2(file, name, type_.id(), space.id(), H5P_DEFAULT, how.id(), H5P_DEFAULT), &H5Dclose};
    return rows_ && write_attribute(rows_.id(), "units", columns.units());
  }

  bool open(hid_t file, const char* name, const row_columns& columns) {
    prepare(columns);
    rows_ = {H5Dopen2(file, name, H5P_DEFAULT), &H5Dclose};
    const hdf5_handle type(H5Dget_type(rows_.id()), &H5Tclose), space(H5Dget_space(rows_.id()), &H5Sclose);
    return type_ && H5Tequal(type.id(), type_.id()) > 0 &&
           H5Sget_simple_extent_dims(space.id(), &in_file_, nullptr) == 1;
  }

  /// Appends a value to the pending rows, in the order of the columns.
  template <class Value>
  void put(Value value) {
    pending_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void put(std::span<const double> values) {
    pending_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  }
  void put(std::string_view text, std::size_t size) {
    pending_.append(text).append(size - text.size(), '\0');
  }

  bool fills_chunk() const { return pending_.size() >= chunk_rows_ * row_size_; }
  /// Writes the pending rows.
  bool write() {
    const hsize_t count = pending_.size() / row_size_, end = done_ + count;
    if (count == 0) return true;
    if (end > in_file_ && H5Dset_extent(rows_.id(), &end) < 0) return false;
    in_file_ = (std::max)(in_file_, end);
    if (!transfer(done_, count, [&](hid_t memory, hid_t space) {
          return H5Dwrite(rows_.id(), type_.id(), memory, space, H5P_DEFAULT, pending_.data());
        }))
      return false;
    pending_.clear();
    done_ = end;
    return true;
  }

  /// The bytes of the last rows before the position of the next one; empty if they cannot be read.
  std::optional<std::string> last() const {
    const hsize_t count = (std::min)(done_, static_cast<hsize_t>(chunk_rows_ + 1));
    std::string bytes(count * row_size_, '\0');
    const bool is_read = count == 0 || transfer(done_ - count, count, [&](hid_t memory, hid_t space) {
                           return H5Dread(rows_.id(), type_.id(), memory, space, H5P_DEFAULT, bytes.data());
                         });
    return is_read ? std::optional(std::move(bytes)) : std::nullopt;
  }

  hid_t id() const { return rows_.id(); }
  hsize_t done() const { return done_; } ///< the position of the next row
  void resume_at(hsize_t done) { done_ = done; }
  /// True if the file has the rows before the position of the next one.
  bool has_done() const { return done_ <= in_file_; }
  /// Discards rows of an interrupted study after that position.
  bool truncate() { return in_file_ <= done_ || H5Dset_extent(rows_.id(), &done_) >= 0; }
  bool close() { return rows_.close(); }
  void abandon() { rows_.release(); }

private:
  void prepare(const row_columns& columns) {
    *this = growing_rows();
    type_ = columns.type(), row_size_ = columns.size();
    chunk_rows_ = (std::max)(chunk_bytes / row_size_, std::size_t{1});
  }
  template <class Call>
  bool transfer(hsize_t first, hsize_t count, const Call& call) const {
    const hdf5_handle space(H5Dget_space(rows_.id()), &H5Sclose),
        memory(H5Screate_simple(1, &count, nullptr), &H5Sclose);
    return H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, &first, nullptr, &count, nullptr) >= 0 &&
           call(memory.id(), space.id()) >= 0;
  }

  hdf5_handle type_{}, rows_{};
  std::size_t row_size_ = 1, chunk_rows_ = 1;
  std::string pending_{};
  hsize_t done_ = 0, in_file_ = 0; ///< the file of an interrupted study may have more rows
};

} // namespace kanexpr::ensembles
