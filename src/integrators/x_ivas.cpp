#include "mote/integrators/x_ivas.hpp"

#include <cstddef>
#include <vector>

#include "mote/xivas/particle_fields.hpp"

namespace mote {
namespace {

void form_rates(System& system, double time) {
  system.prepare(time);
  system.update_kick_rates(time);
  system.update_drift_rates(time);
}

/// Where the vectors of the particles begin that are no walls.
template <int D>
std::vector<std::size_t> flow_in(System& system) {
  const auto walls = system.walls();
  std::vector<std::size_t> firsts;
  for (std::size_t first = 0; first < system.drifted().front().value.size(); first += D)
    if (walls.empty() || walls[first / D] == 0) firsts.push_back(first);
  return firsts;
}

template <int D>
std::vector<double> picked(std::span<const double> numbers, std::span<const std::size_t> firsts) {
  std::vector<double> vectors;
  for (const std::size_t first : firsts)
    for (const double number : numbers.subspan(first, D)) vectors.push_back(number);
  return vectors;
}

}  // namespace

std::string XIvas::missing_in(System& system) const {
  if (system.dimension() != 2 && system.dimension() != 3)
    return "places in two or three dimensions whose velocities it moves, too";
  if (system.point_masses()) return "a flow, for point masses are no field of velocities";
  return {};
}

void XIvas::advance_one_step(System& system, double time, double step) {
  form_rates(system, time);
  if (system.dimension() == 2)
    go_along_streamlines<2>(system, step);
  else
    go_along_streamlines<3>(system, step);
  if (system.drifted().size() == 1 && system.kicked().size() == 1) return;
  form_rates(system, time + step);
  Accumulator::advance_plainly(system.drifted().subspan(1), step);
  Accumulator::advance_plainly(system.kicked().subspan(1), step);
}

template <int D>
void XIvas::go_along_streamlines(System& system, double step) {
  Evolving places = system.drifted().front(), speeds = system.kicked().front();
  std::vector<double> velocity(places.rate.begin(), places.rate.end());
  std::vector<double> acceleration(speeds.rate.begin(), speeds.rate.end());
  if (const auto flow = flow_in<D>(system); !flow.empty()) {
    const ParticleFields<D> fields(
        {picked<D>(places.value, flow), picked<D>(velocity, flow), picked<D>(acceleration, flow)},
        system.periods(), step);
    const auto motions = fields.mean_motions();
    for (std::size_t k = 0; k < flow.size(); ++k) {
      Vec<D>::Map(&velocity[flow[k]]) = motions[k].velocity;
      Vec<D>::Map(&acceleration[flow[k]]) = motions[k].acceleration;
    }
  }
  places.rate = velocity;
  speeds.rate = acceleration;
  drift(system, {&places, 1}, step);
  kick(system, {&speeds, 1}, step);
}

}  // namespace mote
