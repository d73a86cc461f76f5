#include "commands.hpp"
#include "interrupt.hpp"

int main(int argc, char** argv) {
  using namespace conceptplan::cli;
  CommandLine line;
  addValidateCommand(line);
  addPlannersCommand(line);
  return line.run(argc, argv, catchInterrupts());
}
