#pragma once

#include "command_line.hpp"

namespace conceptplan::cli {

// Each adds one command with its options.

void addDoctorCommand(CommandLine& line);
void addEvaluateCommand(CommandLine& line);
void addPlanCommand(CommandLine& line);
void addPlannersCommand(CommandLine& line);
void addSolveCommand(CommandLine& line);
void addTrainCommand(CommandLine& line);
void addValidateCommand(CommandLine& line);

// All commands of a group.

void addExportCommands(CommandLine& line);
void addGenerateCommands(CommandLine& line);
void addInspectCommands(CommandLine& line);

// Those of the groups.

void addExportOmplLogCommand(CommandLine& line, CLI::App& group);
void addExportPddlCommands(CommandLine& line, CLI::App& group);
void addExportPlanCommand(CommandLine& line, CLI::App& group);
void addGenerateConceptsCommand(CommandLine& line, CLI::App& group);
void addGenerateImagesCommand(CommandLine& line, CLI::App& group);
void addGenerateScenariosCommand(CommandLine& line, CLI::App& group);
void addGenerateTasksCommand(CommandLine& line, CLI::App& group);
void addInspectDatasetCommand(CommandLine& line, CLI::App& group);
void addInspectFiguresCommand(CommandLine& line, CLI::App& group);
void addInspectModelCommand(CommandLine& line, CLI::App& group);
void addInspectScenarioCommand(CommandLine& line, CLI::App& group);

}  // namespace conceptplan::cli
