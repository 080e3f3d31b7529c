#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mote/particles/vector.hpp"

namespace mote {

enum class FieldKind { scalar, vector };

/// One named quantity of every particle, particle by particle; a vector has as many components as
/// space has dimensions.
struct Field {
  std::string name;
  FieldKind kind;
  int components;
  std::string si_unit;  ///< what to write on an axis when the scenario says `units: SI`
  std::vector<double> values;
};

/// Puts what was at place order[k], so many numbers a place, at place k; places that `order` does
/// not name are gone.
void rearrange(std::vector<double>& values, std::size_t components, std::span<const Index> order,
               std::vector<double>& work);

/// The particles: named fields, position first. All that a step needs is in here, which is what
/// makes a restart exact. Spans into it stay valid while fields are added and when it is moved.
class Cloud {
 public:
  /// `dimension` is 1, 2 or 3. The cloud starts with the field `position`.
  Cloud(int dimension, Index count);

  int dimension() const { return dimension_; }
  Index count() const { return count_; }
  const std::vector<Field>& fields() const { return fields_; }

  /// Adds a field of zeros. The name must be new.
  std::span<double> add(std::string name, FieldKind kind, std::string si_unit);

  /// Puts the particle order[k] at place k and keeps only those that `order` names; the others are
  /// gone. `order` names no particle twice. Spans into the fields stay valid but for their length.
  void rearrange(std::span<const Index> order);

  /// Makes it so many particles: the last ones go, or some with zeros come. Spans into the fields
  /// are no longer valid.
  void resize(Index count);

  bool has(std::string_view name) const;
  /// The values of a field that exists; std::out_of_range otherwise.
  std::span<double> values(std::string_view name);
  std::span<const double> values(std::string_view name) const;
  std::span<double> position() { return fields_.front().values; }
  std::span<const double> position() const { return fields_.front().values; }

 private:
  const Field& field(std::string_view name) const;

  int dimension_;
  Index count_;
  std::vector<Field> fields_;
  std::vector<double> rearranged_;  ///< work for `rearrange`
};

}  // namespace mote
