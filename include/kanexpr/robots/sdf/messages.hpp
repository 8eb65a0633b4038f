#pragma once

#include <kanexpr/robots/urdf/document.hpp>

#include <sdf/Console.hh>

#include <ostream>
#include <sstream>
#include <string>

namespace kanexpr::robots::sdf {

/// Captures the messages that libsdformat would print. (libsdformat passes text that is not SDF to urdfdom,
/// which still prints a line.)
class messages {
public:
  messages() : stream_(::sdf::Console::Instance()->GetMsgStream()), to_(stream_.GetStream()) {
    stream_.SetStream(&kept_);
  }
  ~messages() { stream_.SetStream(to_); }
  messages(const messages&) = delete;
  messages& operator=(const messages&) = delete;

  /// Notes the elements and attributes that libsdformat does not know, except those of mimics, which are read
  /// elsewhere.
  void note_in(urdf::document& from) const {
    std::istringstream all(kept_.str());
    for (std::string line; std::getline(all, line);) {
      const std::size_t is = line.find(" XML "), end = line.find(" not defined in SDF");
      if (is == line.npos || end == line.npos || line.find("Element[mimic]") != line.npos) continue;
      const std::size_t place = line.rfind(":L", is);
      const auto number = urdf::number_in(
          place == line.npos ? "" : line.substr(place + 2, line.find(']', place) - place - 2));
      from.note(static_cast<int>(number.value_or(1)),
                "libsdformat reports: " + shown(line.substr(is + 1, end - is - 1), 200) +
                    " not defined in SDF; it is ignored");
    }
  }

private:
  std::ostringstream kept_{};
  ::sdf::Console::ConsoleStream& stream_;
  std::ostream* to_;
};

} // namespace kanexpr::robots::sdf
