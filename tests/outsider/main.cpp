// mote with a kernel, an operator and an integrator of our own, and one built-in written again.

#include <mote/app/command_line.hpp>
#include <mote/catalogue/catalogue.hpp>

namespace outsider {

using mote::Index;
using mote::Vec;

/// Epanechnikov's parabola: h W = 3/4 (1 - q^2) on a line; 2/pi and 15/(8 pi) in more dimensions.
template <int D>
struct Parabola {
  static constexpr std::string_view name = "parabola";
  static constexpr std::string_view summary = "Epanechnikov's parabola; h is its support";
  static constexpr double usual_length = 3;
  static constexpr double norm = D == 1   ? 3.0 / 4
                                 : D == 2 ? 2 / std::numbers::pi
                                          : 15 / (8 * std::numbers::pi);

  static constexpr double support() { return 1; }
  static constexpr double value(double q) { return q <= 1 ? norm * (1 - q * q) : 0; }
  static constexpr double slope_over_q(double q) { return q <= 1 ? -2 * norm : 0; }
  static constexpr double curvature(double q) { return q <= 1 ? -2 * norm : 0; }
};

/// mote's Lucy kernel, written again from the paper; must give the same bits.
template <int D>
struct LucyAgain : mote::Lucy<D> {
  static constexpr std::string_view name = "lucy_again";

  static constexpr double norm = mote::Lucy<D>::norm;
  static constexpr double value(double q) {
    return mote::inside(q, 1) ? norm * (1 + 3 * q) * (1 - q) * (1 - q) * (1 - q) : 0;
  }
  static constexpr double slope_over_q(double q) {
    return mote::inside(q, 1) ? -12 * norm * (1 - q) * (1 - q) : 0;
  }
};

/// The slope of the straight line through a point that fits its neighbours best, in the sense of
/// least squares; on a line only.
template <int D>
class FittedLine final : public mote::DifferentialOperator<D> {
 public:
  static constexpr int highest_dimension = 1;
  static constexpr std::string_view family = "fitted_line";
  static constexpr std::string_view summary = "slope of the best straight line";

  void describe(mote::Description& description) override {
    description.count({"neighbours", "on each side"}, neighbours_, {1, 10});
  }
  mote::NeighbourRule neighbour_rule() const override {
    return {.adjacent = static_cast<Index>(neighbours_)};
  }
  void prepare(const mote::Points<D>& points, const mote::NeighbourLists& lists) override {
    points_ = &points;
    lists_ = &lists;
  }
  void gradient_weights(Index i, std::span<Vec<D>> weights) const override {
    double squares = 0;
    for (const Index j : (*lists_)[i]) squares += (points_->at(j) - points_->at(i)).squaredNorm();
    for (std::size_t k = 0; k < weights.size(); ++k)
      weights[k] = (points_->at((*lists_)[i][k]) - points_->at(i)) / squares;
  }
  void laplacian_weights(Index i, std::span<double> weights) const override {
    double squares = 0;
    for (const Index j : (*lists_)[i]) squares += (points_->at(j) - points_->at(i)).squaredNorm();
    for (double& weight : weights) weight = 2 / squares;
  }

 private:
  std::int64_t neighbours_ = 1;
  const mote::Points<D>* points_ = nullptr;
  const mote::NeighbourLists* lists_ = nullptr;
};

/// Drift, kick, drift: the other leapfrog.
class DriftKickDrift final : public mote::Integrator {
 public:
  static constexpr std::string_view name = "drift_kick_drift";
  static constexpr std::string_view summary = "order 2, drifts first";
  static constexpr int order = 2;

  void advance_one_step(mote::System& system, double time, double step) override {
    system.prepare(time);
    system.update_drift_rates(time);
    drift(system, step / 2);
    system.prepare(time + step / 2);
    system.update_kick_rates(time + step / 2);
    kick(system, step);
    system.update_drift_rates(time + step / 2);
    drift(system, step / 2);
  }
};

}  // namespace outsider

int main(int argc, char** argv) {
  mote::Catalogue catalogue = mote::standard_catalogue();
  catalogue.add_kernel<outsider::Parabola>();
  catalogue.add_kernel<outsider::LucyAgain>();
  catalogue.add_family<outsider::FittedLine>();
  catalogue.add_integrator<outsider::DriftKickDrift>();
  return mote::command_line(catalogue, argc, argv);
}
