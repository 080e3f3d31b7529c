#include "mote/sums/sum_checks.hpp"

#include <algorithm>
#include <cmath>

#include "mote/sums/place_table.hpp"

namespace mote {

void check_settings(const SumSettings& settings, std::string_view sum) {
  if (settings.method == SumMethod::power_series)
    throw InputError("method", "power_series is a method of cauchy, and " + std::string(sum) +
                                   " has none; take direct or multipole");
  check_tolerance(settings);
}

void check_tolerance(const SumSettings& settings) {
  const bool has_tolerance = settings.method == SumMethod::multipole;
  if (has_tolerance && !(1e-13 <= settings.tolerance && settings.tolerance <= 1e-3))
    throw InputError("tolerance", "the tolerance of multipole must be from 1e-13 to 1e-3");
}

void check_core_size(double size) {
  if (!(size > 0 && std::isfinite(size)))
    throw InputError("core_size", "a core needs a size greater than 0");
}

void refuse_core(std::string_view name) {
  std::string known = "point";
  for_each_type(VortexCores{}, [&]<class Core>() { known += ", " + std::string(Core::name); });
  throw InputError("core", "unknown core '" + std::string(name) + "'; there are " + known);
}

namespace {

template <int D>
void check_places(std::span<const double> places, const char* what) {
  const auto bad = std::ranges::find_if(places, [](double x) { return !std::isfinite(x); });
  if (bad == places.end()) return;
  throw InputError(std::string(what) + " " + std::to_string((bad - places.begin()) / D + 1) +
                   " stands at no finite place");
}

}  // namespace

template <int D>
void refuse_points_of_one_place(std::span<const double> points) {
  check_places<D>(points, "point");
  PlaceTable<D> table(points);
  for (std::size_t i = 0; i < points.size() / D; ++i)
    if (const auto other = table.put(i))
      throw InputError("points " + std::to_string(*other + 1) + " and " + std::to_string(i + 1) +
                       " coincide");
}

template <int D>
void refuse_targets_on_sources(std::span<const double> targets, std::span<const double> sources) {
  check_places<D>(targets, "target");
  check_places<D>(sources, "source");
  PlaceTable<D> table(sources);
  for (std::size_t j = 0; j < sources.size() / D; ++j) table.put(j);
  for (std::size_t i = 0; i < targets.size() / D; ++i)
    if (const auto source = table.find(targets.subspan(i * D, D)))
      throw InputError("target " + std::to_string(i + 1) + " stands on source " +
                       std::to_string(*source + 1) + ", where the field of a point is infinite");
}

template void refuse_points_of_one_place<2>(std::span<const double>);
template void refuse_points_of_one_place<3>(std::span<const double>);
template void refuse_targets_on_sources<2>(std::span<const double>, std::span<const double>);
template void refuse_targets_on_sources<3>(std::span<const double>, std::span<const double>);

}  // namespace mote
