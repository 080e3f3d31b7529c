#include "mote/catalogue/vortex_start.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mote/particles/failure.hpp"

namespace mote {

VortexStart::VortexStart(const FlowSetup& setup, std::string solution)
    : setup_(setup), solution_(std::move(solution)) {
  if (!setup.parameters.contains("vortices") || setup.start.dimension != 2)
    refuse("is a flow of the model vortex in 2 dimensions");
  const std::vector<double>& position = setup.start.position;
  for (std::size_t k = 0; k < position.size(); k += 2)
    places_.push_back({position[k], position[k + 1], 0});
}

void VortexStart::refuse(const std::string& problem) const {
  throw InputError("check.against", solution_ + " " + problem);
}

double VortexStart::parameter(const std::string& name) const { return setup_.parameters.at(name); }

double VortexStart::highest() const {
  double highest = 0;
  for (const Triple& place : places_)
    if (std::abs(vorticity(place)) > std::abs(highest)) highest = vorticity(place);
  return highest;
}

bool VortexStart::is_uniform() const {
  const double value = highest();
  return std::ranges::all_of(places_, [&](const Triple& place) {
    const double here = vorticity(place);
    return here == 0 || std::abs(here - value) < same_start * std::abs(value);
  });
}

VorticityMoments VortexStart::moments() const {
  const double cell = setup_.start.spacing * setup_.start.spacing;
  VorticityMoments m;
  for (const Triple& place : places_) {
    const double circulation = cell * vorticity(place);
    m.circulation += circulation;
    m.centre[0] += circulation * place[0];
    m.centre[1] += circulation * place[1];
  }
  if (m.circulation == 0) refuse("needs a vortex with a circulation, and here it comes to 0");
  for (double& coordinate : m.centre) coordinate /= m.circulation;
  for (const Triple& place : places_) {
    const double share = cell * vorticity(place) / m.circulation;
    const double x = place[0] - m.centre[0], y = place[1] - m.centre[1];
    m.square_x += share * x * x;
    m.square_y += share * y * y;
    m.product += share * x * y;
  }
  return m;
}

double VortexStart::vorticity_difference(
    const std::function<double(const Triple&)>& expected) const {
  double wrong = 0, size = 0;
  for (const Triple& place : places_) {
    const double there = expected(place);
    wrong = std::max(wrong, std::abs(vorticity(place) - there));
    size = std::max(size, std::abs(there));
  }
  return size > 0 ? wrong / size : wrong;
}

void VortexStart::need_unbounded_plane() const {
  if (setup_.start.periodic[0]) refuse("is a flow in an unbounded plane, this one is in a box");
  need_no_free_stream();
}

void VortexStart::need_no_free_stream() const {
  if (parameter("free_stream") != 0) refuse("has no free stream, this flow has");
}

void VortexStart::need_no_viscosity() const {
  if (parameter("viscosity") != 0) refuse("has no viscosity, this fluid has");
}

void VortexStart::need_vorticity_alone() const {
  if (!has_vorticity()) refuse("needs a vorticity in 'initial', and there is none");
  if (parameter("single_vortices") > 0)
    refuse("needs the vorticity in 'initial' alone, and there are 'vortices' beside it");
}

}  // namespace mote
