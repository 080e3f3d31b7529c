#include "mote/app/path_course.hpp"

#include <utility>

#include "mote/integrators/state.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

/// What rounding lost, in the order of a system's values; zeros where nothing is kept.
std::vector<double> rounding_of(System& system, const Integrator& integrator) {
  const auto [drifted, kicked] = integrator.rounding();
  std::vector<double> all;
  const auto append = [&](std::span<const Evolving> parts, const auto& lost) {
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const std::size_t end = all.size() + parts[k].value.size();
      if (k < lost.size()) all.insert(all.end(), lost[k].begin(), lost[k].end());
      all.resize(end);
    }
  };
  append(system.drifted(), drifted);
  append(system.kicked(), kicked);
  return all;
}

void recall_rounding(System& system, Integrator& integrator, std::span<const double> all) {
  std::array<std::vector<std::vector<double>>, 2> lost;
  const auto take = [&](std::span<const Evolving> parts, auto& lists) {
    for (const Evolving& part : parts) {
      lists.emplace_back(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(part.value.size()));
      all = all.subspan(part.value.size());
    }
  };
  take(system.drifted(), lost[0]);
  take(system.kicked(), lost[1]);
  integrator.recall_rounding(std::move(lost));
}

}  // namespace

PathCourse::PathCourse(System& system, Integrator& integrator, std::unique_ptr<Path> path,
                       const Moment& start)
    : system_(system), integrator_(integrator), path_(std::move(path)), node_(start) {
  if (path_ != nullptr) path_->add_node(system_, start.time);
}

void PathCourse::go_back_to(const Restart& restart) {
  const std::size_t size = values_of(system_).size();
  if (restart.values.size() != size || restart.rounding.size() != size)
    throw InputError("this snapshot lacks the step that it lies in");
  node_.step = restart.step;
  node_.time = restart.time;
  put_values(system_, restart.values);
  recall_rounding(system_, integrator_, restart.rounding);
  integrator_.recall(restart.integrator);
  if (path_ != nullptr) path_->recall(restart.path);
  node_values_.clear();
}

void PathCourse::begin_step() {
  before_ = {node_.step,           node_.time,
             values_of(system_),   rounding_of(system_, integrator_),
             integrator_.memory(), path_ != nullptr ? path_->memory() : std::vector<double>()};
}

void PathCourse::end_step(double time) {
  ++node_.step;
  node_.time = time;
  if (path_ != nullptr) path_->add_node(system_, time);
}

void PathCourse::show(double time) {
  node_values_ = values_of(system_);
  if (time == node_.time) return;
  if (path_ != nullptr)
    path_->go_to(system_, time);
  else
    integrator_.go_along_path(system_, (time - before_.time) / (node_.time - before_.time));
}

void PathCourse::show_node() {
  if (node_values_.empty()) return;
  put_values(system_, node_values_);
  node_values_.clear();
}

}  // namespace mote
