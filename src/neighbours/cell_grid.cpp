#include "mote/neighbours/cell_grid.hpp"

#include <omp.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "mote/neighbours/cell_scan.hpp"

namespace mote {
namespace {

/// Receivers whose lists one thread finds at a time.
constexpr Index block_size = 1024;

/// How many places ahead memory is asked for, where points come in no order.
constexpr Index places_ahead = 32;

/// Pieces of the points that are counted apart, one a thread; each has a count for every cell.
constexpr Index most_pieces = 8;

/// Distance of two points, its squares summed in the order of the axes as every search does.
template <int D>
double distance(const Points<D>& points, Index i, Index j) {
  double sum = 0;
  for (int d = 0; d < D; ++d) {
    const double x = points.position[i * D + d] - points.position[j * D + d];
    sum += x * x;
  }
  return std::sqrt(sum);
}

}  // namespace

template <int D>
void CellGrid<D>::find_cells(std::span<const double> position, Index receivers) {
  const auto count = static_cast<Index>(position.size() / D);
  others_ = receivers < count;
  cell_.resize(static_cast<std::size_t>(count));
#pragma omp parallel for schedule(static) if (parallel_from <= count)
  for (Index i = 0; i < count; ++i) {
    std::array<double, D> place;
    std::copy_n(position.data() + std::ptrdiff_t{i} * D, D, place.data());
    cell_[i] = layout_.cell_at(place) + (i < receivers ? 0 : layout_.cells);
  }
}

/// Sorts points by cell, those of a cell by number.
template <int D>
void CellGrid<D>::sort() {
  const auto count = static_cast<Index>(cell_.size());
  const Index pieces = count < parallel_from ? 1 : std::min(most_pieces, omp_get_max_threads());
  const auto cells = static_cast<std::size_t>(all_cells());
  const auto first = [&](Index piece) { return std::int64_t{count} * piece / pieces; };
  count_.assign(cells * static_cast<std::size_t>(pieces), 0);
  order_.resize(cell_.size());
#pragma omp parallel for schedule(static) num_threads(pieces)
  for (Index piece = 0; piece < pieces; ++piece)
    for (auto i = first(piece), end = first(piece + 1); i < end; ++i)
      ++count_[piece * cells + cell_[i]];
  Index sum = 0;
  for (std::size_t cell = 0; cell < cells; ++cell)
    for (Index piece = 0; piece < pieces; ++piece)
      sum += std::exchange(count_[piece * cells + cell], sum);
#pragma omp parallel for schedule(static) num_threads(pieces)
  for (Index piece = 0; piece < pieces; ++piece)
    for (auto i = first(piece), end = first(piece + 1); i < end; ++i)
      order_[count_[piece * cells + cell_[i]]++] = static_cast<Index>(i);
}

/// Sorts the points of each cell by `id`.
template <int D>
void CellGrid<D>::sort_by_id(std::span<const Index> id) {
  const Index cells = all_cells();
  const Index* const end = count_.data() + count_.size() - cells;
#pragma omp parallel for schedule(static) if (parallel_from <= cells)
  for (Index cell = 0; cell < cells; ++cell)
    std::sort(order_.begin() + (cell > 0 ? end[cell - 1] : 0), order_.begin() + end[cell],
              [&](Index a, Index b) { return id[a] < id[b]; });
}

template <int D>
std::span<const Index> CellGrid<D>::order(std::span<const double> position, Index receivers,
                                          double reach, std::span<const Index> id) {
  order_.clear();
  if (position.empty()) return order_;
  layout_ = CellLayout<D>(position, reach);
  find_cells(position, receivers);
  sort();
  if (!id.empty()) sort_by_id(id);
  return order_;
}

/// Takes over the coordinates of points in the order of cells, and their cells.
template <int D>
void CellGrid<D>::spread(std::span<const double> position, Index receivers, bool sorted) {
  const auto count = static_cast<Index>(position.size() / D);
  others_ = receivers < count;
  cell_.resize(static_cast<std::size_t>(count));
  for (auto& x : place_) x.resize(static_cast<std::size_t>(count) + scan_lanes);
  for (auto& x : rough_) x.resize(static_cast<std::size_t>(count) + scan_lanes);
#pragma omp parallel for schedule(static) if (parallel_from <= count)
  for (Index k = 0; k < count; ++k) {
    const auto place_of = [&](Index n) { return position.data() + std::ptrdiff_t{n} * D; };
    const double* at = place_of(sorted ? k : order_[k]);
    if (!sorted && k + places_ahead < count) __builtin_prefetch(place_of(order_[k + places_ahead]));
    std::array<double, D> place;
    for (int d = 0; d < D; ++d) {
      place[d] = place_[d][k] = at[d];
      rough_[d][k] = static_cast<float>(layout_.in_rough_unit(at[d] - layout_.corner[d]));
    }
    cell_[k] = layout_.cell_at(place) + (k < receivers ? 0 : layout_.cells);
  }
}

/// Takes over points that stand in the order of cells; returns whether they do. The first few of
/// those that do not mostly tell.
template <int D>
bool CellGrid<D>::spread_in_order(std::span<const double> position, Index receivers) {
  const auto few = static_cast<Index>(std::min<std::size_t>(100, position.size() / D));
  find_cells(position.first(static_cast<std::size_t>(few) * D), receivers);
  if (!std::ranges::is_sorted(cell_)) return false;
  spread(position, receivers, true);
  return std::ranges::is_sorted(cell_);
}

/// Marks the place of every cell's first point. The thread of a point marks the cells after those
/// of the point before.
template <int D>
void CellGrid<D>::mark_starts() {
  const auto count = static_cast<Index>(cell_.size());
  start_.resize(static_cast<std::size_t>(all_cells()) + 1);
#pragma omp parallel for schedule(static) if (parallel_from <= count)
  for (Index k = 0; k <= count; ++k) {
    const Index last = k < count ? cell_[k] : all_cells();
    for (Index cell = k > 0 ? cell_[k - 1] + 1 : 0; cell <= last; ++cell) start_[cell] = k;
  }
}

template <int D>
void CellGrid<D>::find(std::span<const double> position, Index receivers, double reach,
                       std::span<const std::uint8_t> idle, ListForm form, NeighbourLists& lists) {
  lists.restart(receivers, position.size() / D + scan_lanes);
  if (receivers == 0) return;
  layout_ = CellLayout<D>(position, reach);
  const bool sorted = spread_in_order(position, receivers);
  if (!sorted) {
    find_cells(position, receivers);
    sort();
    spread(position, receivers, false);
    order_.resize(order_.size() + scan_lanes);
  }
  mark_starts();
  SortedPoints<D> points{
      layout_, {}, {}, cell_.data(), start_.data(), sorted ? nullptr : order_.data(), others_};
  for (int d = 0; d < D; ++d) {
    points.place[d] = place_[d].data();
    points.rough[d] = rough_[d].data();
  }
  const bool ascends = sorted && !layout_.is_folded;
  const Index blocks = (receivers + block_size - 1) / block_size;
#pragma omp parallel if (parallel_from <= receivers)
  {
    NeighbourLists::Writer writer(lists);
    CellScan<D> scan(points, reach, rim_tolerance);
#pragma omp for schedule(dynamic)
    for (Index block = 0; block < blocks; ++block)
      for (Index k = block * block_size; k < std::min(receivers, (block + 1) * block_size); ++k) {
        Index* const list = writer.room(scan.look_around(k) + scan_lanes);
        const Index i = sorted ? k : order_[k];
        if (!sorted && k + scan_lanes < receivers) writer.fetch_ahead(order_[k + scan_lanes]);
        const bool rests = !idle.empty() && idle[i];
        const bool later = form == ListForm::later && !rests;
        Index* end = scan.find(list, later && ascends);
        if (rests) end = std::remove_if(list, end, [&](Index j) { return idle[j] != 0; });
        if (later && !ascends) end = std::remove_if(list, end, [&](Index j) { return j < i; });
        if (form != ListForm::any_order && !ascends) std::sort(list, end);
        writer.close(i, end);
      }
  }
}

template <int D>
void CellGridSearch<D>::find(const Points<D>& points, const NeighbourRule& rule,
                             NeighbourLists& lists) {
  if (rule.adjacent > 0) throw std::invalid_argument("only points on a line have adjacent points");
  const auto& length = points.length;
  const double longest = length.empty() ? 0 : std::ranges::max(length);
  grid_.find(points.position, points.receivers, rule.support * (rule.smoothing_length * longest),
             {}, ListForm::any_order, lists);
  if (std::ranges::all_of(length, [&](double each) { return each == longest; })) return;
  lists.keep_if(
      [&](Index i, Index j) { return rule.accepts(distance(points, i, j), length[i], length[j]); });
}

template class CellGrid<1>;
template class CellGrid<2>;
template class CellGrid<3>;
template class CellGridSearch<1>;
template class CellGridSearch<2>;
template class CellGridSearch<3>;

}  // namespace mote
