#pragma once

#include <csignal>
#include <cstdint>
#include <fstream>
#include <limits>
#include <string>

#include <unistd.h>

namespace kanexpr::mpi {

/// The process that has started another one of this machine; 0 where that is none.
inline std::int64_t parent_of(std::int64_t process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/stat");
  in.ignore((std::numeric_limits<std::streamsize>::max)(), ')'); // behind its name
  std::string state;
  std::int64_t parent = 0;
  in >> state >> parent;
  return in ? parent : 0;
}

/// Ends a process that was started by the same one as this, also one that is stopped.
inline void end_sibling(std::int64_t process) {
  if (process != ::getpid() && parent_of(process) == ::getppid())
    ::kill(static_cast<::pid_t>(process), SIGKILL);
}

} // namespace kanexpr::mpi
