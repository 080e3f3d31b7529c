#include "mote/integrators/x_ivas.hpp"

#include <cstddef>
#include <vector>

#include "mote/xivas/particle_fields.hpp"

namespace mote {
namespace {

void form_rates(System& system, double time, double step) {
  if (!system.predicts() || !system.rates_are_current()) {
    system.prepare(time);
    system.update_kick_rates(time);
  }
  if (system.predicts()) {
    system.prepare(time);
    system.update_rates_ahead(time, step / 2);
  }
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
  return {};
}

void XIvas::advance_one_step(System& system, double time, double step) {
  form_rates(system, time, step);
  if (system.dimension() == 2)
    go_along_streamlines<2>(system, step);
  else
    go_along_streamlines<3>(system, step);
}

template <int D>
void XIvas::go_along_streamlines(System& system, double step) {
  std::vector<Evolving> drifted(system.drifted().begin(), system.drifted().end());
  std::vector<Evolving> kicked(system.kicked().begin(), system.kicked().end());
  std::vector<double> velocity(drifted[0].rate.begin(), drifted[0].rate.end());
  std::vector<double> acceleration(kicked[0].rate.begin(), kicked[0].rate.end());
  if (const auto flow = flow_in<D>(system); !flow.empty()) {
    const ParticleFields<D> fields({picked<D>(drifted[0].value, flow), picked<D>(velocity, flow),
                                    picked<D>(acceleration, flow)},
                                   system.periods(), step);
    const auto motions = fields.mean_motions();
    for (std::size_t k = 0; k < flow.size(); ++k) {
      Vec<D>::Map(&velocity[flow[k]]) = motions[k].velocity;
      Vec<D>::Map(&acceleration[flow[k]]) = motions[k].acceleration;
    }
  }
  drifted[0].rate = velocity;
  kicked[0].rate = acceleration;
  drift(system, drifted, step);
  kick(system, kicked, step);
}

}  // namespace mote
