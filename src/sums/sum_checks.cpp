#include "mote/sums/sum_checks.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace mote {

void check_settings(const SumSettings& settings, std::string_view sum) {
  if (settings.method == SumMethod::power_series)
    throw InputError("method", "power_series is a method of cauchy, and " + std::string(sum) +
                                   " has none; take direct or multipole");
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
  throw InputError(std::string(what) + " " + std::to_string((bad - places.begin()) / D) +
                   " stands at no finite place");
}

}  // namespace

template <int D>
void refuse_targets_on_sources(std::span<const double> targets, std::span<const double> sources) {
  check_places<D>(targets, "target");
  check_places<D>(sources, "source");
  const auto row = [](std::span<const double> places, std::size_t i) {
    return places.subspan(i * D, D);
  };
  const auto before = [](std::span<const double> a, std::span<const double> b) {
    return std::ranges::lexicographical_compare(a, b);
  };
  std::vector<std::size_t> order(sources.size() / D);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto place_of = [&](std::size_t j) { return row(sources, j); };
  std::ranges::stable_sort(order, before, place_of);
  for (std::size_t i = 0; i < targets.size() / D; ++i) {
    const auto place = row(targets, i);
    const auto found = std::ranges::lower_bound(order, place, before, place_of);
    if (found != order.end() && std::ranges::equal(place, place_of(*found)))
      throw InputError("target " + std::to_string(i) + " stands on source " +
                       std::to_string(*found) + ", where the field of a point is infinite");
  }
}

template void refuse_targets_on_sources<2>(std::span<const double>, std::span<const double>);
template void refuse_targets_on_sources<3>(std::span<const double>, std::span<const double>);

}  // namespace mote
