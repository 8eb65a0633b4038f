#include <kanexpr/ensemble/engine/thread_pool.hpp>
