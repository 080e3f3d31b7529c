// Copies of this very program: how they end, and what is said of that.

#include "mote/app/children.hpp"

#include <gmock/gmock.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>

#include "support/program.hpp"

namespace mote::test {
namespace {

constexpr const char* order = "MOTE_TEST_CHILD";

/// Does nothing unless it runs in a child that was told how to end.
TEST(Child, EndsAsToldTo) {
  const char* told = std::getenv(order);
  if (told == nullptr) return;
  const int number = std::atoi(told);
  if (number < 0) std::raise(-number);
  std::fputs("the last words\n", stderr);
  std::_Exit(number);
}

/// What is said of a child that ends with an exit code, or by a signal if it is below zero.
std::string problem_after(int number, const TemporaryFolder& folder) {
  setenv(order, std::to_string(number).c_str(), 1);
  Children children;
  children.start(7, {"--gtest_filter=Child.EndsAsToldTo"}, folder / "messages");
  EXPECT_EQ(children.running(), 1u);
  const EndedChild ended = children.wait_for_one();
  unsetenv(order);
  EXPECT_EQ(ended.number, 7u);
  EXPECT_EQ(children.running(), 0u);
  return ended.problem;
}

TEST(Children, MayEndWithACertificate) {
  const TemporaryFolder folder;
  for (const int code : {0, 1, 3}) EXPECT_EQ(problem_after(code, folder), "") << code;
}

TEST(Children, AreQuotedWhenTheyEndInAnyOtherWay) {
  const TemporaryFolder folder;
  EXPECT_EQ(problem_after(2, folder), "ended with exit code 2: the last words");
  EXPECT_THAT(read(folder / "messages"), testing::EndsWith("the last words\n"));
}

TEST(Children, MayBeKilled) {
  const TemporaryFolder folder;
  EXPECT_EQ(problem_after(-SIGKILL, folder), "killed by signal 9 (Killed)");
}

TEST(Children, RunBesideEachOther) {
  const TemporaryFolder folder;
  setenv(order, "0", 1);
  Children children;
  for (std::size_t k = 0; k < 3; ++k)
    children.start(k, {"--gtest_filter=Child.EndsAsToldTo"}, folder / std::to_string(k));
  unsetenv(order);
  EXPECT_EQ(children.running(), 3u);
  std::size_t sum = 0;
  while (children.running() > 0) sum += children.wait_for_one().number;
  EXPECT_EQ(sum, 0u + 1 + 2);
}

}  // namespace
}  // namespace mote::test
