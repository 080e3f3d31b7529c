#pragma once

#include <vector>

#include "mote/app/sum_fields.hpp"

namespace mote {

/// The most targets at which a sum is verified.
inline constexpr std::size_t verified_targets = 200;

/// The largest error of each field over its largest value at any target, at sampled targets: all,
/// or one drawn from each of `verified_targets` stretches of the file. What is right is summed pair
/// by pair in long double, with the functions of a core in double.
std::vector<double> sampled_errors(const SumTask& task, const SumPoints& points,
                                   const std::vector<SummedField>& fields);

}  // namespace mote
