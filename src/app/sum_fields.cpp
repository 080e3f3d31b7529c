#include "mote/app/sum_fields.hpp"

#include "mote/input/point_table.hpp"
#include "mote/sums/biot_savart.hpp"
#include "mote/sums/cauchy.hpp"
#include "mote/sums/gravity.hpp"

namespace mote {
namespace {

/// As complex numbers; real ones if there is one number a point.
std::vector<Complex> complex_of(const std::vector<double>& numbers, bool real) {
  std::vector<Complex> values(real ? numbers.size() : numbers.size() / 2);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = real ? Complex(numbers[i]) : Complex(numbers[2 * i], numbers[2 * i + 1]);
  return values;
}

void sum_cauchy(const SumTask& task, const SumPoints& points, std::vector<SummedField>& fields) {
  const auto sources = complex_of(points.position, false);
  const auto strengths = complex_of(points.strength, points.strength.size() == sources.size());
  std::vector<Complex> result(points.target_count());
  Cauchy sum(task.settings);
  at_place(points.file, [&] {
    if (points.at_sources)
      sum.at_sources(sources, strengths, result);
    else
      sum.at(complex_of(points.targets, false), sources, strengths, result);
  });
  for (std::size_t i = 0; i < result.size(); ++i) {
    fields[0].values[2 * i] = result[i].real();
    fields[0].values[2 * i + 1] = result[i].imag();
  }
}

/// Of Gravity or BiotSavart, to a field of theirs.
template <int D, class Sum, class Result>
void sum_over_pairs(const SumTask& task, const SumPoints& points, const Result& result) {
  Sum sum(task.settings, task.core);
  const Sources<D> sources{points.position, points.strength, task.core_size};
  at_place(points.file, [&] {
    if (points.at_sources)
      sum.at_sources(sources, result);
    else
      sum.at(points.targets, sources, result);
  });
}

template <int D>
void sum_in_space(const SumTask& task, const SumPoints& points, std::vector<SummedField>& fields) {
  if (task.kernel == SumKernel::gravity)
    return sum_over_pairs<D, Gravity<D>>(task, points,
                                         GravityField{fields[0].values, fields[1].values});
  VelocityField result{fields[0].values, {}};
  if (task.gradient) result.gradient = fields[1].values;
  sum_over_pairs<D, BiotSavart<D>>(task, points, result);
}

std::vector<std::string> tensor_names(const std::string& field, int dimension) {
  std::vector<std::string> names;
  for (int a = 0; a < dimension; ++a)
    for (int b = 0; b < dimension; ++b)
      names.push_back(field + '_' + axis_names[a] + axis_names[b]);
  return names;
}

}  // namespace

std::vector<SummedField> fields_of(const SumTask& task, int dimension) {
  const auto vector = [&](const std::string& name) {
    return SummedField{name, component_names(name, static_cast<std::size_t>(dimension)), {}};
  };
  if (task.kernel == SumKernel::cauchy) return {{"value", {"value_re", "value_im"}, {}}};
  if (task.kernel == SumKernel::gravity)
    return {{"potential", {"potential"}, {}}, vector("gradient")};
  std::vector<SummedField> fields{vector("velocity")};
  if (task.gradient)
    fields.push_back({"velocity_gradient", tensor_names("velocity_gradient", dimension), {}});
  return fields;
}

std::vector<SummedField> summed_fields(const SumTask& task, const SumPoints& points) {
  auto fields = fields_of(task, points.dimension);
  for (SummedField& field : fields)
    field.values.resize(field.columns.size() * points.target_count());
  if (task.kernel == SumKernel::cauchy)
    sum_cauchy(task, points, fields);
  else if (points.dimension == 2)
    sum_in_space<2>(task, points, fields);
  else
    sum_in_space<3>(task, points, fields);
  return fields;
}

}  // namespace mote
