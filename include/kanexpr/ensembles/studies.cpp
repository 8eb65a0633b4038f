#include <kanexpr/ensembles/thread_pool.ipp>
