#include "mote/solvers/linear_solver.hpp"

#include <fmt/format.h>

#include <type_traits>

#include "mote/options/type_list.hpp"
#include "mote/particles/failure.hpp"
#include "mote/solvers/boomer_amg.hpp"
#include "mote/solvers/krylov_solver.hpp"

namespace mote {
namespace {

/// The preconditioners of this build, each of which makes a solver; the first is the default. A new
/// one is its own files and a word here.
using Preconditioners =
    std::conditional_t<MOTE_HAS_HYPRE, TypeList<BoomerAmg, DiagonalPreconditioner>,
                       TypeList<DiagonalPreconditioner>>;

}  // namespace

Choices solver_names() {
  Choices names;
  for_each_type(Preconditioners(), [&]<class Kind>() {
    names.push_back({std::string(Kind::name), std::string(Kind::summary)});
  });
  return names;
}

std::unique_ptr<LinearSolver> make_linear_solver(std::string_view name, SolverOptions options) {
  std::unique_ptr<Preconditioner> made;
  for_each_type(Preconditioners(), [&]<class Kind>() {
    if (name == Kind::name) made = std::make_unique<Kind>();
  });
  if (made) return std::make_unique<KrylovSolver>(std::move(options), std::move(made));
  if (name == BoomerAmg::name)
    throw InputError("this mote was built without hypre (Debian's libhypre-dev); use 'eigen'");
  throw InputError(fmt::format("there is no linear solver '{}'", name));
}

}  // namespace mote
