#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mote/models/vortex.hpp"

namespace mote {

template <>
VortexMoments Vortex<2>::moments() const {
  return vortex_moments(vortices_.position(), vortices_.circulation(), vortices_.velocity());
}

/// That of friction, or, without it, of the velocities.
template <int D>
PairWork Vortex<D>::pair_work() const {
  PairWork work = diffusion_->pair_work();
  if (work.evaluations == 0) work.evaluations = evaluations_;
  return work;
}

template <int D>
bool Vortex<D>::keeps_impulse() const {
  return !vortices_.in_a_box() && !free_stream_.exists() && !bodies_ &&
         options_.diffusion != Diffusion::random_walk;
}

template <int D>
bool Vortex<D>::keeps_angular_impulse() const {
  return keeps_impulse() && options_.kinematic_viscosity == 0;
}

/// Linear impulse: sum of Gamma (y, -x); angular, about the origin: -1/2 sum of Gamma x^2.
template <>
std::vector<Conserved> Vortex<2>::conserved() const {
  const VortexMoments m = moments();
  std::vector<Conserved> quantities{{"circulation", m.circulation, m.magnitude}};
  if (keeps_impulse()) {
    quantities.push_back({"impulse_x", m.first[1], m.first_magnitude});
    quantities.push_back({"impulse_y", -m.first[0], m.first_magnitude});
  }
  if (keeps_angular_impulse()) {
    const double squares = m.second.trace();
    const double scale = m.first_magnitude * m.first_magnitude / m.magnitude;
    quantities.push_back(
        {"angular_impulse", -0.5 * squares, std::max(std::abs(squares), scale) / 2});
  }
  return quantities;
}

/// What is spread in the plane, by its moments; in a box, where places have no origin, the energy.
template <>
std::vector<Reading> Vortex<2>::readings() const {
  const VortexMoments m = moments();
  std::vector<Reading> readings{{"vortices", static_cast<double>(vortices_.count())}};
  const auto velocity = vortices_.velocity();
  if (vortices_.in_a_box()) {
    double energy = 0;
    for (std::size_t k = 0; k < velocity.size(); ++k)
      energy += 0.5 * vortices_.volume()[k / 2] * velocity[k] * velocity[k];
    readings.push_back({"kinetic_energy", energy});
    return readings;
  }
  if (!keeps_impulse()) {
    readings.push_back({"impulse_x", m.first[1]});
    readings.push_back({"impulse_y", -m.first[0]});
  }
  if (!keeps_angular_impulse()) readings.push_back({"angular_impulse", -0.5 * m.second.trace()});
  if (bodies_) {
    std::ranges::move(bodies_->readings(), std::back_inserter(readings));
    return readings;
  }
  if (const auto hamiltonian = induced_->hamiltonian(sources()))
    readings.push_back({"hamiltonian", *hamiltonian});
  if (is_a_pair_) {
    const Vec<2> apart = vortices_.place(1) - vortices_.place(0);
    readings.push_back({"separation", apart.norm()});
    readings.push_back({"angle", std::atan2(apart[1], apart[0])});
  }
  if (!has_circulation_) return readings;
  const double cores = options_.core == "gauss" ? 2 * std::pow(vortices_.core_size(), 2) : 0;
  readings.push_back({"second_moment", m.spread().trace() + cores});
  if (!is_a_pair_) readings.push_back({"angle", m.axis()});
  readings.push_back({"rotation_rate", m.axis_rate()});
  return readings;
}

template <int D>
std::vector<Advice> Vortex<D>::advice() const {
  if (options_.core == "point" || vortices_.count() <= static_cast<Index>(options_.vortices.size()))
    return {};
  const double overlap = options_.core_radius(spacing()) / spacing();
  if (overlap >= 1) return {};
  return {
      {"model.core", fmt::format("cores of {:.3g} spacings do not overlap: blobs of a continuous "
                                 "vorticity need at least 1",
                                 overlap)}};
}

template <int D>
std::vector<std::string> Vortex<D>::remarks() const {
  std::vector<std::string> remarks{fmt::format("{} vortices, cores '{}' of size {:.6g}.",
                                               vortices_.count(), options_.core,
                                               vortices_.core_size())};
  if (vortices_.in_a_box())
    remarks.push_back("Velocities are those in a periodic box, with all images.");
  else
    remarks.push_back(
        "The fluid has no bounds: the domain is where the lattice is, and vortices "
        "that leave it go on.");
  if (bodies_)
    remarks.push_back(fmt::format(
        "Walls are {} panels; forces are over the density, the mean of the step that ends. What a "
        "wall gives off takes {:.3g} to reach the vortices beside it.",
        bodies_->panels(), bodies_->settling_time()));
  if (course_.remeshings > 0)
    remarks.push_back(fmt::format(
        "Put on a lattice {} times; at most {:.2g} of the circulation's magnitude was below the "
        "threshold, and given back with its impulses.",
        course_.remeshings, course_.dropped));
  return remarks;
}

template <int D>
std::vector<std::string> Vortex<D>::warnings() const {
  if (!bodies_ || !bodies_->has_hurried()) return {};
  return {
      fmt::format("steps are shorter than {:.3g}, in which what walls give off reaches the "
                  "vortices beside them: a flow that starts at once looks older by as much",
                  bodies_->settling_time())};
}

template <int D>
Triple Vortex<D>::force_on(std::size_t body) const {
  return bodies_ ? bodies_->force_on(body) : Triple{};
}

template <int D>
Parameters Vortex<D>::parameters() const {
  const SpaceStart& start = vortices_.start();
  const double size = vortices_.core_size();
  Parameters parameters{{"viscosity", options_.kinematic_viscosity},
                        {"spacing", start.spacing},
                        {"core_size", size},
                        {"core_second_moment", options_.core == "gauss" ? 2 * size * size : 0},
                        {"free_stream", free_stream_.exists() ? 1 : 0},
                        {"remeshed", options_.remesh_every > 0 ? 1 : 0},
                        {"single_vortices", static_cast<double>(options_.vortices.size())},
                        {"vortices", static_cast<double>(vortices_.count())}};
  for (std::size_t k = 0; k < options_.vortices.size() && vortices_.count() <= 2; ++k) {
    const SingleVortex& vortex = options_.vortices[k];
    parameters[fmt::format("circulation_{}", k)] = vortex.circulation;
    for (std::size_t d = 0; d < D; ++d)
      parameters[fmt::format("{}_{}", axis_names[d], k)] = vortex.position[d];
  }
  return parameters;
}

template class Vortex<2>;
template class Vortex<3>;

}  // namespace mote
