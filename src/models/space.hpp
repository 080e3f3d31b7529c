#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mote/operators/differential/differential_operator.hpp"
#include "mote/operators/terms/any_fluid_terms.hpp"
#include "mote/particles/body.hpp"

namespace mote {

/// Value at a place and time.
using PlaceFunction = std::function<double(const Triple& place, double time)>;

/// A domain in two or three dimensions, and the particles that fill it.
struct SpaceStart {
  int dimension = 2;
  Triple lower{}, upper{};         ///< corners of the domain; fluid beyond them has left it
  std::array<bool, 3> periodic{};  ///< whether what leaves on one side comes in on the other
  double spacing = 1;  ///< between particles; each has the volume spacing^dimension; 0: not given
  std::vector<Body> bodies;
  std::vector<double> position;    ///< `dimension` numbers a particle: all fluids, then all walls
  std::vector<std::int32_t> body;  ///< of every particle: its number among `bodies`
  std::vector<WallPlace> wall_places;  ///< of every wall particle, in order

  /// Value of an initial field, by name, at a place.
  std::function<double(std::string_view field, const Triple& place)> initial;

  /// A formula of the scenario as a function; each thread needs its own.
  std::function<PlaceFunction(const std::string& formula)> compile;
};

/// What a model in space is made from.
struct SpaceSetup : SpaceStart {
  std::unique_ptr<AnyOperator> differential_operator;  ///< null if the model needs none
  std::unique_ptr<AnyFluidTerms> terms;  ///< pair terms on the scenario's kernel; null without one
  double smoothing_length = 1;           ///< of those terms, in spacings
  std::string search;                    ///< name of the neighbour search; empty: the model chooses
  std::optional<double> skin;  ///< how much further than the operator lists reach, relative
};

}  // namespace mote
