#include "mote/scenario/probes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mote/options/column_name.hpp"
#include "mote/scenario/located_error.hpp"

namespace mote {
namespace {

const Choices types{{"point", "fields at a place"},
                    {"line", "least and largest values of fields along a line"},
                    {"force", "force of the fluid on a wall"},
                    {"gauge", "height of the free surface above a place"},
                    {"front", "how far the fluid reaches"},
                    {"speed", "largest and root mean square speed of the fluid"}};

const Choices fields{{"velocity", "all its components"}, {"velocity_x", "one of them"},
                     {"velocity_y", "one of them"},      {"velocity_z", "one of them"},
                     {"pressure", "of the fluid"},       {"density", "of the fluid"}};

const Choices ways{{"x", "to higher x"}, {"-x", "to lower x"}, {"y", "to higher y"},
                   {"-y", "to lower y"}, {"z", "to higher z"}, {"-z", "to lower z"}};

void describe_rest(Description& d, Probe& probe, const std::string& type) {
  if (type == "point") d.numbers({"at", "place, one number a dimension", true}, probe.at);
  if (type == "line") {
    d.numbers({"from", "one end, one number a dimension", true}, probe.from);
    d.numbers({"to", "the other end", true}, probe.to);
    d.count({"points", "on the line, both ends among them"}, probe.points, {2, 1e5});
    d.flag({"all", "whether every point has columns of its own too"}, probe.all);
  }
  if (type == "point" || type == "line")
    d.words({"fields", "what is measured there", true}, probe.fields, fields);
  if (type == "force") d.text({"wall", "name of the wall", true}, probe.wall);
  if (type == "gauge")
    d.numbers({"at", "place, one number for every axis but the last", true}, probe.at);
  if (type == "front") d.choice({"along", "the way in which it runs"}, probe.along, ways);
}

/// Places of probes against the domain that they must be in.
class PlaceChecks {
 public:
  PlaceChecks(const ProbeDomain& domain, const Document& document)
      : domain_(domain), document_(document) {}

  /// The first `count` coordinates of a place; `key` is where it was written.
  void check(const std::string& key, const std::vector<double>& place, std::size_t count) const {
    if (place.size() != count)
      refuse(key, fmt::format("this place needs {} number{}, and has {}", count,
                              count == 1 ? "" : "s", place.size()));
    for (std::size_t d = 0; d < count; ++d)
      if (!(place[d] >= domain_.lower[d] && place[d] <= domain_.upper[d]))
        refuse(key, fmt::format("the place ({:.6g}) lies outside of the domain, whose corners are "
                                "({:.6g}) and ({:.6g})",
                                fmt::join(place, ", "), fmt::join(domain_.lower, ", "),
                                fmt::join(domain_.upper, ", ")));
  }

  [[noreturn]] void refuse(const std::string& key, const std::string& message) const {
    throw LocatedError(document_.locate(key), message);
  }

 private:
  const ProbeDomain& domain_;
  const Document& document_;
};

}  // namespace

void describe_probes(Description& d, std::vector<Probe>& probes) {
  describe_list(d, {"probes", "what is measured for every row of history.csv"}, probes,
                [&](Probe& probe) {
                  d.text({"name", "with which its columns begin", true}, probe.name);
                  d.variant({"type", "what is measured", true}, probe.type, types,
                            [&](const std::string& type) { describe_rest(d, probe, type); });
                });
}

void check_probes(const std::vector<Probe>& probes, const ProbeDomain& domain,
                  const Document& document) {
  const PlaceChecks places(domain, document);
  for (std::size_t k = 0; k < probes.size(); ++k) {
    const Probe& probe = probes[k];
    const std::string section = fmt::format("probes.{}.", k);
    if (!is_column_name(probe.name))
      places.refuse(section + "name", fmt::format("'{}' cannot name a probe: a name is letters, "
                                                  "digits and _",
                                                  probe.name));
    if (probe.type == "point") places.check(section + "at", probe.at, domain.dimension);
    if (probe.type == "gauge") places.check(section + "at", probe.at, domain.dimension - 1);
    if (probe.type == "line") {
      places.check(section + "from", probe.from, domain.dimension);
      places.check(section + "to", probe.to, domain.dimension);
    }
    const auto axis = static_cast<std::size_t>(probe.along.back() - 'x');
    if (probe.type == "front" && axis >= domain.dimension)
      places.refuse(section + "along", fmt::format("there is no axis {} in {} dimensions",
                                                   probe.along.back(), domain.dimension));
  }
}

}  // namespace mote
