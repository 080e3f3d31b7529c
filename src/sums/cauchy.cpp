#include "mote/sums/cauchy.hpp"

#include "mote/sums/pair_shapes.hpp"
#include "mote/sums/plane_fields.hpp"
#include "mote/sums/tree_sum.hpp"

namespace mote {
namespace {

/// v/(s - t).
struct CauchyKernel {
  static constexpr int dimension = 2, strengths = 2, outputs = 2;

  [[gnu::always_inline]] void add(const std::array<Lanes, 2>& difference,
                                  const std::array<double, 2>& strength,
                                  std::array<Lanes, 2>& sums) const {
    const auto& [x, y] = difference;
    const Lanes inverse = PointShape<2>::influence(x * x + y * y);
    sums[0] += (strength[0] * x + strength[1] * y) * inverse;
    sums[1] += (strength[1] * x - strength[0] * y) * inverse;
  }
};

/// Points of a leaf of the tree: the multipole method is fastest at some 64.
constexpr Index leaf_capacity = 64;

std::span<const double> numbers(std::span<const Complex> values) {
  return {reinterpret_cast<const double*>(values.data()), 2 * values.size()};
}

}  // namespace

class Cauchy::Sum {
 public:
  explicit Sum(const SumSettings& settings)
      : settings_(settings), tree_sum_(PlaneCauchy(settings.tolerance), leaf_capacity) {}

  void evaluate(std::span<const Complex> targets, std::span<const Complex> sources,
                std::span<const Complex> strengths, std::span<Complex> result) {
    tree_sum_.evaluate(CauchyKernel(), 0, numbers(targets), numbers(sources), numbers(strengths),
                       [&](std::size_t i, const std::array<double, 2>& value) {
                         result[i] = {value[0], value[1]};
                       });
  }

 private:
  SumSettings settings_;
  TreeSum<CauchyKernel, PlaneCauchy> tree_sum_;
};

Cauchy::Cauchy(const SumSettings& settings) : sum_(std::make_unique<Sum>(settings)) {}
Cauchy::~Cauchy() = default;

void Cauchy::at_sources(std::span<const Complex> points, std::span<const Complex> strengths,
                        std::span<Complex> result) {
  sum_->evaluate({}, points, strengths, result);
}

void Cauchy::at(std::span<const Complex> targets, std::span<const Complex> sources,
                std::span<const Complex> strengths, std::span<Complex> result) {
  if (!targets.empty()) sum_->evaluate(targets, sources, strengths, result);
}

}  // namespace mote
