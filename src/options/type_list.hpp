#pragma once

namespace mote {

/// A list of types, the one place where the members of a family are named.
template <class... T>
struct TypeList {};

/// Calls `visit.template operator()<T>()` for every type of the list, in order.
template <class... T, class Visit>
constexpr void for_each_type(TypeList<T...>, Visit&& visit) {
  (visit.template operator()<T>(), ...);
}

}  // namespace mote
