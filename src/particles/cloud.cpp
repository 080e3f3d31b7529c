#include "mote/particles/cloud.hpp"

#include <algorithm>
#include <stdexcept>

#include "mote/particles/parallel.hpp"

namespace mote {

Cloud::Cloud(int dimension, Index count) : dimension_(dimension), count_(count) {
  add("position", FieldKind::vector, "m");
}

std::span<double> Cloud::add(std::string name, FieldKind kind, std::string si_unit) {
  if (has(name)) throw std::logic_error("the cloud has a field '" + name + "' already");
  const int components = kind == FieldKind::vector ? dimension_ : 1;
  const auto size = static_cast<std::size_t>(count_) * static_cast<std::size_t>(components);
  fields_.push_back(
      {std::move(name), kind, components, std::move(si_unit), std::vector<double>(size)});
  return fields_.back().values;
}

void rearrange(std::vector<double>& values, std::size_t components, std::span<const Index> order,
               std::vector<double>& work) {
  const auto count = static_cast<Index>(order.size());
  work.resize(order.size() * components);
#pragma omp parallel if (parallel_from <= count)
  {
#pragma omp for schedule(static)
    for (Index k = 0; k < count; ++k) {
      const auto from = static_cast<std::size_t>(order[static_cast<std::size_t>(k)]) * components;
      const auto to = static_cast<std::size_t>(k) * components;
      for (std::size_t c = 0; c < components; ++c) work[to + c] = values[from + c];
    }
#pragma omp for schedule(static)
    for (std::size_t k = 0; k < work.size(); ++k) values[k] = work[k];
  }
  values.resize(work.size());
}

void Cloud::rearrange(std::span<const Index> order) {
  for (Field& field : fields_)
    mote::rearrange(field.values, static_cast<std::size_t>(field.components), order, rearranged_);
  count_ = static_cast<Index>(order.size());
}

void Cloud::resize(Index count) {
  for (Field& field : fields_)
    field.values.resize(static_cast<std::size_t>(count) *
                        static_cast<std::size_t>(field.components));
  count_ = count;
}

bool Cloud::has(std::string_view name) const {
  return std::ranges::any_of(fields_, [&](const Field& field) { return field.name == name; });
}

const Field& Cloud::field(std::string_view name) const {
  const auto found = std::ranges::find(fields_, name, &Field::name);
  if (found == fields_.end())
    throw std::out_of_range("the cloud has no field '" + std::string(name) + "'");
  return *found;
}

std::span<double> Cloud::values(std::string_view name) {
  return const_cast<Field&>(field(name)).values;
}

std::span<const double> Cloud::values(std::string_view name) const { return field(name).values; }

}  // namespace mote
