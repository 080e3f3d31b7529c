#pragma once

#include "mote/integrators/bulirsch_stoer.hpp"
#include "mote/integrators/conservation_correction.hpp"
#include "mote/integrators/contevol.hpp"
#include "mote/integrators/dormand_prince_853.hpp"
#include "mote/integrators/forward_euler.hpp"
#include "mote/integrators/gauss_radau_15.hpp"
#include "mote/integrators/heun.hpp"
#include "mote/integrators/leapfrog_dkd.hpp"
#include "mote/integrators/leapfrog_kdk.hpp"
#include "mote/integrators/predictor_corrector.hpp"
#include "mote/integrators/runge_kutta_4.hpp"
#include "mote/integrators/runge_kutta_8.hpp"
#include "mote/integrators/runge_kutta_nystrom_1210.hpp"
#include "mote/integrators/runge_kutta_nystrom_86.hpp"
#include "mote/integrators/stoermer_13.hpp"
#include "mote/integrators/symplectic_euler.hpp"
#include "mote/integrators/velocity_verlet.hpp"
#include "mote/integrators/wisdom_holman.hpp"
#include "mote/integrators/x_ivas.hpp"
#include "mote/options/type_list.hpp"

namespace mote {

/// The integrators of mote. A new one is its own file and a word here.
using Integrators =
    TypeList<ForwardEuler, SymplecticEuler, VelocityVerlet, LeapfrogKdk, LeapfrogDkd,
             PredictorCorrector, Heun, RungeKutta4, RungeKutta8, DormandPrince853,
             RungeKuttaNystrom86, RungeKuttaNystrom1210, GaussRadau15, BulirschStoer, Stoermer13,
             WisdomHolman, ContEvol1, ContEvol1Corrected, ContEvol2Direct, ContEvol2DirectCorrected,
             ContEvol2Indirect, ContEvol2IndirectCorrected, XIvas>;

}  // namespace mote
