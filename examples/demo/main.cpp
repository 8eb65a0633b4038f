#include "demo/parts.hpp"

/// Systems from their types to numbers and pictures. demo FOLDER leaves the motions of a bicycle there.
int main(int count, char** words) {
  const bool disc = demo::show_rolling_disc();
  const bool arm = demo::show_iiwa();
  const bool bicycle = demo::show_bicycle();
  const bool rides = demo::show_rides(count > 1 ? words[1] : ".");
  return disc && arm && bicycle && rides ? 0 : 1;
}
