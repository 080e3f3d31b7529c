#pragma once

namespace mote {

/// Pair terms in any dimension.
class AnyFluidTerms {
 public:
  virtual ~AnyFluidTerms() = default;
};

}  // namespace mote
