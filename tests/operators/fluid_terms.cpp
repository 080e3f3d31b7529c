#include "mote/operators/terms/fluid_terms.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "kernel_cases.hpp"
#include "mote/operators/terms/fluid_terms_by_kernel.hpp"
#include "plain_fluid_terms.hpp"

namespace mote::test {
namespace {

constexpr double rounding = 1e-13;

template <class List>
struct SpaceCasesOf;
template <template <int> class... K>
struct SpaceCasesOf<KernelList<K...>> {
  using type = testing::Types<KernelCase<K, 2>..., KernelCase<K, 3>...>;
};

template <class Case>
struct FluidTermsInSpace : testing::Test {
  static constexpr int D = Case::dimension;
  using Kernel = typename Case::Kernel;
  using Line = PairLine<D>;

  Kernel kernel;
  std::unique_ptr<FluidTerms<D>> terms = fluid_terms_by<D>(kernel);
  FluidInABox<D> fluid = fluid_in_a_box<D>(kernel.support());
  std::vector<PairRole> roles = std::vector<PairRole>(fluid.lines.size());
  std::vector<Vec<D>> carrying;
  PlainLists everybody = all_of_all(fluid.count());

  static FluidCoefficients<D> nothing() {
    FluidCoefficients<D> c;
    c.mass = 0.6;
    c.continuity = c.pressure = false;
    return c;
  }

  /// Every term alone, and all of them.
  static std::vector<FluidCoefficients<D>> combinations() {
    std::vector<FluidCoefficients<D>> all(7, nothing());
    all[1].continuity = all[6].continuity = true;
    all[2].pressure = all[6].pressure = true;
    all[3].diffusion = all[6].diffusion = 0.3;
    all[6].density_at_rest = Vec<D>::LinSpaced(0.2, -0.7);
    all[4].artificial_viscosity = all[6].artificial_viscosity = 0.8;
    all[5].viscosity = all[6].viscosity = 0.5;
    return all;
  }

  struct Rates {
    std::vector<double> acceleration, density_rate;
    FluidPass pass;
  };

  Rates rates(const PlainLists& lists, FluidCoefficients<D> c) const {
    std::vector<PairSums> sums(fluid.lines.size());
    const NeighbourLists neighbours(lists);
    PairOrder order;
    order.arrange(neighbours);
    c.smoothing_length = fluid.smoothing_length;
    Rates rates{.pass = terms->add_up({fluid.lines, roles, carrying}, neighbours, order, c, sums)};
    for (std::size_t i = 0; i < lists.size(); ++i) {
      for (std::size_t d = 0; d < D; ++d) rates.acceleration.push_back(sums[i].value[d]);
      rates.density_rate.push_back(fluid.mass / fluid.lines[i].value[Line::volume] *
                                   sums[i].value[PairSums::rate]);
    }
    return rates;
  }

  /// How far the terms are from the plain sums over `against`, in magnitudes of those.
  double distance(const PlainLists& lists, const PlainLists& against,
                  const FluidCoefficients<D>& c) const {
    return distance(rates(lists, c), against, c);
  }

