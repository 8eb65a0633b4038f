#pragma once

/// Tyres, as loads on wheels.
#include <kanexpr/describe/blocks/tyre.hpp>
#include <kanexpr/describe/tyre_record.hpp>
#include <kanexpr/describe/tyre_words.hpp>
#include <kanexpr/wheels.hpp>
