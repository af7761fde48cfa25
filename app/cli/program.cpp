#include "app/cli/program.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <sstream>
#include <unistd.h>
#include <vector>

namespace berg::cli {

namespace {

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

int run(const Program& program, int argc, char** argv, const std::stop_token& stop)
{
    CLI::App app{program.about, program.name};
    app.set_version_flag("--version", program.version);
    app.require_subcommand(1);
    app.get_formatter()->column_width(34);
    Action action;
    program.addCommands(app, action);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        std::ostringstream help;
        std::ostringstream fault;
        const int code = app.exit(error, help, fault);
        if (!program.isSilent) {
            std::fputs(shown(fault.str()).c_str(), stderr);
            print(help.str());
        }
        return code == 0 ? kDone : kWrongUsage;
    }
    return action(stop);
}

} // namespace

int runProgram(const Program& program, int argc, char** argv, const std::stop_token& stop)
{
    const auto complain = [&program](const std::string& text) {
        if (!program.isSilent)
            tell(text);
    };
    try {
        return run(program, argc, argv, stop);
    } catch (const Interrupted&) {
        complain(kNothingWritten);
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

void becomeBergwatch(char** argv)
{
    std::string name = "bergwatch";
    std::vector<char*> arguments{name.data()};
    for (char** argument = argv + 1; *argument != nullptr; ++argument)
        arguments.push_back(*argument);
    arguments.push_back(nullptr);
    std::error_code failure;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", failure);
    if (!failure) {
        const std::filesystem::path folder = self.parent_path();
        for (const std::filesystem::path& beside :
             {folder / name, folder.parent_path() / name}) // installed, and where both were built
            execv(beside.c_str(), arguments.data());
    }
    execvp(name.c_str(), arguments.data());
}

} // namespace berg::cli
