#include "mote/models/model.hpp"

#include <algorithm>
#include <stdexcept>

#include "mote/particles/failure.hpp"

namespace mote {

void Model::restore(const Cloud& state) {
  for (const Field& field : cloud().fields()) {
    if (!state.has(field.name) || state.count() != cloud().count())
      throw InputError("this snapshot lacks particles or the field " + field.name);
    std::ranges::copy(state.values(field.name), cloud().values(field.name).begin());
  }
}

std::unique_ptr<Model> ModelRecipe::make(LineSetup) const {
  throw std::logic_error("this model does not live on a line");
}

std::unique_ptr<Model> ModelRecipe::make(SpaceSetup) const {
  throw std::logic_error("this model does not live in space");
}

}  // namespace mote
