#include "mote/study/error_limits.hpp"

#include "mote/scenario/located_error.hpp"

namespace mote {

void ErrorLimits::describe(Description& d) {
  d.number({"error", "the largest error, at most"}, error, positive);
  d.number({"least_error", "the largest error, at least"}, least_error, positive);
}

void ErrorLimits::refuse_senseless(const std::string& place) const {
  if (!error && !least_error)
    throw LocatedError(place, "a check needs 'error', 'least_error' or both");
  if (error && least_error && *error < *least_error)
    throw LocatedError(place, "'least_error' must not lie above 'error'");
}

void ErrorLimits::judge(const std::string& name, double largest,
                        std::vector<CheckResult>& checks) const {
  if (error) checks.push_back({name, largest, *error});
  if (least_error) checks.push_back({name, largest, *least_error, CheckResult::Sense::at_least});
}

}  // namespace mote
