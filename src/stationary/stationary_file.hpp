#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mote/options/description.hpp"
#include "mote/quantum/exact_states.hpp"
#include "mote/quantum/stationary_states.hpp"
#include "mote/scenario/document.hpp"

namespace mote {

/// The models without time.
inline const Choices stationary_models{
    {"schroedinger", "stationary states of -psi'' + V psi = E psi by first-order ContEvol"}};

/// One YAML file of a model without time, checked, with every default filled in.
struct StationaryFile {
  std::string name;
  std::int64_t dimension = 1;
  std::vector<std::pair<std::string, double>> constants;
  std::vector<double> lower, upper;  ///< ends of the domain, one number each
  std::int64_t nodes = 0;

  std::string type, potential;
  std::string formula;          ///< of a potential that is given as one
  std::int64_t states = 4;      ///< how many are wanted, the lowest first
  std::optional<double> decay;  ///< of the wave functions beyond the ends

  std::string against = "exact";      ///< with which energies those found are compared
  std::vector<double> energy_limits;  ///< largest relative errors of the lowest energies
  bool picture = true;
};

/// Says what such a file holds.
void describe(Description& description, StationaryFile& file);

/// Whether a document is of a model without time.
bool is_stationary(const Document& document);

/// Reads and checks a document. Throws LocatedError.
StationaryFile read_stationary(const Document& document);

/// The file as YAML with every default. Reading the result gives the same file.
std::string resolved_yaml(StationaryFile& file);

/// The JSON Schema (2020-12) of such a file.
std::string stationary_schema();

/// The equation that a file states; its potential throws InputError where it has no value.
SchroedingerProblem problem_of(const StationaryFile& file);

/// How far tails are shown: until they are as good as 0, e^-5 of their start; 0 where there is
/// none.
double tail_length(const std::optional<double>& decay);

/// The potential far away, where tails have ended: states of higher energy are not bound. None
/// between walls.
std::optional<double> binding_limit(const StationaryFile& file, const SchroedingerProblem& problem);

/// The exact states, for potentials that have them, if the file wants them.
std::optional<ExactStates> exact_states_of(const StationaryFile& file);

}  // namespace mote
