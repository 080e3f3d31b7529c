#pragma once

namespace mote::test {

/// Number of times that this program has asked for memory by `new`, in any thread.
long allocations();

}  // namespace mote::test
