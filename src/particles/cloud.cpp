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

void Cloud::rearrange(std::span<const Index> order) {
  std::vector<double>& values = rearranged_;
  for (Field& field : fields_) {
    const auto components = static_cast<std::size_t>(field.components);
    values.resize(order.size() * components);
#pragma omp parallel for schedule(static) if (parallel_from <= static_cast <Index>(order.size()))
    for (std::size_t k = 0; k < order.size(); ++k)
      for (std::size_t c = 0; c < components; ++c)
        values[k * components + c] =
            field.values[static_cast<std::size_t>(order[k]) * components + c];
#pragma omp parallel for schedule(static) if (parallel_from <= static_cast <Index>(order.size()))
    for (std::size_t k = 0; k < values.size(); ++k) field.values[k] = values[k];
    field.values.resize(values.size());
  }
  count_ = static_cast<Index>(order.size());
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
