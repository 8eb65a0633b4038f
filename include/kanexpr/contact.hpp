#pragma once

/// Contacts between bodies and their friction, as loads.
#include <kanexpr/describe/contact.hpp>
#include <kanexpr/describe/friction.hpp>
