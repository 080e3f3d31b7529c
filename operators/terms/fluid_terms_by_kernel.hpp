#pragma once

#include "mote/operators/kernels/kernel_by_number.hpp"
#include "mote/operators/terms/fluid_terms_on.hpp"

namespace mote {

extern template class FluidTermsOn<2, KernelByNumber>;
extern template class FluidTermsOn<3, KernelByNumber>;

/// The pair terms of a fluid on a kernel, in the fastest form that it has.
template <int D, class Kernel>
std::unique_ptr<FluidTerms<D>> fluid_terms_by(const Kernel& kernel) {
  if constexpr (LaneKernel<Kernel>)
    return std::make_unique<FluidTermsOn<D, Kernel>>(kernel);
  else
    return std::make_unique<FluidTermsOn<D, KernelByNumber>>(KernelByNumber(kernel));
}

}  // namespace mote
