#pragma once

#include <vector>

#include "mote/compare/compare_table.hpp"

namespace mote {

/// Refuses expectations that no member can meet or miss: that select none, name a field without an
/// error, or ask for an order without refinement. Throws LocatedError.
void check_expectations(const Comparison& comparison, const Document& document);

/// Every expectation with its limit, for each member that it selects: a failure by its time, an
/// error at the finest resolution. What is not there is NaN and does not pass.
std::vector<CheckResult> expectation_results(const CompareTable& table);

/// Whether an expectation says that the numerics of this member break down.
bool must_fail(const Comparison& comparison, const Member& member);

/// Whether every member that must not fail ran and passed its own checks.
bool members_passed(const CompareTable& table);

}  // namespace mote
