#include "commands.hpp"
#include "interrupt.hpp"

int main(int argc, char** argv) {
  using namespace conceptplan::cli;
  CommandLine line;
  addGenerateCommands(line);
  addTrainCommand(line);
  addPlanCommand(line);
  addSolveCommand(line);
  addEvaluateCommand(line);
  addValidateCommand(line);
  addInspectCommands(line);
  addExportCommands(line);
  addPlannersCommand(line);
  addDoctorCommand(line);
  return line.run(argc, argv, catchInterrupts());
}
