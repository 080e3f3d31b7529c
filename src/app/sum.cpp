#include <fmt/format.h>
#include <fmt/ranges.h>
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iterator>

#include "mote/app/commands.hpp"
#include "mote/app/sum_check.hpp"
#include "mote/output/files.hpp"
#include "mote/particles/failure.hpp"
#include "mote/particles/vector.hpp"

namespace mote {
namespace {

namespace fs = std::filesystem;

/// The place of a word that the command line has checked.
template <class Names>
std::size_t number_of(const std::string& name, const Names& names) {
  return static_cast<std::size_t>(std::ranges::find(names, name) - std::begin(names));
}

/// Refuses what could be found out at the end only.
void check_result_file(const SumOptions& options) {
  const fs::path out = options.out;
  std::error_code error;
  if (out.extension() != ".csv")
    throw InputError(fmt::format("--out {}: the file must end in .csv", options.out));
  if (fs::is_directory(out, error))
    throw InputError(fmt::format("{}: this is a folder, not a file", options.out));
  if (fs::exists(out, error) && !options.overwrite)
    throw InputError(fmt::format("{}: this file exists; --overwrite replaces it", options.out));
  if (out.has_parent_path() && !fs::is_directory(out.parent_path(), error))
    throw InputError(fmt::format("{}: cannot write: there is no folder {}", options.out,
                                 out.parent_path().string()));
}

void check_numbers(const SumOptions& options) {
  if (!(options.tolerance >= 1e-14 && options.tolerance <= 1e-1))
    throw InputError(
        fmt::format("--tolerance {}: this must lie from 1e-14 to 0.1", options.tolerance));
  if (options.core_size && !(*options.core_size > 0 && std::isfinite(*options.core_size)))
    throw InputError(fmt::format("--core-size {}: this must be positive", *options.core_size));
}

void check_together(const SumOptions& options) {
  if (options.method == "power_series" && options.kernel != "cauchy")
    throw InputError(
        fmt::format("--method power_series: {} has no such sum; direct and multipole serve it",
                    options.kernel));
  if (options.method == "power_series" && !options.targets)
    throw InputError("--method power_series: this needs --targets, apart from the sources");
  if (options.core && options.kernel == "cauchy")
    throw InputError("--core: points of the kernel cauchy have no core");
  if (options.core && *options.core != "point" && !options.core_size)
    throw InputError(fmt::format("--core {}: this needs --core-size", *options.core));
  if (options.core_size && (!options.core || *options.core == "point"))
    throw InputError("--core-size: points have no size; --core names a core that has");
  if (options.gradient && options.kernel != "biot_savart")
    throw InputError("--gradient: this is for the kernel biot_savart only");
}

SumTask task_of(const SumOptions& options) {
  SumTask task;
  task.kernel = static_cast<SumKernel>(number_of(options.kernel, sum_kernels));
  task.settings.method = static_cast<SumMethod>(number_of(options.method, sum_methods));
  task.settings.tolerance = options.tolerance;
  task.core = options.core.value_or("point");
  task.core_size = options.core_size.value_or(0);
  task.gradient = options.gradient;
  return task;
}

/// The targets in the order of their file, each with its place and what it gets.
std::string csv_of(const SumPoints& points, const std::vector<SummedField>& fields) {
  const auto dimension = static_cast<std::size_t>(points.dimension);
  std::string text = fmt::format("{}", fmt::join(axis_names, axis_names + dimension, ","));
  for (const SummedField& field : fields) text += fmt::format(",{}", fmt::join(field.columns, ","));
  text += '\n';
  const auto add = [&](const std::vector<double>& values, std::size_t i, std::size_t width) {
    for (std::size_t c = 0; c < width; ++c)
      fmt::format_to(std::back_inserter(text), "{:.17g},", values[i * width + c]);
  };
  for (std::size_t i = 0; i < points.target_count(); ++i) {
    add(points.places(), i, dimension);
    for (const SummedField& field : fields) add(field.values, i, field.columns.size());
    text.back() = '\n';
  }
  return text;
}

void print_sum(const SumOptions& options, const SumPoints& points, double seconds) {
  const auto targets = points.target_count();
  fmt::print("{} in {}D: {} sources, {} targets, method {}, tolerance {:g}\n", options.kernel,
             points.dimension, points.source_count(), targets, options.method, options.tolerance);
  fmt::print("{:.3g} s, {:.3g} million points a second\n", seconds,
             1e-6 * static_cast<double>(targets) / seconds);
}

/// Says how far the fields are from right ones; whether that is within the tolerance.
bool holds(const SumOptions& options, const SumTask& task, const SumPoints& points,
           const std::vector<SummedField>& fields) {
  const auto errors = sampled_errors(task, points, fields);
  const auto targets = std::min(points.target_count(), verified_targets);
  bool all = true;
  for (std::size_t f = 0; f < fields.size(); ++f) {
    const bool within = errors[f] <= options.tolerance;
    all = all && within;
    if (!options.quiet)
      fmt::print("{}: error {:.2e} of the largest value, at {} targets: {}\n", fields[f].name,
                 errors[f], targets, within ? "passed" : "FAILED, above the tolerance");
  }
  return all;
}

}  // namespace

int sum(const SumOptions& options) {
  check_numbers(options);
  check_together(options);
  check_result_file(options);
  const SumTask task = task_of(options);
  const SumPoints points = read_sum_points(task.kernel, options.points, options.targets);
  if (options.threads > 0) omp_set_num_threads(options.threads);
  const auto start = std::chrono::steady_clock::now();
  const auto fields = summed_fields(task, points);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  write_file(options.out, csv_of(points, fields));
  if (!options.quiet) print_sum(options, points, took.count());
  const bool passed = !options.verify || holds(options, task, points, fields);
  if (!options.quiet) fmt::print("result:  {}\n", options.out);
  return passed ? 0 : 1;
}

}  // namespace mote
