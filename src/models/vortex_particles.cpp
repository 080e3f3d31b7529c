#include "mote/models/vortex_particles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mote/models/vortex_rings.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

double magnitude(std::span<const double> strength) {
  if (strength.size() == 1) return std::abs(strength[0]);
  return Vec<3>::Map(strength.data()).norm();
}

}  // namespace

template <int D>
VortexParticles<D>::VortexParticles(const VortexOptions& options, SpaceStart start)
    : start_(std::move(start)), cloud_(D, 0) {
  const FieldKind kind = D == 2 ? FieldKind::scalar : FieldKind::vector;
  cloud_.add("velocity", FieldKind::vector, "m/s");
  cloud_.add("circulation", kind, D == 2 ? "m²/s" : "m³/s");
  cloud_.add("vorticity", kind, "1/s");
  cloud_.add("volume", FieldKind::scalar, D == 2 ? "m²" : "m³");
  cloud_.add("core_size", FieldKind::scalar, "m");
  cloud_.add("age", FieldKind::scalar, "");
  if (D == 3) cloud_.add("ring", FieldKind::scalar, "");
  cloud_.add("body", FieldKind::scalar, "");
  VortexList<D> vortices;
  add_rings(options, vortices);
  add_blobs(options.threshold, vortices);
  add_single(options, vortices);
  if (vortices.count() == 0 && !has_walls())
    throw InputError(D == 2 ? "initial.vorticity" : "initial.vorticity_x",
                     fmt::format("there is no vortex: neither has 'initial' a vorticity, nor the "
                                 "model '{}'",
                                 D == 2 ? "vortices" : "rings"));
  replace(vortices);
  spread_cores(options.core_radius(start_.spacing));
}

template <int D>
void VortexParticles<D>::bind() {
  position_ = cloud_.position();
  velocity_ = cloud_.values("velocity");
  circulation_ = cloud_.values("circulation");
  vorticity_ = cloud_.values("vorticity");
  volume_ = cloud_.values("volume");
  core_size_ = cloud_.values("core_size");
  age_ = cloud_.values("age");
  if (D == 3) ring_ = cloud_.values("ring");
}

template <int D>
std::array<double, VortexParticles<D>::strengths> VortexParticles<D>::initial_vorticity(
    std::size_t particle) const {
  Triple place{};
  std::copy_n(start_.position.begin() + static_cast<std::ptrdiff_t>(particle * D), D,
              place.begin());
  if constexpr (D == 2)
    return {start_.initial("vorticity", place)};
  else
    return {start_.initial("vorticity_x", place), start_.initial("vorticity_y", place),
            start_.initial("vorticity_z", place)};
}

/// A vortex for each particle of the fluid: its vorticity times its cell.
template <int D>
void VortexParticles<D>::add_blobs(double threshold, VortexList<D>& vortices) const {
  const double cell = std::pow(start_.spacing, D);
  std::vector<std::array<double, strengths>> circulation(start_.body.size());
  std::vector<double> size(circulation.size());
  for (std::size_t i = 0; i < circulation.size(); ++i) {
    if (start_.bodies[static_cast<std::size_t>(start_.body[i])].kind == BodyKind::wall) break;
    circulation[i] = initial_vorticity(i);
    for (double& component : circulation[i]) component *= cell;
    size[i] = magnitude(circulation[i]);
  }
  const double highest = size.empty() ? 0 : *std::ranges::max_element(size);
  for (std::size_t i = 0; i < circulation.size(); ++i)
    if (size[i] > threshold * highest)
      vortices.add({start_.position.data() + i * D, D}, circulation[i]);
}

template <int D>
void VortexParticles<D>::add_rings(const VortexOptions& options, VortexList<D>& vortices) const {
  if constexpr (D == 3) {
    const double blobs = options.core == "gauss" ? options.core_radius(start_.spacing) : 0;
    for (std::size_t k = 0; k < options.rings.size(); ++k) {
      const VortexList<3> ring =
          ring_particles(options.rings[k], {start_.spacing, blobs, options.threshold},
                         fmt::format("model.rings.{}", k));
      vortices.add(ring.position, ring.circulation);
      vortices.volume.insert(vortices.volume.end(), ring.volume.begin(), ring.volume.end());
      vortices.ring.resize(vortices.count(), static_cast<double>(k + 1));
    }
  }
}

template <int D>
void VortexParticles<D>::add_single(const VortexOptions& options, VortexList<D>& vortices) const {
  for (std::size_t k = 0; k < options.vortices.size(); ++k) {
    const SingleVortex& vortex = options.vortices[k];
    const std::string key = fmt::format("model.vortices.{}.position", k);
    if (vortex.position.size() != D)
      throw InputError(key, fmt::format("'position' needs {} numbers, one a dimension, and has {}",
                                        D, vortex.position.size()));
    for (std::size_t j = 0; j < k; ++j)
      if (options.vortices[j].position == vortex.position)
        throw InputError(key, fmt::format("this vortex and number {} stand on one place", j + 1));
    vortices.add(vortex.position, {&vortex.circulation, 1});
  }
}

template <int D>
bool VortexParticles<D>::has_walls() const {
  return std::ranges::any_of(start_.bodies, [](const Body& b) { return b.kind == BodyKind::wall; });
}

template <int D>
void VortexParticles<D>::spread_cores(double size) {
  size_of_none_ = size;
  std::ranges::fill(core_size_, size);
}

template <int D>
double VortexParticles<D>::highest_density() const {
  double highest = 0;
  for (std::size_t i = 0; i < volume_.size(); ++i)
    highest = std::max(highest, strength(i) / volume_[i]);
  return highest;
}

template <int D>
double VortexParticles<D>::strength(std::size_t i) const {
  return magnitude(circulation_.subspan(i * strengths, strengths));
}

template <int D>
void VortexParticles<D>::replace(const VortexList<D>& vortices) {
  const double size = core_size();
  cloud_.resize(static_cast<Index>(vortices.count()));
  bind();
  std::ranges::copy(vortices.position, position_.begin());
  std::ranges::copy(vortices.circulation, circulation_.begin());
  std::ranges::fill(volume_, std::pow(start_.spacing, D));
  std::ranges::copy(vortices.volume, volume_.begin());
  std::ranges::fill(ring_, 0);
  std::ranges::copy(vortices.ring, ring_.begin());
  std::ranges::fill(age_, 0);
  std::ranges::fill(cloud_.values("body"), 0);
  spread_cores(size);
}

template <int D>
void VortexParticles<D>::wrap() {
  if (!in_a_box()) return;
  for (std::size_t k = 0; k < position_.size(); ++k) {
    const double lower = start_.lower[k % D], width = start_.upper[k % D] - lower;
    position_[k] -= width * std::floor((position_[k] - lower) / width);
  }
}

template <int D>
void VortexParticles<D>::restore(const Cloud& state) {
  for (const Field& field : cloud_.fields())
    if (!state.has(field.name) || (state.count() == 0 && !has_walls()))
      throw InputError("this snapshot lacks vortices or the field " + field.name);
  cloud_.resize(state.count());
  bind();
  for (const Field& field : cloud_.fields())
    std::ranges::copy(state.values(field.name), cloud_.values(field.name).begin());
}

template class VortexParticles<2>;
template class VortexParticles<3>;

}  // namespace mote
