#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "mote/particles/cloud.hpp"

namespace mote {

/// The field that tells particles apart where their places in the cloud change.
inline constexpr std::string_view id_field = "id";

/// The number by which a user knows particle i: its value of the field `id`, or its place in the
/// cloud where there is no such field.
std::int64_t id_of(const Cloud& cloud, Index i);

/// The ids of all particles as the cloud holds them, and the particles in order of their ids.
std::vector<std::int64_t> ids(const Cloud& cloud);
std::vector<Index> in_order_of_ids(const Cloud& cloud);

}  // namespace mote
