#include "mote/output/particle_ids.hpp"

#include <algorithm>
#include <numeric>

namespace mote {

std::int64_t id_of(const Cloud& cloud, Index i) {
  return cloud.has(id_field) ? static_cast<std::int64_t>(cloud.values(id_field)[i]) : i;
}

std::vector<std::int64_t> ids(const Cloud& cloud) {
  std::vector<std::int64_t> all(static_cast<std::size_t>(cloud.count()));
  if (!cloud.has(id_field))
    std::iota(all.begin(), all.end(), 0);
  else
    std::ranges::transform(cloud.values(id_field), all.begin(),
                           [](double id) { return static_cast<std::int64_t>(id); });
  return all;
}

std::vector<Index> in_order_of_ids(const Cloud& cloud) {
  const std::vector<std::int64_t> id = ids(cloud);
  std::vector<Index> order(id.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](Index i) { return id[i]; });
  return order;
}

}  // namespace mote
