#include "mote/geometry/filling.hpp"

#include <fmt/format.h>

#include "mote/geometry/space_lattice.hpp"
#include "mote/geometry/wall_places.hpp"
#include "mote/particles/failure.hpp"
#include "mote/particles/random.hpp"

namespace mote {
namespace {

/// Puts particles into cells.
class Filler {
 public:
  explicit Filler(const SpacePlan& plan)
      : plan_(plan),
        lattice_(plan),
        in_regions_(plan.regions.size()),
        in_side_walls_(plan.walls.size()) {
    for (const Region& region : plan.regions) ranges_.push_back(lattice_.range_of(region));
  }

  double most_particles() const {
    double count = plan_.walls.empty() ? 0 : lattice_.around().cells() - lattice_.inside().cells();
    for (const CellRange& range : ranges_) count += range.cells();
    return count;
  }

  Filling filling() {
    hand_out_cells();
    refuse_empty_regions();
    Filling filling;
    for (std::size_t k = 0; k < plan_.regions.size(); ++k)
      if (is_fluid(k)) add(filling, plan_.regions[k].body, in_regions_[k]);
    move_at_random(filling.position);
    for (std::size_t k = 0; k < plan_.walls.size(); ++k) {
      add(filling, plan_.walls[k].body, in_side_walls_[k]);
      for (const Cell& cell : in_side_walls_[k])
        filling.wall_places.push_back(place_beyond_sides(plan_, lattice_.place(cell)));
    }
    for (std::size_t k = 0; k < plan_.regions.size(); ++k)
      if (!is_fluid(k)) add_wall(filling, plan_.regions[k], in_regions_[k]);
    return filling;
  }

 private:
  using Cells = std::vector<Cell>;

  bool is_fluid(std::size_t region) const {
    return plan_.regions[region].body.kind == BodyKind::fluid;
  }

  void hand_out_cells() {
    CellRange all = plan_.walls.empty() ? lattice_.inside() : lattice_.around();
    for (const CellRange& range : ranges_) all = all.hull(range);
    Cell cell;
    for (cell[2] = all.first[2]; cell[2] < all.end[2]; ++cell[2])
      for (cell[1] = all.first[1]; cell[1] < all.end[1]; ++cell[1])
        for (cell[0] = all.first[0]; cell[0] < all.end[0]; ++cell[0]) hand_out(cell);
  }

  void hand_out(const Cell& cell) {
    const Triple place = lattice_.place(cell);
    const std::size_t none = plan_.regions.size();
    std::size_t owner = none;
    for (std::size_t k = 0; k < plan_.regions.size(); ++k) {
      const bool owns = ranges_[k].contains(cell) && plan_.regions[k].holds(place, rounding());
      if (owns && owner != none) refuse_overlap(plan_.regions[owner], plan_.regions[k], place);
      if (owns) owner = k;
    }
    if (owner == none) return give_to_side_wall(cell);
    if (is_fluid(owner) && !lattice_.inside().contains(cell)) refuse_beyond(owner, place);
    in_regions_[owner].push_back(cell);
  }

  void give_to_side_wall(const Cell& cell) {
    if (!lattice_.around().contains(cell)) return;
    for (std::size_t k = 0; k < plan_.walls.size(); ++k) {
      const auto [axis, upper] = plan_.walls[k].side;
      const bool beyond = upper ? cell[axis] >= lattice_.inside().end[axis] : cell[axis] < 0;
      if (beyond) return in_side_walls_[k].push_back(cell);
    }
  }

  double rounding() const { return 1e-9 * plan_.spacing; }

  std::string in_words(const Region& region) const {
    const bool fluid = region.body.kind == BodyKind::fluid;
    return fmt::format("the {} '{}'", fluid ? "fluid" : "wall", region.body.name);
  }

  [[noreturn]] void refuse_overlap(const Region& first, const Region& second,
                                   const Triple& place) const {
    throw InputError(second.key,
                     fmt::format("{} and {} lie on top of each other at {}", in_words(first),
                                 in_words(second), place_in_words(place, plan_.dimension)));
  }

  [[noreturn]] void refuse_beyond(std::size_t region, const Triple& place) const {
    throw InputError(
        plan_.regions[region].key,
        fmt::format("{} goes beyond the domain, to {}", in_words(plan_.regions[region]),
                    place_in_words(place, plan_.dimension)));
  }

  void refuse_empty_regions() const {
    for (std::size_t k = 0; k < plan_.regions.size(); ++k)
      if (in_regions_[k].empty())
        throw InputError(plan_.regions[k].key,
                         fmt::format("{} has no particle in it", in_words(plan_.regions[k])));
  }

  void add(Filling& filling, const Body& body, const Cells& cells) const {
    const auto number = static_cast<std::int32_t>(filling.bodies.size());
    filling.bodies.push_back(body);
    for (const Cell& cell : cells) {
      const Triple place = lattice_.place(cell);
      filling.position.insert(filling.position.end(), place.begin(),
                              place.begin() + plan_.dimension);
      filling.body.push_back(number);
    }
  }

  void add_wall(Filling& filling, const Region& region, const Cells& cells) const {
    add(filling, region.body, cells);
    double deepest = 0;
    for (const Cell& cell : cells) {
      filling.wall_places.push_back(place_in_wall(plan_, region, lattice_.place(cell)));
      deepest = std::max(deepest, filling.wall_places.back().depth);
    }
    const double thickness = deepest / plan_.spacing + 0.5;
    if (thickness < plan_.reach * (1 - 1e-9))
      throw InputError(region.key,
                       fmt::format("{} is {:.3g} spacings deep, and the operator reaches {:.3g}: "
                                   "the fluid would see through it",
                                   in_words(region), thickness, plan_.reach));
  }

  /// Component d of the move of particle i is the draw i D + d of the seed.
  void move_at_random(std::vector<double>& position) const {
    for (std::size_t k = 0; plan_.jitter > 0 && k < position.size(); ++k)
      position[k] += plan_.jitter * plan_.spacing * (2 * uniform_random(plan_.seed, k) - 1);
  }

  const SpacePlan& plan_;
  SpaceLattice lattice_;
  std::vector<CellRange> ranges_;  ///< of the regions
  std::vector<Cells> in_regions_, in_side_walls_;
};

}  // namespace

Filling filled(const SpacePlan& plan) { return Filler(plan).filling(); }

double most_particles(const SpacePlan& plan) { return Filler(plan).most_particles(); }

}  // namespace mote
