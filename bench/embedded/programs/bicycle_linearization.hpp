#pragma once

#include "bicycle.hpp"
#include "linearization.hpp"

/// A and B of the bicycle, in its independent states.
struct program : embedded::linearization_of<embedded::bicycle::calls> {};
