#include "app/cli/commands.h"
#include "app/cli/sweep_flight.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <sstream>

namespace {

using namespace berg;
using namespace berg::cli;

/** Of the processes of an MPI program only the first one says what is wrong. */
bool isSilent()
{
    return mpiRank().value_or(0) > 0;
}

void complain(const std::string& text)
{
    if (!isSilent())
        std::fprintf(stderr, "%s\n", text.c_str());
}

int exitCodeOf(const Error& error)
{
    switch (error.code()) {
    case ErrorCode::FileNotFound:
    case ErrorCode::FileUnreadable:
    case ErrorCode::FileTooLarge:
    case ErrorCode::SyntaxError:
    case ErrorCode::WrongFormat:
    case ErrorCode::UnsupportedVersion:
    case ErrorCode::InvalidInput:
    case ErrorCode::Unsupported:
        return kBadInput;
    case ErrorCode::FileUnwritable:
    case ErrorCode::SolverFailed:
    case ErrorCode::ReplayMismatch:
        return kFailure;
    }
    return kFailure;
}

int run(int argc, char** argv, const std::stop_token& stop)
{
    CLI::App app{"Bergwatch: plan, fly and measure UAV missions that monitor drifting icebergs",
                 "bergwatch-cli"};
    app.set_version_flag("--version", BERG_VERSION);
    app.require_subcommand(1);
    app.get_formatter()->column_width(34);
    Action action;
    addPlanCommands(app, action);
    addCurveCommand(app, action);
    addSimulateCommand(app, action);
    addSweepCommand(app, action);
    addStudyCommand(app, action);
    addBenchmarkCommand(app, action);
    addExportCommand(app, action);
    addFileCommands(app, action);
    addImportCommand(app, action);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        std::ostringstream nowhere;
        const int code = isSilent() ? app.exit(error, nowhere, nowhere) : app.exit(error);
        return code == 0 ? kDone : kWrongUsage;
    }
    return action(stop);
}

} // namespace

int main(int argc, char** argv)
{
    const std::stop_token stop = interruptToken();
    try {
        return run(argc, argv, stop);
    } catch (const Interrupted&) {
        complain("interrupted, nothing written");
        return kInterrupted;
    } catch (const UsageError& error) {
        complain(error.message);
        return kWrongUsage;
    } catch (const Error& error) {
        complain(error.what());
        return exitCodeOf(error);
    } catch (const std::exception& error) {
        complain(std::string("internal error: ") + error.what());
        return kFailure;
    }
}
