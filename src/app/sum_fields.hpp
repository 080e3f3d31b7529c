#pragma once

#include <string>
#include <vector>

#include "mote/app/sum_points.hpp"
#include "mote/sums/sum_settings.hpp"

namespace mote {

/// A sum over all pairs as the command line asks for it.
struct SumTask {
  SumKernel kernel = SumKernel::cauchy;
  SumSettings settings;
  std::string core = "point";
  double core_size = 0;
  bool gradient = false;  ///< whether the gradient of the velocity is wanted, too
};

/// A field at the targets: its columns, and their values target by target.
struct SummedField {
  std::string name;
  std::vector<std::string> columns;
  std::vector<double> values;
};

/// What a task gives, without values:
///   cauchy       value: value_re, value_im
///   gravity      potential; gradient: gradient_x, ...
///   biot_savart  velocity: velocity_x, ...; velocity_gradient: velocity_gradient_xx, _xy, ...,
///                the second letter being that of the derivative.
std::vector<SummedField> fields_of(const SumTask& task, int dimension);

/// The fields with their values. Throws InputError for what the sum cannot serve.
std::vector<SummedField> summed_fields(const SumTask& task, const SumPoints& points);

}  // namespace mote
