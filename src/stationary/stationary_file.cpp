#include "mote/stationary/stationary_file.hpp"

#include <fmt/format.h>

#include <cmath>

#include "mote/scenario/folder_name.hpp"
#include "mote/scenario/located_error.hpp"
#include "mote/scenario/reader.hpp"
#include "mote/scenario/schema.hpp"
#include "mote/scenario/writer.hpp"

namespace mote {
namespace {

const Choices potentials{{"infinite_well", "0 between walls at the ends"},
                         {"harmonic_oscillator", "x^2, with tails beyond the ends"},
                         {"coulomb", "-2/r on the half line from 0, with a tail beyond the end"},
                         {"formula", "in x, between walls, or with tails if there is a decay"}};

void describe_model(Description& d, StationaryFile& file) {
  d.variant({"potential", "V, in units with hbar^2/2m = 1", true}, file.potential, potentials,
            [&](const std::string& potential) {
              if (potential == "formula")
                d.expression({"formula", "V as a formula in x", true}, file.formula, "x");
              if (potential != "infinite_well")
                d.number({"decay",
                          "k of the tails e^(-kx) beyond the ends; default: x of the end for "
                          "harmonic_oscillator, 1/r of the end for coulomb, none for formula"},
                         file.decay, positive);
            });
  d.count({"states", "how many are wanted, the lowest first"}, file.states, {1, 2000});
}

void describe_check(Description& d, StationaryFile& file) {
  const Choices known{{"exact", "the exact energies, of potentials that have them"},
                      {"nothing", "no exact energies"}};
  d.variant({"against", "what energies are compared with"}, file.against, known,
            [&](const std::string& against) {
              if (against != "nothing")
                d.numbers({"energies", "largest relative errors of the lowest energies, in order"},
                          file.energy_limits);
            });
}

/// Rules that no single key can state.
class Checker {
 public:
  Checker(const StationaryFile& file, const Document& document)
      : file_(file), document_(document) {}

  void check() const {
    const std::string problem = folder_name_problem(file_.name);
    require(problem.empty(), "name", problem);
    check_domain();
    check_states();
  }

 private:
  void require(bool condition, const std::string& key, const std::string& message) const {
    if (!condition) throw LocatedError(document_.locate(key), message);
  }

  void check_domain() const {
    require(file_.lower.size() == 1, "domain.lower", "'lower' needs 1 number");
    require(file_.upper.size() == 1, "domain.upper", "'upper' needs 1 number");
    const double lower = file_.lower[0], upper = file_.upper[0];
    require(upper > lower && std::isfinite(upper - lower), "domain.upper",
            fmt::format("the upper end {} must lie above the lower {}", upper, lower));
    require(file_.potential != "coulomb" || lower == 0, "domain.lower",
            "the coulomb potential has its centre at 0, where the domain must start");
    require(file_.potential != "harmonic_oscillator" || file_.decay || lower * upper < 0,
            "domain.lower", "without a decay, the domain of an oscillator must have 0 within");
  }

  void check_states() const {
    const std::int64_t unknowns = 2 * (file_.nodes - 1);
    require(
        file_.states <= unknowns, "model.states",
        fmt::format("{} nodes have {} states, and not {}", file_.nodes, unknowns, file_.states));
    require(file_.energy_limits.empty() || file_.potential != "formula", "check.energies",
            "the exact energies of a formula are not known");
    require(static_cast<std::int64_t>(file_.energy_limits.size()) <= file_.states, "check.energies",
            "there are more limits than states");
    for (const double limit : file_.energy_limits)
      require(limit > 0, "check.energies", "limits are positive");
  }

  const StationaryFile& file_;
  const Document& document_;
};

}  // namespace

void describe(Description& d, StationaryFile& file) {
  d.text({"name", "names the output folder and the report", true}, file.name);
  d.count({"dimension", "number of space dimensions"}, file.dimension, {1, 1});
  d.constants({"constants", "numbers that all expressions may name"}, file.constants);
  d.section({"domain", "where the nodes are", true}, [&] {
    d.numbers({"lower", "lower end, one number", true}, file.lower);
    d.numbers({"upper", "upper end, one number", true}, file.upper);
  });
  d.section({"particles", "the nodes", true}, [&] {
    d.count({"count", "number of nodes, the ends among them", true}, file.nodes, {2, 1001});
  });
  d.section({"model", "the equation", true}, [&] {
    d.variant({"type", "model without time", true}, file.type, stationary_models,
              [&](const std::string&) { describe_model(d, file); });
  });
  d.section({"check", "what the results must hold"}, [&] { describe_check(d, file); });
  d.section({"output", "what is written"}, [&] {
    d.flag({"picture", "whether to draw a picture at the end"}, file.picture);
  });
}

bool is_stationary(const Document& document) {
  const Value* model = document.find({"model"});
  const Value* type = document.find({"model", "type"});
  for (const Choice& choice : stationary_models)
    if ((model != nullptr && model->word == choice.name) ||
        (type != nullptr && type->word == choice.name))
      return true;
  return false;
}

StationaryFile read_stationary(const Document& document) {
  StationaryFile file;
  Reader reader(document);
  describe(reader, file);
  reader.finish();
  Checker(file, document).check();
  return file;
}

std::string resolved_yaml(StationaryFile& file) {
  return yaml_of([&](Description& d) { describe(d, file); });
}

std::string stationary_schema() {
  return schema_of("mote model without time", [](Description& description) {
    StationaryFile file;
    describe(description, file);
  });
}

}  // namespace mote
