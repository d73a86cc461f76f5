#pragma once

#include "command_line.hpp"

namespace conceptplan::cli {

// Each adds one command with its options.

void addDoctorCommand(CommandLine& line);
/// All commands of the group `generate`.
void addGenerateCommands(CommandLine& line);
void addGenerateConceptsCommand(CommandLine& line, CLI::App& group);
void addGenerateImagesCommand(CommandLine& line, CLI::App& group);
void addGenerateScenariosCommand(CommandLine& line, CLI::App& group);
void addGenerateTasksCommand(CommandLine& line, CLI::App& group);
void addInspectCommands(CommandLine& line);
void addPlannersCommand(CommandLine& line);
void addValidateCommand(CommandLine& line);

}  // namespace conceptplan::cli
