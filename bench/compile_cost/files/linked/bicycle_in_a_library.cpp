#include <linked_bicycle.hpp>

#include "../engine/bicycle_all_uses.cpp"
