#include "mote/study/run_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "mote/neighbours/kd_tree.hpp"
#include "mote/neighbours/line.hpp"
#include "mote/operators/differential/apply.hpp"
#include "mote/output/certificate.hpp"
#include "mote/particles/failure.hpp"
#include "mote/scenario/located_error.hpp"
#include "mote/study/study_points.hpp"

namespace mote {
namespace {

template <int D>
NeighbourLists neighbours_of(const Points<D>& points, const NeighbourRule& rule) {
  NeighbourLists lists;
  if constexpr (D == 1)
    LineSearch().find(points, rule, lists);
  else
    KdTreeSearch<D>().find(points, rule, lists);
  return lists;
}

void refuse_lonely_points(const NeighbourLists& lists) {
  for (Index i = 0; i < lists.receivers(); ++i)
    if (lists[i].empty())
      throw NumericalFailure(fmt::format("point {} has no neighbour", i), {i},
                             "the operator's reach is smaller than the spacing of the points");
}

/// The values whose derivatives are formed.
struct Fields {
  std::vector<double> scalar, vector;
};

template <int D>
std::vector<double> computed(const std::string& quantity, const DifferentialOperator<D>& op,
                             const NeighbourLists& lists, const Fields& fields) {
  const auto receivers = static_cast<std::size_t>(lists.receivers());
  std::vector<double> result;
  const auto room = [&](std::size_t components) -> std::span<double> {
    result.resize(receivers * components);
    return result;
  };
  if (quantity == "gradient") gradient<D>(op, lists, fields.scalar, room(D));
  if (quantity == "laplacian") laplacian<D>(op, lists, fields.scalar, room(1));
  if (quantity == "hessian") hessian<D>(op, lists, fields.scalar, room(D * D));
  if (quantity == "divergence") divergence<D>(op, lists, fields.vector, room(1));
  if constexpr (D > 1)
    if (quantity == "curl") curl<D>(op, lists, fields.vector, room(D == 2 ? 1 : 3));
  for (std::size_t k = 0; k < result.size(); ++k)
    if (!std::isfinite(result[k])) {
      const auto point = static_cast<Index>(k / (result.size() / receivers));
      throw NumericalFailure(fmt::format("the {} at point {} is not finite", quantity, point),
                             {point}, "points at the same place, or nearly so");
    }
  return result;
}

/// The values of the points that are chosen; a point may have several values.
std::vector<double> only(const std::vector<double>& values, const std::vector<bool>& chosen) {
  std::vector<double> result;
  if (chosen.empty()) return result;
  const std::size_t components = values.size() / chosen.size();
  for (std::size_t k = 0; k < values.size(); ++k)
    if (chosen[k / components]) result.push_back(values[k]);
  return result;
}

/// A study in one number of dimensions.
template <int D>
class Runner {
 public:
  Runner(const StudyFile& study, const Catalogue& catalogue, const std::filesystem::path& folder,
         const std::function<void(const StudyCase&)>& visit)
      : study_(study), catalogue_(catalogue), folder_(folder), visit_(visit), exact_(study) {}

  StudyResult run() {
    for (const auto& layout : study_.layouts)
      if (layout.type == "file")
        for (const auto& item : study_.operators) check_up_on(layout, item);
    for (const auto& layout : study_.layouts)
      for (const double resolution : resolutions_of(layout))
        for (const auto& item : study_.operators)
          measure({study_, catalogue_, layout, static_cast<Index>(resolution),
                   cells_beyond(item, layout), folder_},
                  item);
    return std::move(result_);
  }

 private:
  std::vector<double> resolutions_of(const StudyFile::Layout& layout) const {
    return layout.type == "file" ? std::vector<double>{0} : study_.resolutions;
  }

  DifferentialOperator<D>& differential_operator(const StudyFile::Operator& item) const {
    return dynamic_cast<DifferentialOperator<D>&>(*item.choice.made);
  }

