#pragma once

#include <memory>
#include <string>

#include "mote/catalogue/entries.hpp"
#include "mote/options/description.hpp"

namespace mote {

/// The differential operator that a file names: a family, its member (`gauss` of `sph.gauss`, or
/// empty), and the operator with the options that the file gives it; null if there is none in this
/// dimension. All are empty for a file that names none.
struct OperatorChoice {
  std::string family, member;
  std::unique_ptr<AnyOperator> made;

  bool is_named() const { return !family.empty(); }
  std::string name() const {
    if (!is_named()) return "none";
    return member.empty() ? family : family + "." + member;
  }
};

/// Says what a section holds that names an operator, `{family: sph, kernel: gauss}` or `sph.gauss`;
/// where none is required it may be empty.
void describe_operator(Description& description, OperatorChoice& choice, const Catalogue& catalogue,
                       std::int64_t dimension, bool required = true);

}  // namespace mote
