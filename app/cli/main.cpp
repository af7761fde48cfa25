#include "app/cli/commands.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

namespace {

using namespace berg;
using namespace berg::cli;

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
    addStudyCommands(app, action);
    addFileCommands(app, action);
    addImportCommand(app, action);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? kDone : kWrongUsage;
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
        std::fputs("interrupted, nothing written\n", stderr);
        return kInterrupted;
    } catch (const UsageError& error) {
        std::fprintf(stderr, "%s\n", error.message.c_str());
        return kWrongUsage;
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return exitCodeOf(error);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "internal error: %s\n", error.what());
        return kFailure;
    }
}
