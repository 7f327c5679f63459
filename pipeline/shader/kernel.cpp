#include "pipeline/shader/kernel.hpp"

namespace caustics {

constinit thread_local std::uint64_t operations_of_thread = 0;

}  // namespace caustics