  /// On a line twice the reach by default: the cells of a graded mesh may be shorter beyond its
  /// end.
  Index cells_beyond(const StudyFile::Operator& item, const StudyFile::Layout& layout) const {
    if (study_.extension.type == "none" || layout.type == "file") return 0;
    if (item.extension_cells) return static_cast<Index>(*item.extension_cells);
    if (study_.extension.cells) return static_cast<Index>(*study_.extension.cells);
    const double reach = differential_operator(item).neighbour_rule().reach();
    return static_cast<Index>(std::ceil(D == 1 ? 2 * reach : reach));
  }

  /// The points of a request, which operators one after the other mostly share.
  const StudyPoints<D>& placed_points(const PointRequest& request) {
    const auto key = std::tuple(&request.layout, request.resolution, request.beyond);
    if (key != placed_for_) {
      placed_ = study_points<D>(request, exact_);
      placed_for_ = key;
    }
    return placed_;
  }

  /// The neighbourhoods of a user's own points, before any operator can fail on them.
  void check_up_on(const StudyFile::Layout& layout, const StudyFile::Operator& item) {
    const PointRequest request{study_, catalogue_, layout, 0, 0, folder_};
    guard(request, item, [&] {
      const Points<D>& points = placed_points(request).points;
      const NeighbourRule rule = differential_operator(item).neighbour_rule();
      const NeighbourLists lists = neighbours_of(points, rule);
      StudyCase checked{.layout = layout,
                        .resolution = points.receivers,
                        .differential_operator = item.name,
                        .dimension = D,
                        .positions = points.position,
                        .neighbourhoods = check_up(points, rule, lists)};
      CheckUpSummary summary = summary_of(checked.neighbourhoods);
      summary.layout = layout.name;
      summary.differential_operator = item.name;
      result_.check_ups.push_back(std::move(summary));
      visit_(checked);
    });
  }

  void measure(const PointRequest& request, const StudyFile::Operator& item) {
    guard(request, item, [&] {
      const StudyPoints<D>& placed = placed_points(request);
      for (const auto& remark : placed.remarks) remark_once(remark);
      apply(request, item, placed);
    });
  }

  /// Does some work and tells what goes wrong as an error of the layout or the operator.
  template <class Work>
  void guard(const PointRequest& request, const StudyFile::Operator& item, Work work) const {
    try {
      work();
    } catch (const NumericalFailure& failure) {
      throw InputError(
          fmt::format("operators.{}", &item - study_.operators.data()),
          fmt::format(
              "operator '{}' on layout '{}'{}: {}: {}", item.name, request.layout.name,
              request.resolution > 0 ? fmt::format(" with resolution {}", request.resolution) : "",
              failure.what(), failure.cause()));
    } catch (const InputError& error) {
      const bool of_layout = error.key() == "layouts", of_operator = error.key() == "operator";
      if (!of_layout && !of_operator) throw;
      throw InputError(of_layout
                           ? fmt::format("layouts.{}", &request.layout - study_.layouts.data())
                           : fmt::format("operators.{}", &item - study_.operators.data()),
                       error.what());
    }
  }

  void apply(const PointRequest& request, const StudyFile::Operator& item,
             const StudyPoints<D>& placed) {
    const Points<D>& points = placed.points;
    DifferentialOperator<D>& op = differential_operator(item);
    const NeighbourRule rule = op.neighbour_rule();
    const NeighbourLists lists = neighbours_of(points, rule);
    refuse_lonely_points(lists);
    op.prepare(points, lists);
    for (const auto& remark : op.remarks())
      remark_once(
          fmt::format("operator '{}' on layout '{}': {}", item.name, request.layout.name, remark));
    const Fields fields = fields_on(placed);
    const auto receivers = static_cast<std::size_t>(points.receivers);
    const bool is_file = request.layout.type == "file";
    StudyCase result{.layout = request.layout,
                     .resolution = is_file ? points.receivers : request.resolution,
                     .differential_operator = item.name,
                     .dimension = D,
                     .positions = std::span(points.position).first(receivers * D),
                     .field = std::span(fields.scalar).first(receivers)};
    for (const std::string& quantity : study_.quantities) {
      QuantityValues values{
          quantity, exact_.components(quantity), {}, exact_.exact(quantity, result.positions)};
      if (quantity == "hessian" && !op.has_hessian()) {
        remark_once(fmt::format("the operator '{}' has no Hessian", item.name));
        values.computed.assign(values.exact.size(), std::numeric_limits<double>::quiet_NaN());
      } else {
        values.computed = computed<D>(quantity, op, lists, fields);
        add_rows(result, values, placed.interior);
      }
      result.quantities.push_back(std::move(values));
    }
    visit_(result);
  }

