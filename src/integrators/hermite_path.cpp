#include "mote/integrators/hermite_path.hpp"

#include <algorithm>
#include <cstddef>

#include "mote/integrators/hermite.hpp"
#include "mote/particles/failure.hpp"
#include "mote/particles/parallel.hpp"

namespace mote {

namespace {

void append(std::vector<double>& row, std::span<const double> values) {
  row.insert(row.end(), values.begin(), values.end());
}

/// What `of` names of all parts, in a row.
template <class Member>
std::vector<double> in_a_row(std::span<const Evolving> parts, Member of) {
  std::vector<double> row;
  for (const Evolving& part : parts) append(row, part.*of);
  return row;
}

/// Puts the values of all parts where they are in a row.
void spread(std::span<const double> row, std::span<const Evolving> parts) {
  for (const Evolving& part : parts) {
    std::copy_n(row.begin(), part.value.size(), part.value.begin());
    row = row.subspan(part.value.size());
  }
}

}  // namespace

void HermitePath::add_node(System& system, double time) {
  if (!nodes_.empty() && nodes_.back().time == time) nodes_.pop_back();
  Node node{
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
  if (static_cast<int>(nodes_.size()) > steps_ + 1) nodes_.pop_front();
}

void HermitePath::go_to(System& system, double time) const {
  std::vector<double> times;
  for (const Node& node : nodes_) times.push_back(node.time);
  const HermiteWeights weights(times, derivatives_, time);
  const std::vector<double>& origin = nodes_[weights.nearest()].derivative[0];
  const auto size = static_cast<std::ptrdiff_t>(origin.size());
  std::vector<double> value(size), rate(size);
#pragma omp parallel for schedule(static) if (size >= parallel_from)
  for (std::ptrdiff_t i = 0; i < size; ++i) {
    double change = 0, velocity = 0;
    for (std::size_t node = 0; node < nodes_.size(); ++node)
      for (int order = 0; order <= derivatives_; ++order) {
        const auto& [in_value, in_rate] = weights.weight(static_cast<int>(node), order);
        const double known = nodes_[node].derivative[order][i] - (order == 0 ? origin[i] : 0);
        change += in_value * known;
        velocity += in_rate * known;
      }
    value[i] = origin[i] + change;
    rate[i] = velocity;
  }
  spread(value, system.drifted());
  spread(rate, system.kicked());
}

/// The number of nodes that the next polynomials go through, then the nodes: time, and rows.
std::vector<double> HermitePath::memory() const {
  const std::size_t kept = std::min(nodes_.size(), static_cast<std::size_t>(steps_));
  std::vector<double> memory{static_cast<double>(kept)};
  for (std::size_t node = nodes_.size() - kept; node < nodes_.size(); ++node) {
    memory.push_back(nodes_[node].time);
    for (const auto& row : nodes_[node].derivative) append(memory, row);
  }
  return memory;
}

void HermitePath::recall(std::span<const double> memory) {
  const std::size_t count = memory.empty() ? 0 : static_cast<std::size_t>(memory[0]);
  const std::size_t rows = count * (derivatives_ + 1);
  const std::size_t size = count > 0 ? (memory.size() - 1 - count) / rows : 0;
  if (memory.size() != 1 + count + rows * size)
    throw InputError("the nodes kept in the snapshot are not those of this path");
  nodes_.clear();
  memory = memory.subspan(1);
  const auto taken = [&memory](std::size_t numbers) {
    const std::span<const double> front = memory.first(numbers);
    memory = memory.subspan(numbers);
    return front;
  };
  for (std::size_t k = 0; k < count; ++k) {
    Node node{taken(1)[0], {}};
    for (int order = 0; order <= derivatives_; ++order) {
      const std::span<const double> row = taken(size);
      node.derivative.emplace_back(row.begin(), row.end());
    }
    nodes_.push_back(std::move(node));
  }
}

}  // namespace mote
