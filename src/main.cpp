#include "mote/app/command_line.hpp"

int main(int argc, char** argv) {
  return mote::command_line(mote::standard_catalogue(), argc, argv);
}
