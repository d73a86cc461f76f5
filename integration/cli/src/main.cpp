#include "commands.hpp"
#include "interrupt.hpp"

int main(int argc, char** argv) {
  using namespace conceptplan::cli;
  CommandLine line;
  addGenerateCommands(line);
  addInspectCommands(line);
  addValidateCommand(line);
  addPlannersCommand(line);
  addDoctorCommand(line);
  return line.run(argc, argv, catchInterrupts());
}
