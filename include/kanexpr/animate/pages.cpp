#include <kanexpr/animate/camera.hpp>
#include <kanexpr/animate/write_page.ipp>
