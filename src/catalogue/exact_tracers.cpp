#include "mote/catalogue/exact_tracers.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "mote/exact/steady_flows.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

/// What rounding explains, relative to the fastest tracer.
constexpr double rounding = 1e-9;

/// Places and velocities of tracers at the start, a column each.
struct Tracks {
  Eigen::MatrixXd places, velocities;
};

[[noreturn]] void refuse(std::string_view solution, const std::string& problem) {
  throw InputError("check.against", fmt::format("{} {}", solution, problem));
}

Tracks tracks_of(const FlowSetup& setup, std::string_view solution) {
  if (!setup.parameters.contains("tracers")) refuse(solution, "is a solution of the model tracers");
  if (setup.parameters.at("steady") == 0)
    refuse(solution, "needs a velocity that does not change with time");
  const Eigen::Index dimension = setup.start.dimension, count = setup.initial.count();
  const auto columns = [&](std::span<const double> values) {
    return Eigen::MatrixXd::Map(values.data(), dimension, count);
  };
  return {columns(setup.initial.position()), columns(setup.initial.values("velocity"))};
}

/// A linear velocity that is periodic along an axis does not depend on it.
void make_periodic(const SpaceStart& start, double fastest, Eigen::MatrixXd& gradient) {
  for (Eigen::Index d = 0; d < gradient.cols(); ++d) {
    const auto axis = static_cast<std::size_t>(d);
    if (!start.periodic[axis]) continue;
    const double jump = gradient.col(d).norm() * (start.upper[axis] - start.lower[axis]);
    if (jump > rounding * fastest)
      refuse(LinearFlow::name, fmt::format("needs a velocity that is the same all along {}, where "
                                           "the domain is periodic",
                                           axis_names[d]));
    gradient.col(d).setZero();
  }
}

/// Least squares about the means c: A = sum v (x - c)^T (sum (x - c) (x - c)^T)^-1.
std::unique_ptr<FlowSolution> linear_from(const FlowSetup& setup) {
  const Tracks of = tracks_of(setup, LinearFlow::name);
  const auto dimension = of.places.rows();
  const Eigen::VectorXd centre = of.places.rowwise().mean(), drift = of.velocities.rowwise().mean();
  const Eigen::MatrixXd x = of.places.colwise() - centre, v = of.velocities.colwise() - drift;
  const Eigen::FullPivLU<Eigen::MatrixXd> moments(x * x.transpose());
  if (!moments.isInvertible())
    refuse(LinearFlow::name, "needs tracers that are not all on one line or plane");
  Eigen::MatrixXd gradient = (v * x.transpose()) * moments.inverse();
  const double wrong = (v - gradient * x).cwiseAbs().maxCoeff();
  const double fastest = of.velocities.cwiseAbs().maxCoeff();
  if (wrong > rounding * fastest)
    refuse(
        LinearFlow::name,
        fmt::format("needs a velocity that is linear in space, and this one differs by {:.2g} of "
                    "its largest",
                    wrong / fastest));
  make_periodic(setup.start, fastest, gradient);
  LinearVelocity velocity{.dimension = setup.start.dimension};
  velocity.gradient.topLeftCorner(dimension, dimension) = gradient;
  velocity.centre.head(dimension) = centre;
  velocity.at_centre.head(dimension) = drift - gradient * x.rowwise().mean();
  const auto position = setup.initial.position();
  return std::make_unique<LinearFlow>(velocity,
                                      std::vector<double>(position.begin(), position.end()));
}

/// The centre c of all circles: v.(x - c) = 0 for everybody, by least squares.
Eigen::Vector2d centre_of(const Tracks& of) {
  const Eigen::VectorXd along = of.places.cwiseProduct(of.velocities).colwise().sum().transpose();
  const Eigen::FullPivLU<Eigen::Matrix2d> moments(of.velocities * of.velocities.transpose());
  if (!moments.isInvertible()) refuse(CircularFlow::name, "needs velocities in all directions");
  return moments.solve(Eigen::Vector2d(of.velocities * along));
}

void refuse_several_rates_at_one_radius(std::vector<CirclingPoint> points) {
  std::ranges::sort(points, {}, &CirclingPoint::radius);
  const auto differ = [](const CirclingPoint& a, const CirclingPoint& b) {
    const double difference = std::abs(b.angular_velocity - a.angular_velocity);
    return b.radius - a.radius <= rounding * b.radius &&
           difference > std::sqrt(rounding) * std::abs(a.angular_velocity);
  };
  if (std::ranges::adjacent_find(points, differ) != points.end())
    refuse(CircularFlow::name, "needs an angular velocity that depends on the radius alone");
}

void refuse_circles_through_periodic_sides(const SpaceStart& start, const Eigen::Vector2d& centre,
                                           const std::vector<CirclingPoint>& points) {
  const double radius = std::ranges::max(points, {}, &CirclingPoint::radius).radius;
  for (const Eigen::Index d : {0, 1}) {
    const auto axis = static_cast<std::size_t>(d);
    if (start.periodic[axis] &&
        (centre[d] - radius < start.lower[axis] || centre[d] + radius > start.upper[axis]))
      refuse(CircularFlow::name,
             fmt::format("needs circles within the domain along {}, where it is periodic",
                         axis_names[d]));
  }
}

std::unique_ptr<FlowSolution> circular_from(const FlowSetup& setup) {
  const Tracks of = tracks_of(setup, CircularFlow::name);
  if (setup.start.dimension != 2) refuse(CircularFlow::name, "is a flow in 2 dimensions");
  const Eigen::Vector2d centre = centre_of(of);
  const double fastest = of.velocities.colwise().norm().maxCoeff();
  std::vector<CirclingPoint> points;
  for (Eigen::Index i = 0; i < of.places.cols(); ++i) {
    const Eigen::Vector2d x = of.places.col(i) - centre, v = of.velocities.col(i);
    const double radius = x.norm();
    if (std::abs(v.dot(x)) > rounding * fastest * radius)
      refuse(CircularFlow::name, "needs velocities at right angles to the way from one centre");
    points.push_back(
        {.radius = radius,
         .angle = std::atan2(x[1], x[0]),
         .angular_velocity = radius > 0 ? (x[0] * v[1] - x[1] * v[0]) / (radius * radius) : 0});
  }
  refuse_several_rates_at_one_radius(points);
  refuse_circles_through_periodic_sides(setup.start, centre, points);
  return std::make_unique<CircularFlow>(std::array{centre[0], centre[1]}, std::move(points));
}

}  // namespace

std::vector<ExactEntry> tracer_entries() {
  const std::vector<std::string> fields{"position", "velocity"};
  return {{choice_of<LinearFlow>(), fields, {}, linear_from},
          {choice_of<CircularFlow>(), fields, {}, circular_from}};
}

}  // namespace mote
