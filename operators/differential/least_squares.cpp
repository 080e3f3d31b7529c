#include "mote/operators/differential/least_squares.hpp"

namespace mote {

// Compiled once: they are long.
template class LeastSquares<1, 2>;
template class LeastSquares<2, 2>;
template class LeastSquares<3, 2>;
template class LeastSquares<1, 3>;
template class LeastSquares<2, 3>;
template class LeastSquares<3, 3>;
template class LeastSquares<1, 4>;
template class LeastSquares<2, 4>;
template class LeastSquares<3, 4>;

}  // namespace mote
