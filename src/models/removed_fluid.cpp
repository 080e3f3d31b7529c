#include "mote/models/removed_fluid.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace mote {

template <int D>
std::string_view side_left(const Vec<D>& position, const SpaceStart& domain, double margin) {
  constexpr std::string_view lower[] = {"x_lower", "y_lower", "z_lower"};
  constexpr std::string_view upper[] = {"x_upper", "y_upper", "z_upper"};
  for (int d = 0; d < D; ++d) {
    const auto side = static_cast<std::size_t>(d);
    if (position[d] < domain.lower[side] - margin) return lower[side];
    if (position[d] > domain.upper[side] + margin) return upper[side];
  }
  return "";
}

template <int D>
void RemovedFluid<D>::add(double id, const Vec<D>& position, std::string_view side, double time) {
  if (count_++ > 0) return;
  const std::span<const double> place(position.data(), D);
  first_ = fmt::format("particle {} at ({:.6g}) through {}, t = {:.6g}", id, fmt::join(place, ", "),
                       side, time);
}

template <int D>
void RemovedFluid<D>::resume(Index count) {
  count_ = count;
  first_ = "before the run was resumed";
}

template <int D>
std::vector<std::string> RemovedFluid<D>::warnings() const {
  if (count_ == 0) return {};
  const bool one = count_ == 1;
  return {fmt::format("{} particle{} left the domain and {} removed, first {}", count_,
                      one ? "" : "s", one ? "was" : "were", first_)};
}

template std::string_view side_left(const Vec<2>&, const SpaceStart&, double);
template std::string_view side_left(const Vec<3>&, const SpaceStart&, double);
template class RemovedFluid<2>;
template class RemovedFluid<3>;

}  // namespace mote
