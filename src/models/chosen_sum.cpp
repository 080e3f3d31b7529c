#include "mote/models/chosen_sum.hpp"

#include "mote/operators/cores/all.hpp"

namespace mote {

Choices sum_choices(const std::string& points) {
  return {{"automatic", "direct for few " + points + ", multipole for many"},
          {"direct", "pair by pair"},
          {"multipole", "an adaptive fast multipole method"}};
}

Choices core_choices(const std::string& none) {
  Choices choices{{"point", none}};
  for_each_type(VortexCores{}, [&]<class Core>() {
    choices.push_back({std::string(Core::name), std::string(Core::summary)});
  });
  return choices;
}

}  // namespace mote
