#include "mote/exact/flow_solution.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace mote {
namespace {

constexpr std::size_t most_drawn = 200;

/// At most so many rows, from the first to near the last.
Column thinned(const Column& column) {
  const std::size_t all = column.values.size(), kept = std::min(all, most_drawn);
  Column few{column.name, {}};
  for (std::size_t k = 0; k < kept; ++k) few.values.push_back(column.values[k * all / kept]);
  return few;
}

}  // namespace

double FlowSolution::valid_until() const { return std::numeric_limits<double>::infinity(); }

Table FlowSolution::of_particles(double /*time*/) const {
  throw std::logic_error("a flow is known by place, not by particle");
}

Table FlowReference::curve(double time) const {
  if (!knows_particles()) return {};
  Table table = of_particles(time);
  std::ranges::transform(table, table.begin(), thinned);
  return table;
}

}  // namespace mote
