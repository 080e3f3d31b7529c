#include <gtest/gtest.h>
#include <cmath>
#include <cstdio>
#include <numbers>
#include "mote/walls/panel_bodies.hpp"
using namespace mote;
TEST(A,B){
  for(int n: {16,32,64,128,256}){
    std::vector<Outline> b{circle_outline(0,1,n)};
    PanelBodies pb(b,10);
    double gam=1.3;
    auto s=pb.sheet(pb.circulation_along_panels(1.0,{}),std::vector<double>{gam});
    double e=0; for(size_t k=0;k<s.size();++k){ double th=std::arg(pb.panels()[k].middle()); e=std::max(e,std::abs(s[k]-(-2*sin(th)+gam/2/std::numbers::pi)));}
    std::vector<Complex> pl{{0.3,0.2},{0.5,-0.7},{1.5,0.4},{0.,1.1}}; std::vector<Complex> v(4,1.0); pb.add_velocity(s,pl,v);
    double ef=0; for(int k=2;k<4;++k){Complex w=1.0-1.0/(pl[k]*pl[k])+gam/(2*std::numbers::pi*Complex(0,1)*pl[k]); ef=std::max(ef,std::abs(v[k]-std::conj(w)));}
    printf("%d err %g in %g %g  field %g circ %g\n",n,e,std::abs(v[0]),std::abs(v[1]),ef,pb.circulation(s,0));
  }
}
