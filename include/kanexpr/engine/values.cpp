#include <kanexpr/compiled/values_reader.ipp>
