#pragma once

#include <kanexpr/animate/animated.hpp>
#include <kanexpr/simulations/tables/table.hpp>

#include <string>

// The files that a motion is left in, as the command line asks: --page ball.html --csv ball.csv.
class output {
public:
  // Ends the program where the command line is wrong, or asks for help.
  output(const char* title, const char* about, int count, char** words);

  // Whether all that was asked for could be written.
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
