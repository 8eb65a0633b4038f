#include <kanexpr/animate/camera.hpp>
#include <kanexpr/animate/page_file.hpp>