  /// The fields on all points; a file's own column stands in for the formula, also where the vector
  /// field is the field in each component.
  Fields fields_on(const StudyPoints<D>& placed) const {
    const auto& position = placed.points.position;
    if (placed.field.empty()) return {exact_.field(position), exact_.vector_field(position)};
    const bool vector_follows = std::ranges::all_of(
        study_.vector_field, [&](const std::string& formula) { return formula == study_.field; });
    if (!vector_follows) return {placed.field, exact_.vector_field(position)};
    std::vector<double> vector;
    for (const double value : placed.field) vector.insert(vector.end(), D, value);
    return {placed.field, std::move(vector)};
  }

  void add_rows(const StudyCase& done, const QuantityValues& values,
                const std::vector<bool>& interior) {
    const ErrorNorms everywhere = error_norms(values.quantity, values.computed, values.exact);
    const ErrorNorms inside =
        error_norms(values.quantity, only(values.computed, interior), only(values.exact, interior));
    for (const std::string& norm : study_.norms) {
      const ErrorNorms& errors = norm.starts_with("interior_") ? inside : everywhere;
      const double error = norm.ends_with("l1")   ? errors.l1
                           : norm.ends_with("l2") ? errors.l2
                                                  : errors.max;
      StudyRow row{done.layout.name,
                   done.resolution,
                   done.differential_operator,
                   values.quantity,
                   norm,
                   error,
                   std::nullopt};
      row.order = order_of(row);
      result_.rows.push_back(std::move(row));
    }
  }

  /// The order of a new row against the row of the resolution before, if there is one and neither
  /// error is rounding.
  std::optional<double> order_of(const StudyRow& row) const {
    for (auto before = result_.rows.rbegin(); before != result_.rows.rend(); ++before)
      if (before->layout == row.layout && before->quantity == row.quantity &&
          before->norm == row.norm && before->differential_operator == row.differential_operator) {
        constexpr double rounding = 1e-13;
        if (!(before->error > rounding && row.error > rounding)) return std::nullopt;
        return std::log(before->error / row.error) /
               std::log(static_cast<double>(row.resolution) /
                        static_cast<double>(before->resolution));
      }
    return std::nullopt;
  }

  void remark_once(const std::string& remark) {
    if (std::ranges::find(result_.remarks, remark) == result_.remarks.end())
      result_.remarks.push_back(remark);
  }

  const StudyFile& study_;
  const Catalogue& catalogue_;
  const std::filesystem::path& folder_;
  const std::function<void(const StudyCase&)>& visit_;
  ExactField exact_;
  std::tuple<const StudyFile::Layout*, Index, Index> placed_for_;  ///< what placed_ was made for
  StudyPoints<D> placed_;
  StudyResult result_;
};

}  // namespace

const StudyRow* StudyResult::finest(const std::string& layout,
                                    const std::string& differential_operator,
                                    const std::string& quantity, const std::string& norm) const {
  const auto found = std::ranges::find_if(rows.rbegin(), rows.rend(), [&](const StudyRow& row) {
    return row.layout == layout && row.differential_operator == differential_operator &&
           row.quantity == quantity && row.norm == norm;
  });
  return found == rows.rend() ? nullptr : &*found;
}

StudyResult run_study(const Document& document, const StudyFile& study, const Catalogue& catalogue,
                      const std::filesystem::path& folder,
                      const std::function<void(const StudyCase&)>& visit) {
  try {
    if (study.dimension == 1) return Runner<1>(study, catalogue, folder, visit).run();
    if (study.dimension == 2) return Runner<2>(study, catalogue, folder, visit).run();
    return Runner<3>(study, catalogue, folder, visit).run();
  } catch (const InputError& error) {
    throw LocatedError(document.locate(error.key()), error.what());
  }
}

}  // namespace mote
