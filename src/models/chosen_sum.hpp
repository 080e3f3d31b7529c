#pragma once

#include <string>

#include "mote/options/description.hpp"
#include "mote/sums/sum_settings.hpp"

namespace mote {

/// Words for the ways in which a model may sum over all pairs of its `points`.
Choices sum_choices(const std::string& points);

/// Words for the cores of points: "point", described as `none`, and those of the list VortexCores.
Choices core_choices(const std::string& none);

/// How a scenario wants sums over all pairs to be formed.
struct SumChoice {
  std::string method = "automatic";  ///< or direct, or multipole
  double tolerance = 1e-8;           ///< of multipole
  std::string core = "point";
};

/// Sums over all pairs of one kind, made from SumSettings and a core, either way: as the scenario
/// wants it, or pair by pair for up to `few` points, for which that is about as fast, and exact.
template <class Sum>
class ChosenSum {
 public:
  ChosenSum(const SumChoice& choice, std::size_t few)
      : method_(choice.method),
        few_(few),
        direct_({SumMethod::direct, choice.tolerance}, choice.core),
        multipole_({SumMethod::multipole, choice.tolerance}, choice.core) {}

  bool is_direct(std::size_t points) const {
    return method_ == "direct" || (method_ == "automatic" && points <= few_);
  }
  Sum& of(std::size_t points) { return is_direct(points) ? direct_ : multipole_; }

 private:
  std::string method_;
  std::size_t few_;
  Sum direct_, multipole_;
};

}  // namespace mote
