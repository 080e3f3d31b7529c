#include "mote/integrators/hermite_path.hpp"

#include <algorithm>
#include <cstddef>

#include "mote/particles/failure.hpp"

namespace mote {

void HermitePath::add_node(System& system, double time) {
  if (!nodes_.empty() && nodes_.back().time == time) nodes_.pop_back();
  KnownNode node{
      time,
      {in_a_row(system.drifted(), &Evolving::value), in_a_row(system.kicked(), &Evolving::value)}};
  if (derivatives_ > 1) {
    if (!system.rates_are_current()) {
      system.prepare(time);
      system.update_kick_rates(time);
    }
    node.derivative.push_back(in_a_row(system.kicked(), &Evolving::rate));
  }
  nodes_.push_back(std::move(node));
  if (static_cast<int>(nodes_.size()) > steps_ + 1) nodes_.erase(nodes_.begin());
}

void HermitePath::go_to(System& system, double time) const {
  const auto [value, rate] = interpolate(nodes_, time);
  spread(value, system.drifted());
  spread(rate, system.kicked());
}

/// The number of nodes that the next polynomials go through, then the nodes: time, and rows.
std::vector<double> HermitePath::memory() const {
  if (nodes_.empty()) return {};
  const std::size_t kept = std::min(nodes_.size(), static_cast<std::size_t>(steps_));
  std::vector<double> memory{static_cast<double>(kept)};
  for (std::size_t node = nodes_.size() - kept; node < nodes_.size(); ++node) {
    memory.push_back(nodes_[node].time);
    for (const auto& row : nodes_[node].derivative) append(memory, row);
  }
  return memory;
}

void HermitePath::recall(std::span<const double> memory) {
  nodes_.clear();
  if (memory.empty()) return;
  const auto count = static_cast<std::size_t>(memory[0]);
  const std::size_t rows = count * (derivatives_ + 1);
  const std::size_t size = (memory.size() - 1 - count) / std::max<std::size_t>(rows, 1);
  if (memory.size() != 1 + count + rows * size)
    throw InputError("the nodes kept in the snapshot are not those of this path");
  memory = memory.subspan(1);
  for (std::size_t k = 0; k < count; ++k) {
    KnownNode node{take_front(memory, 1)[0], {}};
    for (int order = 0; order <= derivatives_; ++order)
      node.derivative.push_back(take_front(memory, size));
    nodes_.push_back(std::move(node));
  }
}

}  // namespace mote
