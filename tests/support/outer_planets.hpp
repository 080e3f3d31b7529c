#pragma once

#include <array>

namespace mote::test {

/// A body: mass, place and velocity.
struct PlanetStart {
  double mass;
  std::array<double, 3> position, velocity;
};

/// The Sun with the mass of the inner planets, Jupiter, Saturn, Uranus and Neptune, about their
/// centre of mass, in solar masses, astronomical units and days: Applegate, Douglas, Gursel,
/// Sussman & Wisdom, Astron. J. 92 (1986) 176, as in the example outer_solar_system of REBOUND.
inline constexpr std::array<PlanetStart, 5> outer_planets{{
    {1.00000597682,
     {-4.06428567034226e-3, -6.08813756435987e-3, -1.66162304225834e-6},
     {6.69048890636161e-6, -6.33922479583593e-6, -3.13202145590767e-9}},
    {1 / 1047.355,
     {3.40546614227466, 3.62978190075864, 3.42386261766577e-2},
     {-5.59797969310664e-3, 5.51815399480116e-3, -2.66711392865591e-6}},
    {1 / 3501.6,
     {6.60801554403466, 6.38084674585064, -1.36145963724542e-1},
     {-4.17354020307064e-3, 3.99723751748116e-3, 1.67206320571441e-5}},
    {1 / 22869.0,
     {11.1636331405597, 16.0373479057256, 3.61783279369958e-1},
     {-3.25884806151064e-3, 2.06438412905916e-3, -2.17699042180559e-5}},
    {1 / 19314.0,
     {-30.1777243405203, 1.91155314998064, -1.53887595621042e-1},
     {-2.17471785045538e-4, -3.11361111025884e-3, 3.58344705491441e-5}},
}};

/// G, the square of the Gaussian constant. [AU^3 / (solar mass day^2)]
inline constexpr double gauss_constant_squared = 0.01720209895 * 0.01720209895;

}  // namespace mote::test
