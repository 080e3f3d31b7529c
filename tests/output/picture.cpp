#include "mote/output/picture.hpp"

#include <gmock/gmock.h>

#include "support/program.hpp"

namespace mote::test {
namespace {

using testing::EndsWith;

/// The outcome of a script, which finds the path of a file `seen` in its folder.
struct Script : TemporaryFolder {
  std::string draw(const std::string& text, unsigned seconds) const {
    write(*this / "script",
          "import os, pathlib, sys, time\n"
          "seen = pathlib.Path(sys.argv[1]) / 'seen'\n" +
              text);
    return draw_pictures(*this / "script", path(), seconds);
  }
};

TEST(DrawPictures, SaysNothingOfASuccess) {
  const Script script;
  EXPECT_EQ(script.draw("seen.touch()\n", 60), "");
  EXPECT_TRUE(fs::exists(script / "seen"));
}

TEST(DrawPictures, SaysWhatWentWrong) {
  const Script script;
  EXPECT_THAT(script.draw("sys.exit(1)\n", 60), EndsWith(" failed"));
  EXPECT_THAT(draw_pictures(script / "none", script.path()), EndsWith("is missing"));
}

TEST(DrawPictures, EndsAScriptWhoseTimeIsUp) {
  const Script script;
  EXPECT_THAT(script.draw("seen.write_text(str(os.getpid()))\n"
                          "while True: time.sleep(1)\n",
                          1),
              EndsWith(" took longer than 1 s"));
  if (fs::exists(script / "seen"))
    EXPECT_EQ(::kill(std::stoi(read(script / "seen")), 0), -1);  // nobody there
}

}  // namespace
}  // namespace mote::test
