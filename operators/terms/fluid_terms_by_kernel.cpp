#include "mote/operators/terms/fluid_terms_by_kernel.hpp"

namespace mote {

template class FluidTermsOn<2, KernelByNumber>;
template class FluidTermsOn<3, KernelByNumber>;

}  // namespace mote
