#pragma once

#include <kanexpr/ensemble/hdf5/engine/handle.hpp>

#if __has_include(<H5FDdevelop.h>)
#include <H5FDdevelop.h>
#endif

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace kanexpr::ensembles {

/// How HDF5 reads and writes a file: as its own driver does, but no writing fails for HDF5, which would not
/// survive it. What it has not written it tries to write again when the file is closed, and once more when
/// the program ends, and then it crashes. So from the first failure on, all stays in memory, and the file
/// stays as it is on the disk.
class disk {
public:
  /// Says why writing failed, or opening; empty: it did not.
  std::string failure() const {
    return error_ == 0 ? std::string() : std::generic_category().message(error_);
  }
  bool has_failed() const { return error_ != 0; }

  /// Has HDF5 open files by this, which must live until they are closed.
  bool use(hid_t access) {
    if (!driver_) driver_ = {H5FDregister(&functions()), &H5FDunregister};
    const info mine{this};
    return driver_ && H5Pset_driver(access, driver_.id(), &mine) >= 0;
  }

private:
  struct info {
    disk* of;
  };
  struct open_file : H5FD_t {
    explicit open_file(disk& one) : H5FD_t(), of(one) {}
    disk& of;
    int descriptor = -1;
    haddr_t allocated = 0, end = 0;
    std::vector<std::pair<haddr_t, std::string>> kept{}; ///< what was written behind a failure, in its order
  };
  static open_file& file(H5FD_t* one) { return *static_cast<open_file*>(one); }
  static const open_file& file(const H5FD_t* one) { return *static_cast<const open_file*>(one); }

  static H5FD_t* open(const char* name, unsigned flags, hid_t access, haddr_t) {
    disk& of = *static_cast<const info*>(H5Pget_driver_info(access))->of;
    const int how = (flags & H5F_ACC_RDWR ? O_RDWR : O_RDONLY) | (flags & H5F_ACC_TRUNC ? O_TRUNC : 0) |
                    (flags & H5F_ACC_CREAT ? O_CREAT : 0) | (flags & H5F_ACC_EXCL ? O_EXCL : 0);
    auto one = std::make_unique<open_file>(of);
    one->descriptor = ::open(name, how | O_CLOEXEC, 0666);
    struct stat found{};
    const bool is_open = one->descriptor >= 0 && ::fstat(one->descriptor, &found) == 0;
    of.error_ = is_open ? 0 : errno;
    one->end = static_cast<haddr_t>(found.st_size);
    return is_open ? one.release() : nullptr;
  }
  static herr_t close(H5FD_t* one) {
    ::close(file(one).descriptor);
    delete &file(one);
    return 0;
  }

  static herr_t query(const H5FD_t*, unsigned long* flags) {
    *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
             H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_SUPPORTS_SWMR_IO | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
    return 0;
  }
  static haddr_t allocated(const H5FD_t* one, H5FD_mem_t) { return file(one).allocated; }
  static herr_t allocate(H5FD_t* one, H5FD_mem_t, haddr_t size) {
    file(one).allocated = size;
    return 0;
  }
  static haddr_t end(const H5FD_t* one, H5FD_mem_t) { return file(one).end; }

  static herr_t read(H5FD_t* one, H5FD_mem_t, hid_t, haddr_t from, std::size_t size, void* into) {
    char* const to = static_cast<char*>(into);
    std::size_t done = 0;
    while (done < size) {
      const auto count =
          ::pread(file(one).descriptor, to + done, size - done, static_cast<::off_t>(from + done));
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) return -1;
      if (count == 0) break;
      done += static_cast<std::size_t>(count);
    }
    std::memset(to + done, 0, size - done); // behind the end
    for (const auto& [at, bytes] : file(one).kept) {
      const haddr_t first = (std::max)(at, from), last = (std::min)(at + bytes.size(), from + size);
      if (first < last) std::memcpy(to + (first - from), bytes.data() + (first - at), last - first);
    }
    return 0;
  }

  static herr_t write(H5FD_t* one, H5FD_mem_t, hid_t, haddr_t to, std::size_t size, const void* from) {
    open_file& into = file(one);
    const char* const bytes = static_cast<const char*>(from);
    std::size_t done = 0;
    while (done < size && into.of.error_ == 0) {
      const auto count =
          ::pwrite(into.descriptor, bytes + done, size - done, static_cast<::off_t>(to + done));
      if (count < 0 && errno != EINTR) into.of.error_ = errno;
      if (count > 0) done += static_cast<std::size_t>(count);
    }
    if (done < size) into.kept.emplace_back(to + done, std::string(bytes + done, size - done));
    into.end = (std::max)(into.end, to + size);
    return 0;
  }

  /// Only of drivers that could lock files does HDF5 mark them as open. They are held otherwise,
  /// held_file.hpp.
  static herr_t lock(H5FD_t*, hbool_t) { return 0; }
  static herr_t unlock(H5FD_t*) { return 0; }

  static herr_t truncate(H5FD_t* one, hid_t, hbool_t) {
    open_file& of = file(one);
    if (of.end != of.allocated && of.of.error_ == 0 &&
        ::ftruncate(of.descriptor, static_cast<::off_t>(of.allocated)) != 0)
      of.of.error_ = errno;
    of.end = of.allocated;
    return 0;
  }

  static const H5FD_class_t& functions() {
    static const H5FD_class_t all = [] {
      H5FD_class_t f{};
#ifdef H5FD_CLASS_VERSION
      f.version = H5FD_CLASS_VERSION, f.value = 511; // of those that are nobody's
#endif
      f.name = "kanexpr";
      f.maxaddr = static_cast<haddr_t>((std::numeric_limits<::off_t>::max)());
      f.fc_degree = H5F_CLOSE_WEAK;
      f.fapl_size = sizeof(info);
      f.open = &open, f.close = &close, f.query = &query;
      f.get_eoa = &allocated, f.set_eoa = &allocate, f.get_eof = &end;
      f.read = &read, f.write = &write, f.truncate = &truncate, f.lock = &lock, f.unlock = &unlock;
      const H5FD_mem_t kinds[] = H5FD_FLMAP_DICHOTOMY;
      std::copy(std::begin(kinds), std::end(kinds), f.fl_map);
      return f;
    }();
    return all;
  }

  int error_ = 0;
  hdf5_handle driver_{};
};

} // namespace kanexpr::ensembles
