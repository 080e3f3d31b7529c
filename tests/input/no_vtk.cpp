#include <gtest/gtest.h>

#include "input/refusal.hpp"
#include "support/program.hpp"

namespace mote::test {
namespace {

TEST(VtkPoints, NeedVtk) {
  const TemporaryFolder folder;
  for (const char* name : {"a.vtp", "a.vtu", "a.vtk"})
    EXPECT_EQ(refusal(write(folder / name, "")),
              std::string(name) +
                  ": this mote was built without VTK and cannot read this file; give .csv or .hdf");
}

}  // namespace
}  // namespace mote::test
