#include "mote/integrators/wisdom_holman.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace mote {
namespace {

std::size_t packs_for(std::size_t count) { return (count + pack_size - 1) / pack_size; }

double number(const std::vector<PackVector>& vectors, std::size_t body, std::size_t d) {
  return vectors[body / pack_size][d][body % pack_size];
}

template <class Value>
std::vector<Pack> packs_of(std::size_t count, Value value) {
  std::vector<Pack> packs(packs_for(count));
  for (std::size_t k = 1; k < count; ++k) packs[k / pack_size][k % pack_size] = value(k);
  return packs;
}

/// Places and velocities of what is no planet: off the centre, at rest.
void idle(std::vector<PackVector>& place, std::vector<PackVector>& velocity, std::size_t count) {
  place.assign(packs_for(count), {Pack{} + 1, Pack{}, Pack{}});
  velocity.assign(packs_for(count), {});
}

/// Sums of the masses up to each.
std::vector<double> masses_within(std::span<const double> mass) {
  std::vector<double> within(mass.size());
  std::partial_sum(mass.begin(), mass.end(), within.begin());
  return within;
}

[[gnu::always_inline]] inline Pack square(const PackVector& x) {
  return x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
}

/// 1/|x|^3.
[[gnu::always_inline]] inline Pack inverse_cube(const Pack& square) {
  const Pack inverse = 1 / square;
  return inverse * root(inverse);
}

bool same_bits(std::span<const double> values, const std::vector<double>& left) {
  return values.size() == left.size() &&
         std::memcmp(values.data(), left.data(), values.size_bytes()) == 0;
}

}  // namespace

template <class Weight>
WisdomHolman::Triangle::Triangle(std::size_t count, Weight weight)
    : count_(count), packs_(packs_for(count)), weight_(count * packs_) {
  for (std::size_t from = 1; from < count; ++from)
    for (std::size_t to = 0; to < count; ++to)
      weight_[from * packs_ + to / pack_size][to % pack_size] = weight(from, to);
}

[[gnu::always_inline]] inline void WisdomHolman::Triangle::add(const Vectors& from, PackVector& to,
                                                               std::size_t pack) const {
  for (std::size_t k = 1; k < count_; ++k)
    for (std::size_t d = 0; d < 3; ++d) to[d] += weight_[k * packs_ + pack] * number(from, k, d);
}

WisdomHolman::Weights::Weights(const PointMasses& masses)
    : count(masses.mass.size()),
      within(masses_within(masses.mass)),
      mass(packs_of(count, [&](std::size_t k) { return masses.mass[k]; })),
      pull(packs_of(count,
                    [&](std::size_t k) { return masses.gravitational_constant * within[k]; })),
      first_part(packs_of(count, [&](std::size_t k) { return masses.mass[0] / within[k - 1]; })),
      first_pull(masses.gravitational_constant * masses.mass[0]),
      centre(count,
             [&](std::size_t from, std::size_t to) {
               return to <= from ? -masses.mass[from] / within[from] : 0;
             }),
      before(count,
             [&](std::size_t from, std::size_t to) {
               return from < to ? masses.mass[from] / within[from] : 0;
             }),
      outer(count, [&](std::size_t from,
                       std::size_t to) { return 0 < to && to < from ? 1 / within[to - 1] : 0; }),
      inner(count,
            [&](std::size_t from, std::size_t to) { return from < to ? -1 / within[to - 1] : 0; }) {
  for (const double m : masses.mass) planet_pull.push_back(masses.gravitational_constant * m);
}

std::string WisdomHolman::missing_in(System& system) const {
  const auto masses = system.point_masses();
  if (!masses || system.dimension() != 3) return "point masses in three dimensions";
  const auto& mass = masses->mass;
  if (mass.empty() || !(2 * mass[0] > std::accumulate(mass.begin(), mass.end(), 0.0)))
    return "a first body that is heavier than all others together";
  return {};
}

void WisdomHolman::advance_one_step(System& system, double /*time*/, double step) {
  if (!is_where_it_was_left(system)) take(system);
  if (!weights_) weights_.emplace(*system.point_masses());
  if (!has_kicks_) update_kicks();
  kick(step / 2);
  drift(step);
  update_kicks();
  kick(step / 2);
  give(system);
}

bool WisdomHolman::is_where_it_was_left(System& system) const {
  return same_bits(system.drifted().front().value, left_place_) &&
         same_bits(system.kicked().front().value, left_velocity_);
}

/// q_k = x_k - c_(k-1), c_k = c_(k-1) + (m_k/M_k) q_k, and the same of velocities.
void WisdomHolman::take(System& system) {
  const PointMasses masses = *system.point_masses();
  weights_.emplace(masses);
  has_kicks_ = false;
  const std::vector<double>& within = weights_->within;
  idle(place_, velocity_, weights_->count);
  for (auto* column : {&kick_, &from_first_, &planets_force_, &first_force_})
    column->assign(place_.size(), {});
  const auto transform = [&](std::span<const double> from, Vectors& to,
                             std::array<double, 3>& centre) {
    std::copy_n(from.begin(), 3, centre.begin());
    for (std::size_t k = 1; k < within.size(); ++k)
      for (std::size_t d = 0; d < 3; ++d) {
        const double q = from[3 * k + d] - centre[d];
        to[k / pack_size][d][k % pack_size] = q;
        centre[d] += masses.mass[k] / within[k] * q;
      }
  };
  transform(system.drifted().front().value, place_, centre_place_);
  transform(system.kicked().front().value, velocity_, centre_velocity_);
}

