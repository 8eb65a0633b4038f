#include "demo/ride.hpp"

#include <pictures/bicycle.hpp>

std::string demo::write_page_of(const ride& r, const std::string& path, const std::string& title,
                                const std::string& text) {
  return kanexpr::write_page<bicycle::picture>(path, r.trajectory, {.title = title, .text = text}).cause();
}
