#include "mote/walls/vortex_walls.hpp"

#include <algorithm>
#include <cmath>

namespace mote {
namespace {

std::vector<Complex> complex(std::span<const double> numbers) {
  std::vector<Complex> places(numbers.size() / 2);
  for (std::size_t k = 0; k < places.size(); ++k) places[k] = {numbers[2 * k], numbers[2 * k + 1]};
  return places;
}

std::vector<double> flat(std::span<const Complex> places) {
  std::vector<double> numbers;
  for (const Complex place : places) numbers.insert(numbers.end(), {place.real(), place.imag()});
  return numbers;
}

double largest(std::span<const double> values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::abs(value));
  return result;
}

}  // namespace

VortexWalls::VortexWalls(std::span<const Outline> bodies, const VortexWallOptions& options)
    : options_(options),
      bodies_(bodies, options.panel_length * options.spacing),
      lattice_(bodies_, options.spacing, options.node),
      diffusion_(lattice_, options.viscosity),
      slip_(bodies_.panels().size()),
      given_(slip_),
      wall_vorticity_(slip_) {
  for (const Panel& panel : bodies_.panels())
    panel_places_.insert(panel_places_.end(), {panel.middle().real(), panel.middle().imag()});
}

/// What the vortices lack of the circulation at the start comes from the bodies, by their
/// circumference: none takes part in it unless vortices were left out.
std::vector<double> VortexWalls::sheet(const Vortices& vortices,
                                       std::span<const double> stream) const {
  std::vector<double> along(bodies_.panels().size());
  for (std::size_t k = 0; k < along.size(); ++k) {
    const Complex side = bodies_.panels()[k].to - bodies_.panels()[k].from;
    along[k] = stream[2 * k] * side.real() + stream[2 * k + 1] * side.imag();
  }
  add_circulations(bodies_.panels(), vortices, along);
  double missing = options_.circulation, circumference = 0;
  for (const double circulation : vortices.circulation) missing -= circulation;
  std::vector<double> share(bodies_.body_count());
  for (std::size_t body = 0; body < share.size(); ++body) {
    for (const Panel& panel : bodies_.panels(body)) share[body] += panel.length();
    circumference += share[body];
  }
  for (double& part : share) part *= missing / circumference;
  return bodies_.sheet(along, share);
}

void VortexWalls::add_velocity(const PlaneVortices& vortices, std::span<const double> stream,
                               std::span<const double> places, std::span<double> velocity) const {
  const std::vector<Complex> sources = complex(vortices.position), targets = complex(places);
  std::vector<Complex> added(targets.size());
  bodies_.add_velocity(sheet({sources, vortices.circulation}, stream), targets, added);
  for (std::size_t k = 0; k < added.size(); ++k) {
    velocity[2 * k] += added[k].real();
    velocity[2 * k + 1] += added[k].imag();
  }
}

Complex VortexWalls::impulse(const Vortices& vortices, std::span<const double> sheet) const {
  Complex sum{};
  for (std::size_t k = 0; k < vortices.place.size(); ++k)
    sum += impulse_of(vortices.circulation[k], vortices.place[k]);
  for (std::size_t k = 0; k < sheet.size(); ++k)
    sum += impulse_of(sheet[k] * bodies_.panels()[k].length(), bodies_.panels()[k].middle());
  return sum;
}

void VortexWalls::begin_step(const PlaneVortices& vortices, std::span<const double> stream) {
  const std::vector<Complex> places = complex(vortices.position);
  const Vortices before{places, vortices.circulation};
  impulse_before_ = impulse(before, sheet(before, stream));
}

/// Vorticity on the lattice, diffused but for what the walls give off, and without what is too weak
/// to be kept.
LatticeVorticity VortexWalls::lattice_vorticity(const Vortices& vortices, double step) {
  LatticeVorticity vorticity = remeshed(vortices, lattice_);
  if (options_.viscosity > 0) {
    vorticity_before_ = vorticity;
    diffusion_.diffuse(step, vorticity);
  }
  lost_ = drop_weak(lattice_, options_.threshold * largest(vorticity.circulation), vorticity);
  return vorticity;
}

void VortexWalls::give_off(std::span<const double> stream, double step,
                           WallDiffusion::Release release, LatticeVorticity& vorticity) {
  const std::vector<double> strength = sheet(particles_of(vorticity, lattice_).vortices(), stream);
  for (std::size_t k = 0; k < strength.size(); ++k)
    given_[k] = strength[k] * bodies_.panels()[k].length();
  diffusion_.add_sheet(given_, step, release, vorticity);
  wall_vorticity_ = diffusion_.wall_vorticity(strength, step, vorticity_before_);
  const std::vector<double> after = diffusion_.wall_vorticity(strength, step, vorticity);
  for (std::size_t k = 0; k < after.size(); ++k)
    wall_vorticity_[k] = (wall_vorticity_[k] + after[k]) / 2;
}

VortexWalls::Replaced VortexWalls::end_step(const PlaneVortices& vortices,
                                            std::span<const double> stream, double step,
                                            WallDiffusion::Release release) {
  step_ = step;
  const std::vector<Complex> places = complex(vortices.position);
  LatticeVorticity vorticity = lattice_vorticity({places, vortices.circulation}, step);
  if (options_.viscosity > 0) give_off(stream, step, release, vorticity);
  const LatticeParticles after = particles_of(vorticity, lattice_);
  slip_ = sheet(after.vortices(), stream);
  const Complex force = (impulse_before_ - impulse(after.vortices(), slip_) - lost_.impulse) / step;
  force_ = {force.real(), force.imag()};
  return {flat(after.place), after.circulation, after.area};
}

std::array<double, 2> VortexWalls::force_on(std::size_t body) const {
  if (step_ == 0) return {};
  const std::span<const Panel> panels = bodies_.panels(body);
  const std::size_t first = panels.data() - bodies_.panels().data();
  Complex sum{};
  for (std::size_t k = 0; k < panels.size(); ++k)
    sum += options_.viscosity * wall_vorticity_[first + k] * (panels[k].to - panels[k].from) -
           impulse_of(given_[first + k], panels[k].middle()) / step_;
  return {sum.real(), sum.imag()};
}

}  // namespace mote
