#pragma once

#include <kanexpr/ensemble/hdf5/engine/attributes.hpp>
#include <kanexpr/ensemble/layout.hpp>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::ensembles {

/// The columns of a row, one behind another without gaps.
class row_columns {
public:
  void add(column_label label, hid_t type) {
    types_.emplace_back(H5Tcopy(type), &H5Tclose);
    labels_.push_back(std::move(label));
    size_ += H5Tget_size(types_.back().id());
  }
  void add_text(std::string name, std::size_t size) {
    const hdf5_handle type(H5Tcopy(H5T_C_S1), &H5Tclose);
    H5Tset_size(type.id(), size);
    H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
    H5Tset_cset(type.id(), H5T_CSET_UTF8);
    add({std::move(name)}, type.id());
  }

  std::size_t size() const { return size_; }
  hdf5_handle type() const {
    hdf5_handle all(H5Tcreate(H5T_COMPOUND, size_), &H5Tclose);
    std::size_t at = 0;
    for (std::size_t i = 0; i < labels_.size(); ++i) {
      if (H5Tinsert(all.id(), labels_[i].name.c_str(), at, types_[i].id()) < 0) return {};
      at += H5Tget_size(types_[i].id());
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

/// A dataset to which rows are added. Its functions say whether HDF5 could do it.
class growing_rows {
  static constexpr std::size_t bytes_of_chunk = 131072; // several fit into HDF5's cache of a dataset

public:
  bool create(hid_t file, const char* name, const row_columns& columns, int compression) {
    prepare(columns);
    const hsize_t none = 0, most = H5S_UNLIMITED, chunk = rows_of_chunk_;
    const hdf5_handle space(H5Screate_simple(1, &none, &most), &H5Sclose);
    const hdf5_handle how(H5Pcreate(H5P_DATASET_CREATE), &H5Pclose);
    if (!type_ || H5Pset_chunk(how.id(), 1, &chunk) < 0 || H5Pset_obj_track_times(how.id(), false) < 0)
      return false;
    if (compression > 0 && H5Pset_deflate(how.id(), static_cast<unsigned>(compression)) < 0) return false;
    rows_ = {H5Dcreate2(file, name, type_.id(), space.id(), H5P_DEFAULT, how.id(), H5P_DEFAULT), &H5Dclose};
    return rows_ && write_attribute(rows_.id(), "units", columns.units());
  }

  bool open(hid_t file, const char* name, const row_columns& columns) {
    prepare(columns);
    if (H5Lexists(file, name, H5P_DEFAULT) <= 0) return false;
    rows_ = {H5Dopen2(file, name, H5P_DEFAULT), &H5Dclose};
    const hdf5_handle type(H5Dget_type(rows_.id()), &H5Tclose), space(H5Dget_space(rows_.id()), &H5Sclose);
    return type_ && H5Tequal(type.id(), type_.id()) > 0 &&
           H5Sget_simple_extent_dims(space.id(), &in_file_, nullptr) == 1;
  }

  /// Rows are put together of their values, in the order of the columns.
  template <class Value>
  void put(Value value) {
    waiting_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void put(std::span<const double> values) {
    waiting_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  }
  void put(std::string_view text, std::size_t size) {
    waiting_ += text;
    waiting_.append(size - text.size(), '\0');
  }

  bool has_many_waiting() const { return waiting_.size() >= rows_of_chunk_ * row_size_; }
  bool write() {
    const hsize_t count = waiting_.size() / row_size_, end = done_ + count;
    if (count == 0) return true;
    if (end > in_file_ && H5Dset_extent(rows_.id(), &end) < 0) return false;
    in_file_ = (std::max)(in_file_, end);
    const hdf5_handle space(H5Dget_space(rows_.id()), &H5Sclose),
        memory(H5Screate_simple(1, &count, nullptr), &H5Sclose);
    if (H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, &done_, nullptr, &count, nullptr) < 0 ||
        H5Dwrite(rows_.id(), type_.id(), memory.id(), space.id(), H5P_DEFAULT, waiting_.data()) < 0)
      return false;
    waiting_.clear();
    done_ = end;
    return true;
  }

  /// The bytes of the last rows before the next one, or of all; none where they cannot be read.
  std::optional<std::string> last() const {
    const hsize_t count = (std::min)(done_, hsize_t{bytes_of_chunk} / row_size_ + 1), first = done_ - count;
    std::string bytes(count * row_size_, '\0');
    if (count == 0) return bytes;
    const hdf5_handle space(H5Dget_space(rows_.id()), &H5Sclose),
        memory(H5Screate_simple(1, &count, nullptr), &H5Sclose);
    if (H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, &first, nullptr, &count, nullptr) < 0 ||
        H5Dread(rows_.id(), type_.id(), memory.id(), space.id(), H5P_DEFAULT, bytes.data()) < 0)
      return {};
    return bytes;
  }

  hid_t id() const { return rows_.id(); }
  hsize_t done() const { return done_; }
  hsize_t in_file() const { return in_file_; } ///< some may be there already, of an interrupted study
  /// The next row comes behind so many.
  void go_on(hsize_t done) { done_ = done; }
  bool close() { return rows_.close(); }

private:
  void prepare(const row_columns& columns) {
    *this = growing_rows();
    type_ = columns.type(), row_size_ = columns.size();
    rows_of_chunk_ = (std::max)(bytes_of_chunk / row_size_, std::size_t{1});
  }

  hdf5_handle type_{}, rows_{};
  std::size_t row_size_ = 1, rows_of_chunk_ = 1;
  std::string waiting_{};
  hsize_t done_ = 0, in_file_ = 0;
};

} // namespace kanexpr::ensembles
