#pragma once

#include <functional>
#include <vector>

#include "mote/app/sum_fields.hpp"

namespace mote {

/// All numbers of all fields of a task at one target, summed pair by pair in long double, with the
/// functions of a core in double. A point has no part in what it gets itself; of a blob only the
/// velocity gradient has one, the spin of its own core. `task` and `points` must outlive it.
std::function<std::vector<long double>(std::size_t target)> reference_sum(const SumTask& task,
                                                                          const SumPoints& points);

}  // namespace mote
