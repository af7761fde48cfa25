#include "app/cli/program.h"
#include "core/base/version.h"

using namespace berg::cli;

// NOLINTNEXTLINE(bugprone-exception-escape): only without memory for a few words
int main(int argc, char** argv)
{
    const std::stop_token stop = interruptToken();
    const auto addCommands = [argv](CLI::App& app, Action& action) {
        addPlanCommands(app, action);
        addCurveCommand(app, action);
        addSimulateCommand(app, action);
        addSweepCommand(app, action);
        addStudyCommand(app, action);
        addBenchmarkCommand(app, action);
        addExportCommand(app, action, argv);
        addFileCommands(app, action);
        addImportCommand(app, action);
        addForecastCommand(app, action);
        addDriftCommand(app, action);
        addStartsCommand(app, action);
        addVehicleCommand(app, action);
        addListenCommand(app, action);
    };
    return runProgram(
        {.name = "bergwatch-cli",
         .about = "Bergwatch: plan, fly and measure UAV missions that monitor drifting icebergs",
         .version = berg::programVersion(),
         .addCommands = addCommands,
         .isSilent = mpiRank().value_or(0) > 0}, // the first process says what is wrong
        argc, argv, stop);
}