/// x_k = c + q_k - sum_(j >= k) (m_j/M_j) q_j.
void WisdomHolman::give(System& system) {
  const auto transform = [&](const Vectors& from, const std::array<double, 3>& centre,
                             std::vector<double>& left, std::span<double> to) {
    left.resize(to.size());
    for (std::size_t p = 0; p < from.size(); ++p) {
      PackVector sum;
      for (std::size_t d = 0; d < 3; ++d) {
        sum[d] = from[p][d];
        if (p == 0) sum[d][0] = 0;
      }
      weights_->centre.add(from, sum, p);
      const std::size_t end = std::min(weights_->count, (p + 1) * pack_size);
      for (std::size_t k = p * pack_size; k < end; ++k)
        for (std::size_t d = 0; d < 3; ++d) left[3 * k + d] = centre[d] + sum[d][k % pack_size];
    }
    std::ranges::copy(left, to.begin());
  };
  transform(place_, centre_place_, left_place_, system.drifted().front().value);
  transform(velocity_, centre_velocity_, left_velocity_, system.kicked().front().value);
}

/// What is left of the forces when Kepler's are taken away, as the class states it.
void WisdomHolman::update_kicks() {
  ++evaluations_;
  const Weights& w = *weights_;
  for (std::size_t p = 0; p < place_.size(); ++p) {
    from_first_[p] = place_[p];
    w.before.add(place_, from_first_[p], p);
  }
  for (std::size_t p = 0; p < place_.size(); ++p) {
    const PackVector &q = place_[p], &x = from_first_[p];
    const Pack by_orbit = inverse_cube(square(q)), by_first = inverse_cube(square(x));
    const PackVector planets = pull_of_planets(p);
    for (std::size_t d = 0; d < 3; ++d) {
      kick_[p][d] = w.pull[p] * (q[d] * by_orbit - w.first_part[p] * by_first * x[d]) + planets[d];
      planets_force_[p][d] = w.mass[p] * planets[d];
      first_force_[p][d] = -w.first_pull * w.mass[p] * by_first * x[d];
    }
  }
  for (std::size_t p = 0; p < place_.size(); ++p) {
    w.outer.add(first_force_, kick_[p], p);
    w.inner.add(planets_force_, kick_[p], p);
    for (Pack& component : kick_[p]) component = w.pull[p] > 0 ? component : Pack{};
  }
  has_kicks_ = true;
}

PackVector WisdomHolman::pull_of_planets(std::size_t pack) const {
  PackVector sum{};
  for (std::size_t j = 1; j < weights_->count; ++j) {
    PackVector apart;
    for (std::size_t d = 0; d < 3; ++d) apart[d] = number(from_first_, j, d) - from_first_[pack][d];
    const Pack distance = square(apart);
    const Pack factor = distance > 0 ? weights_->planet_pull[j] * inverse_cube(distance) : Pack{};
    for (std::size_t d = 0; d < 3; ++d) sum[d] += factor * apart[d];
  }
  return sum;
}

void WisdomHolman::kick(double time) {
  for (std::size_t p = 0; p < place_.size(); ++p)
    for (std::size_t d = 0; d < 3; ++d) velocity_[p][d] += time * kick_[p][d];
}

void WisdomHolman::drift(double time) {
  for (std::size_t p = 0; p < place_.size(); ++p)
    move_on_orbits(weights_->pull[p], time, place_[p], velocity_[p]);
  for (std::size_t d = 0; d < 3; ++d) centre_place_[d] += time * centre_velocity_[d];
}

std::vector<double> WisdomHolman::memory() const {
  std::vector<double> memory;
  if (place_.empty()) return memory;
  memory.insert(memory.end(), left_place_.begin(), left_place_.end());
  memory.insert(memory.end(), left_velocity_.begin(), left_velocity_.end());
  memory.insert(memory.end(), centre_place_.begin(), centre_place_.end());
  memory.insert(memory.end(), centre_velocity_.begin(), centre_velocity_.end());
  for (const Vectors* vectors : {&place_, &velocity_})
    for (std::size_t k = 1; k < left_place_.size() / 3; ++k)
      for (std::size_t d = 0; d < 3; ++d) memory.push_back(number(*vectors, k, d));
  return memory;
}

void WisdomHolman::recall(std::span<const double> memory) {
  weights_.reset();
  has_kicks_ = false;
  const std::size_t count = memory.size() / 12;
  const double* from = memory.data();
  const auto take = [&](auto& to, std::size_t size) {
    to.resize(size);
    std::copy_n(from, size, to.begin());
    from += size;
  };
  take(left_place_, 3 * count);
  take(left_velocity_, 3 * count);
  if (memory.empty()) {
    place_.clear();
    velocity_.clear();
    return;
  }
  idle(place_, velocity_, count);
  for (auto* centre : {&centre_place_, &centre_velocity_})
    for (double& component : *centre) component = *from++;
  for (Vectors* vectors : {&place_, &velocity_})
    for (std::size_t k = 1; k < count; ++k)
      for (std::size_t d = 0; d < 3; ++d) (*vectors)[k / pack_size][d][k % pack_size] = *from++;
  for (auto* column : {&kick_, &from_first_, &planets_force_, &first_force_})
    column->assign(place_.size(), {});
}

}  // namespace mote
