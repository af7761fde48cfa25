#pragma once

#include "app/cli/console.h"
#include "core/io/export/export_files.h"

#include <functional>
#include <stop_token>

namespace CLI { // NOLINT(readability-identifier-naming): of CLI11
class App;
}

namespace berg::cli {

/** What a command does once the line is parsed; returns the exit code. */
using Action = std::function<int(const std::stop_token&)>;

// Each adds its sub-commands with their options to `app` and sets `action` when one is chosen.
void addPlanCommands(CLI::App& app, Action& action);    ///< solve, plan
void addCurveCommand(CLI::App& app, Action& action);    ///< curve
void addSimulateCommand(CLI::App& app, Action& action); ///< simulate
void addSweepCommand(CLI::App& app, Action& action);    ///< sweep
void addStudyCommand(CLI::App& app, Action& action);    ///< study
void addBenchmarkCommand(CLI::App& app, Action& action);
void addFileCommands(CLI::App& app, Action& action);  ///< validate
void addImportCommand(CLI::App& app, Action& action); ///< import
/** export; what is painted is left to the program bergwatch, which is given `argv` as well. */
void addExportCommand(CLI::App& app, Action& action, char** argv);
/** The same of a program that paints. */
void addExportCommand(CLI::App& app, Action& action, const ExportPainter& painter);

} // namespace berg::cli
