#pragma once

#include <kanexpr/base/version.hpp>