  double distance(const Rates& found, const PlainLists& against,
                  const FluidCoefficients<D>& c) const {
    double worst = 0;
    const auto compare = [&](double value, const PlainSum& sum) {
      const double apart = std::abs(value - sum.value);
      if (apart > 0) worst = std::max(worst, apart / sum.magnitude);
    };
    PlainSum lost;
    std::int64_t pairs = 0;
    for (std::size_t i = 0; i < against.size(); ++i) {
      const PlainRates<D> plain = plain_rates(fluid, kernel, i, against[i], c);
      for (std::size_t d = 0; d < D; ++d)
        compare(found.acceleration[i * D + d], plain.acceleration[d]);
      compare(found.density_rate[i], plain.density_rate);
      lost.value += plain.dissipation.value;
      lost.magnitude += plain.dissipation.magnitude;
      pairs += plain.pairs;
    }
    compare(found.pass.dissipation, lost);
    EXPECT_EQ(found.pass.pairs, pairs);
    return worst;
  }
};
TYPED_TEST_SUITE(FluidTermsInSpace, SpaceCasesOf<OperatorKernels>::type, KernelCaseName);

TYPED_TEST(FluidTermsInSpace, AreTheirFormulaTermByTerm) {
  for (const auto& c : this->combinations())
    EXPECT_LE(this->distance(this->everybody, this->everybody, c), rounding);
}

TYPED_TEST(FluidTermsInSpace, AreTheSameForListsThatReachBeyondTheSupport) {
  const double support = this->kernel.support();
  for (const auto& c : this->combinations())
    for (const double reach : {1.0, 1.1})
      EXPECT_LE(this->distance(within(this->fluid, reach * support), this->everybody, c), rounding);
}

TYPED_TEST(FluidTermsInSpace, TakeListsOfAnyLength) {
  for (const std::size_t length : {0, 1, 7, 8, 9, 17}) {
    PlainLists lists(this->everybody.size()), both_ways(lists.size());
    for (std::size_t i = 0; i < lists.size(); ++i)
      for (std::size_t j = i + 1; j < lists.size() && lists[i].size() < length; ++j) {
        lists[i].push_back(static_cast<Index>(j));
        both_ways[i].push_back(static_cast<Index>(j));
        both_ways[j].push_back(static_cast<Index>(i));
      }
    for (const auto& c : this->combinations())
      EXPECT_LE(this->distance(lists, both_ways, c), rounding) << length;
  }
}

/// Points behind the receivers are met from one end only.
TYPED_TEST(FluidTermsInSpace, TakePointsThatAreNoReceivers) {
  PlainLists lists = this->everybody;
  lists.resize(41);
  for (const auto& c : this->combinations()) EXPECT_LE(this->distance(lists, lists, c), rounding);
}

TYPED_TEST(FluidTermsInSpace, AreTheSumsOfOnePoint) {
  constexpr int D = TestFixture::D;
  for (auto c : this->combinations()) {
    const auto all = this->rates(this->everybody, c);
    c.smoothing_length = this->fluid.smoothing_length;
    const std::size_t i = 3;
    const PairSums found =
        this->terms->sums_of({this->fluid.lines, this->roles}, i, this->everybody[i], c);
    for (std::size_t d = 0; d < D; ++d)
      EXPECT_NEAR(found.value[d], all.acceleration[i * D + d], 1e-11);
    // Negative control: another point's are others.
    if (c.pressure) {
      EXPECT_GT(std::abs(found.value[0] - all.acceleration[(i + 1) * D]), 1e-3);
    }
  }
}

/// Of every list the later neighbours are all that counts.
TYPED_TEST(FluidTermsInSpace, AreTheSameBitsForListsOfLaterNeighbours) {
  PlainLists later = this->everybody;
  for (std::size_t i = 0; i < later.size(); ++i)
    std::erase_if(later[i], [&](Index j) { return j < static_cast<Index>(i); });
  for (const auto& c : this->combinations()) {
    const auto all = this->rates(this->everybody, c), found = this->rates(later, c);
    EXPECT_EQ(found.acceleration, all.acceleration);
    EXPECT_EQ(found.density_rate, all.density_rate);
    EXPECT_EQ(found.pass.pairs, all.pass.pairs);
  }
  // Negative control: earlier ones do not count.
  for (auto& list : later) list.clear();
  EXPECT_NE(this->rates(later, this->combinations()[6]).acceleration,
            this->rates(this->everybody, this->combinations()[6]).acceleration);
}

/// A ghost's friction counts half, on whichever end it is, and what moves does not ask who it is.
TYPED_TEST(FluidTermsInSpace, CountHalfOfTheFrictionWithGhosts) {
  const auto c = this->combinations()[6];
  const std::size_t ghost = 5;
  const auto plain = this->rates(this->everybody, c);
  PlainLists without = this->everybody;
  for (auto& list : without) std::erase(list, static_cast<Index>(ghost));
  without[ghost].clear();
  const double others = this->rates(without, c).pass.dissipation;
  std::ranges::fill(this->roles, PairRole::beside_ghosts);
  this->roles[ghost] = PairRole::ghost;
  const auto found = this->rates(this->everybody, c);
  EXPECT_NEAR(found.pass.dissipation, (plain.pass.dissipation + others) / 2,
              1e-12 * plain.pass.dissipation);
  EXPECT_GT(plain.pass.dissipation, 1.001 * others);
  EXPECT_EQ(found.acceleration, plain.acceleration);
  EXPECT_EQ(found.density_rate, plain.density_rate);
}

/// The density follows from the velocities at which mass moves, all else from those of the lines.
TYPED_TEST(FluidTermsInSpace, LetTheMassOfGhostsMoveOtherwise) {
  constexpr int D = TestFixture::D;
  const auto c = this->combinations()[6];
  const std::size_t ghost = 5;
  const auto plain = this->rates(this->everybody, c);
  std::ranges::fill(this->roles, PairRole::beside_ghosts);
  this->roles[ghost] = PairRole::ghost;
  const Vec<D> velocity = Vec<D>::LinSpaced(3, -1);
  this->carrying.assign(this->fluid.lines.size(), Vec<D>::Constant(7));
  this->carrying[ghost] = velocity;
  const auto found = this->rates(this->everybody, c);
  EXPECT_EQ(found.acceleration, plain.acceleration);
  Vec<D>::Map(this->fluid.lines[ghost].value.data() + PairLine<D>::velocity) = velocity;
  this->carrying.clear();
  const auto as_moved = this->rates(this->everybody, c);
  for (std::size_t i = 0; i < found.density_rate.size(); ++i)
    EXPECT_NEAR(found.density_rate[i], as_moved.density_rate[i],
                1e-13 * std::abs(as_moved.density_rate[ghost]));
  // Negative controls: the ghost's velocity matters, to the density and to the forces.
  EXPECT_GT(std::abs(as_moved.density_rate[ghost] - plain.density_rate[ghost]),
            1e-3 * std::abs(as_moved.density_rate[ghost]));
  EXPECT_NE(as_moved.acceleration, plain.acceleration);
}

/// What one end of a pair gains the other loses, so nothing is left of all forces together.
TYPED_TEST(FluidTermsInSpace, KeepMomentum) {
  constexpr int D = TestFixture::D;
  for (const auto& c : this->combinations()) {
    const auto found = this->rates(this->everybody, c);
    PlainSum total[D];
    for (std::size_t k = 0; k < found.acceleration.size(); ++k)
      total[k % D] += found.acceleration[k];
    for (const PlainSum& sum : total) EXPECT_LE(std::abs(sum.value), 1e-15 * sum.magnitude);
    // Negative control: without the first particle the forces on it are missing.
    if (c.pressure) {
      EXPECT_GT(std::abs(found.acceleration[0]), 1e-9 * total[0].magnitude);
    }
  }
}

TYPED_TEST(FluidTermsInSpace, CountPairsWithinTheSupportOnly) {
  const PlainLists near = within(this->fluid, this->kernel.support());
  const auto pairs = std::accumulate(near.begin(), near.end(), std::size_t{0},
                                     [](auto sum, const auto& list) { return sum + list.size(); });
  EXPECT_EQ(this->rates(this->everybody, this->nothing()).pass.pairs, pairs);
  EXPECT_LT(pairs, this->everybody.size() * (this->everybody.size() - 1));
}

/// Negative control: every coefficient that is a little wrong is noticed.
TYPED_TEST(FluidTermsInSpace, DifferFromFormulasThatAreALittleWrong) {
  const auto right = this->combinations()[6];
  const auto found = this->rates(this->everybody, right);
  EXPECT_LE(this->distance(found, this->everybody, right), rounding);
  std::vector wrong(6, right);
  wrong[0].continuity = false;
  wrong[1].pressure = false;
  wrong[2].diffusion *= 1 + 1e-9;
  wrong[3].artificial_viscosity *= 1 + 1e-9;
  wrong[4].viscosity *= 1 + 1e-9;
  wrong[5].density_at_rest *= 1 + 1e-9;
  for (const auto& c : wrong) EXPECT_GT(this->distance(found, this->everybody, c), 10 * rounding);
}

void expect_sum(double value, const PlainSum& sum, double factor = 1) {
  EXPECT_NEAR(value, factor * sum.value, rounding * std::abs(factor) * sum.magnitude);
}

/// The lists that the sums over one particle's neighbours are tried with.
std::vector<std::vector<Index>> lists_of_first(const PlainLists& everybody) {
  std::vector<std::vector<Index>> lists{everybody.front()};
  for (const std::size_t length : {0, 1, 7, 8, 9, 17})
    lists.emplace_back(everybody.front().begin(),
                       everybody.front().begin() + static_cast<std::ptrdiff_t>(length));
  return lists;
}

TYPED_TEST(FluidTermsInSpace, SumUpTheDensity) {
  const auto& fluid = this->fluid;
  for (const auto& list : lists_of_first(this->everybody)) {
    PlainSum sum;
    sum += this->kernel.value(0.0) / std::pow(fluid.smoothing_length, TestFixture::D);
    for (const Index j : list)
      sum += PlainPair<TestFixture::D>(fluid, this->kernel, 0, static_cast<std::size_t>(j)).w;
    // The receiver stands in for up to seven missing lanes, and is taken off again.
    sum.magnitude += 7 * this->kernel.value(0.0);
    expect_sum(this->terms->density(fluid.lines, 0, list, fluid.smoothing_length, fluid.mass), sum,
               fluid.mass);
  }
}

TYPED_TEST(FluidTermsInSpace, AreSeenFromAWall) {
  constexpr int D = TestFixture::D;
  const auto& fluid = this->fluid;
  const Surface<D> surface{0.2, 0.1, Vec<D>::Unit(1), Vec<D>::LinSpaced(0.3, -0.4)};
  for (const auto& list : lists_of_first(this->everybody)) {
    PlainSum weight, pressure, offset[D], velocity[D], slope[D], width;
    for (const Index j : list) {
      const PlainPair<D> pair(fluid, this->kernel, 0, static_cast<std::size_t>(j));
      const Vec<D> speed = fluid.lines[static_cast<std::size_t>(j)].speed();
      const double vw = pair.volume * pair.w;
      const double height = std::max(surface.nearest, -pair.x.dot(surface.normal) - surface.depth);
      weight += vw;
      pressure += vw * pair.pressure_j;
      width += vw * height * height;
      for (int d = 0; d < D; ++d) {
        offset[d] += fluid.mass * pair.w * pair.x[d];
        velocity[d] += vw * speed[d];
        slope[d] += vw * height * (speed[d] - surface.velocity[d]);
      }
    }
    const FluidSeen<D> seen =
        this->terms->seen(fluid.lines, 0, list, fluid.smoothing_length, fluid.mass, surface);
    // The weight itself is left unscaled by the length of the kernel.
    const double unit = std::pow(fluid.smoothing_length, D);
    expect_sum(seen.weight, weight, unit);
    if (weight.value == 0) continue;
    expect_sum(seen.pressure, pressure, 1 / weight.value);
    for (int d = 0; d < D; ++d) {
      expect_sum(seen.offset[d], offset[d], 1 / weight.value);
      expect_sum(seen.velocity[d], velocity[d], 1 / weight.value);
      expect_sum(seen.shear[d], slope[d], width.value > 0 ? 1 / width.value : 0);
    }
  }
}

TYPED_TEST(FluidTermsInSpace, TellHowNeighboursSpread) {
  constexpr int D = TestFixture::D;
  const auto& fluid = this->fluid;
  const double h = fluid.smoothing_length, spacing = 0.4 * this->kernel.support() * h;
  const double at_spacing = this->kernel.value(spacing / h);
  for (const auto& list : lists_of_first(this->everybody)) {
    PlainSum moment[D][D], crowding[D], plain[D], velocity[D][D], density[D];
    for (const Index j : list) {
      const PlainPair<D> pair(fluid, this->kernel, 0, static_cast<std::size_t>(j));
      const double vf = pair.volume * pair.f;
      const double ratio = pair.w * std::pow(h, D) / at_spacing;
      for (int d = 0; d < D; ++d) {
        plain[d] += vf * pair.x[d];
        crowding[d] += vf * (1 + 0.2 * std::pow(ratio, 4)) * pair.x[d];
        density[d] += vf * pair.density_j * pair.x[d];
        density[d] += -vf * pair.density_i * pair.x[d];
        for (int e = 0; e < D; ++e) {
          moment[d][e] += -vf * pair.x[d] * pair.x[e];
          velocity[d][e] += -vf * pair.u[d] * pair.x[e];
        }
      }
    }
    const FluidSpread<D> spread =
        this->terms->spread(fluid.lines, 0, list, h, fluid.mass, {spacing});
    const FluidSpread<D> without =
        this->terms->spread(fluid.lines, 0, list, h, fluid.mass, {spacing, 0});
    for (int d = 0; d < D; ++d) {
      expect_sum(without.crowding[d], plain[d]);
      expect_sum(spread.crowding[d], crowding[d]);
      expect_sum(spread.density[d], density[d]);
      for (int e = 0; e < D; ++e) {
        expect_sum(spread.moment(d, e), moment[d][e]);
        expect_sum(spread.velocity(d, e), velocity[d][e]);
      }
    }
  }
}

TYPED_TEST(FluidTermsInSpace, AddUpTheLinearPartOfTheDiffusion) {
  constexpr int D = TestFixture::D;
  const auto& fluid = this->fluid;
  Draws draws(11);
  std::vector<Vec<D>> slopes(fluid.lines.size());
  for (Vec<D>& slope : slopes)
    for (int d = 0; d < D; ++d) slope[d] = draws.uniform(-1, 1);
  for (const auto& list : lists_of_first(this->everybody)) {
    PlainSum sum;
    for (const Index j : list) {
      const PlainPair<D> pair(fluid, this->kernel, 0, static_cast<std::size_t>(j));
      for (int d = 0; d < D; ++d) {
        sum += -pair.volume * slopes[0][d] * pair.x[d] * pair.f;
        sum += -pair.volume * slopes[static_cast<std::size_t>(j)][d] * pair.x[d] * pair.f;
      }
    }
    expect_sum(this->terms->linear_diffusion(fluid.lines, 0, list, fluid.smoothing_length, slopes),
               sum);
  }
}

}  // namespace
}  // namespace mote::test
