#pragma once

#include <kanexpr/animate/animated.hpp>
#include <kanexpr/simulations/tables/table.hpp>

#include <string>

// The files to which a motion is written, as specified on the command line: --page ball.html --csv ball.csv.
class output {
public:
  // Ends the program if the command line is invalid or requests help.
  output(const char* title, const char* about, int count, char** words);

  // Whether all requested files could be written.
  template <class Picture, class Trajectory>
  bool leave(const Trajectory& trajectory) const {
    return (csv_.empty() || write(trajectory.table())) &&
           (page_.empty() || write(kanexpr::animated<Picture>(trajectory)));
  }

private:
  bool write(const kanexpr::table& all) const;
  bool write(const kanexpr::animation& moving) const;

  std::string title_, about_, page_, csv_;
};
