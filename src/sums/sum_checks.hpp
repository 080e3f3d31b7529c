#pragma once

#include <string>
#include <string_view>

#include "mote/operators/cores/all.hpp"
#include "mote/particles/failure.hpp"
#include "mote/sums/pair_shapes.hpp"
#include "mote/sums/sum_settings.hpp"

namespace mote {

/// Throws InputError unless the settings suit a sum that has no power series.
void check_settings(const SumSettings& settings, std::string_view sum);

/// Throws InputError for a tolerance that the multipole method cannot keep.
void check_tolerance(const SumSettings& settings);

/// Throws InputError, naming both, where a target stands on a source, and where a place is not
/// finite.
template <int D>
void refuse_targets_on_sources(std::span<const double> targets, std::span<const double> sources);

/// Throws InputError, naming both, where two points stand on one place, and where a place is not
/// finite.
template <int D>
void refuse_points_of_one_place(std::span<const double> points);

/// Throws InputError unless blobs of this size can be.
void check_core_size(double size);

/// Throws InputError for blobs of no size, and for targets that are on points, which have none.
template <int D>
void check_targets(std::span<const double> targets, const Sources<D>& sources, bool are_points) {
  if (are_points)
    refuse_targets_on_sources<D>(targets, sources.position);
  else
    check_core_size(sources.core_size);
}

/// Throws InputError with what there is.
[[noreturn]] void refuse_core(std::string_view name);

/// Calls visit.template operator()<Shape>() for "point" or a core of the list.
template <int D, class Visit>
void visit_shape(std::string_view core, Visit visit) {
  bool found = core == "point";
  if (found) visit.template operator()<PointShape<D>>();
  for_each_type(VortexCores{}, [&]<class Core>() {
    if (core != Core::name) return;
    found = true;
    visit.template operator()<BlobShape<D, Core>>();
  });
  if (!found) refuse_core(core);
}

extern template void refuse_targets_on_sources<2>(std::span<const double>, std::span<const double>);
extern template void refuse_points_of_one_place<2>(std::span<const double>);
extern template void refuse_points_of_one_place<3>(std::span<const double>);
extern template void refuse_targets_on_sources<3>(std::span<const double>, std::span<const double>);

}  // namespace mote
