#pragma once

#include <array>
#include <span>
#include <vector>

#include "mote/models/vortex_options.hpp"
#include "mote/particles/cloud.hpp"

namespace mote {

/// Vortices as bare numbers: D for the place of each, and its circulation, which has three
/// components in space.
template <int D>
struct VortexList {
  static constexpr std::size_t strengths = D == 2 ? 1 : 3;

  std::vector<double> position, circulation;
  /// The first ones may have volumes of their own, the others have that of a cell; and they may be
  /// of rings, which count from 1.
  std::vector<double> volume, ring;

  std::size_t count() const { return position.size() / D; }
  void add(std::span<const double> place, std::span<const double> strength) {
    position.insert(position.end(), place.begin(), place.end());
    circulation.insert(circulation.end(), strength.begin(), strength.end());
  }
};

/// The vortices of a flow: a cloud whose particles may be replaced by others.
template <int D>
class VortexParticles {
 public:
  static constexpr std::size_t strengths = VortexList<D>::strengths;

  /// Blobs where the initial vorticity is above the threshold, and the vortices given by
  /// themselves. Throws InputError for two vortices on one place, or neither a vortex nor a wall.
  VortexParticles(const VortexOptions& options, SpaceStart start);

  Cloud& cloud() { return cloud_; }
  const Cloud& cloud() const { return cloud_; }
  const SpaceStart& start() const { return start_; }
  Index count() const { return cloud_.count(); }
  /// Whether there are bodies: then the start may be without a vortex.
  bool has_walls() const;
  bool in_a_box() const { return start_.periodic[0]; }

  std::span<double> position() const { return position_; }
  std::span<double> velocity() const { return velocity_; }
  std::span<double> circulation() const { return circulation_; }  ///< `strengths` numbers each
  std::span<double> vorticity() const { return vorticity_; }      ///< the same
  std::span<double> volume() const { return volume_; }
  /// In space: the rings that vortices began in, from 1 on, or 0; empty in the plane.
  std::span<const double> ring() const { return ring_; }
  /// Steps since the last remeshing, if there is any.
  std::span<double> age() const { return age_; }
  Vec<D> place(Index i) const { return Vec<D>::Map(position_.data() + std::ptrdiff_t{i} * D); }

  /// Size of the cores, the same for all. It is part of the state where cores spread.
  double core_size() const { return count() > 0 ? core_size_.front() : size_of_none_; }
  void spread_cores(double size);

  /// Circulation over volume of vortex i, component c.
  double density(std::size_t i, std::size_t c = 0) const {
    return circulation_[i * strengths + c] / volume_[i];
  }
  /// Largest magnitude of it.
  double highest_density() const;
  double strength(std::size_t i) const;  ///< magnitude of the circulation of vortex i

  /// Other vortices in place of these.
  void replace(const VortexList<D>& vortices);
  /// In a periodic box: brings what has left it back in.
  void wrap();
  /// Takes the state of a snapshot. Throws InputError if it is not one of these vortices.
  void restore(const Cloud& state);

 private:
  void bind();
  std::array<double, strengths> initial_vorticity(std::size_t particle) const;
  void add_blobs(double threshold, VortexList<D>& vortices) const;
  void add_rings(const VortexOptions& options, VortexList<D>& vortices) const;
  void add_single(const VortexOptions& options, VortexList<D>& vortices) const;

  SpaceStart start_;
  Cloud cloud_;
  std::span<double> position_, velocity_, circulation_, vorticity_, volume_, core_size_, age_,
      ring_;
  double size_of_none_ = 0;  ///< of the cores that the next vortices will have
};

extern template class VortexParticles<2>;
extern template class VortexParticles<3>;

}  // namespace mote
