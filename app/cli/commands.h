#pragma once

#include "app/cli/console.h"
#include "core/io/export/export_files.h"

#include <functional>
#include <stop_token>

namespace CLI { // NOLINT(readability-identifier-naming): of CLI11
class App;
}

namespace berg::cli {

/** Runs a command after its line has been parsed; returns the exit code. */
using Action = std::function<int(const std::stop_token&)>;

// Each function adds its sub-commands with their options to `app`; the chosen one sets `action`.
void addPlanCommands(CLI::App& app, Action& action);    ///< solve, plan
void addCurveCommand(CLI::App& app, Action& action);    ///< curve
void addSimulateCommand(CLI::App& app, Action& action); ///< simulate
void addSweepCommand(CLI::App& app, Action& action);    ///< sweep
void addStudyCommand(CLI::App& app, Action& action);    ///< study
void addBenchmarkCommand(CLI::App& app, Action& action);
void addFileCommands(CLI::App& app, Action& action);  ///< validate
void addImportCommand(CLI::App& app, Action& action); ///< import
void addForecastCommand(CLI::App& app, Action& action);
void addDriftCommand(CLI::App& app, Action& action);
void addStartsCommand(CLI::App& app, Action& action); ///< starts
void addVehicleCommand(CLI::App& app, Action& action);
void addListenCommand(CLI::App& app, Action& action);
/** Adds `export`. Painted formats run the program bergwatch with the arguments `argv`. */
void addExportCommand(CLI::App& app, Action& action, char** argv);
/** Adds `export` to a program that can paint; `painter` writes the painted formats. */
void addExportCommand(CLI::App& app, Action& action, const ExportPainter& painter);

} // namespace berg::cli
