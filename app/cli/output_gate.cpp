#include "app/cli/output_gate.h"

#include "app/cli/console.h"
#include "core/io/text/atomic_file.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <sys/stat.h>
#include <unistd.h>

namespace berg::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kStandardOutput = "/dev/stdout";

/** Which file a path means, whatever it is called; of a file that is not there, where it will be.
 */
struct FileIdentity
{
    std::optional<std::pair<dev_t, ino_t>> node;
    fs::path place;
    bool operator==(const FileIdentity&) const = default;
};

/** None for devices and pipes, which may be named twice, and for folders. */
std::optional<FileIdentity> identityOf(const std::string& path)
{
    struct stat found = {};
    if (isOpenDescriptor(path))
        return FileIdentity{.node = std::nullopt, .place = path};
    if (::stat(path.c_str(), &found) == 0) {
        if (!S_ISREG(found.st_mode))
            return std::nullopt;
        return FileIdentity{.node = std::pair(found.st_dev, found.st_ino), .place = {}};
    }
    std::error_code failure;
    return FileIdentity{.node = std::nullopt,
                        .place = fs::weakly_canonical(fs::absolute(path, failure), failure)};
}

std::string named(const Output& output)
{
    return output.option + ": " + output.path;
}

bool isStandardOutput(const std::string& path)
{
    return path == kStandardOutput || path == "/dev/fd/1" || path == "/proc/self/fd/1";
}

void checkApart(const CommandFiles& files)
{
    std::vector<std::pair<FileIdentity, const Output*>> known;
    for (const Output& output : files.outputs) {
        const std::optional<FileIdentity> identity = identityOf(output.path);
        if (output.path.empty() || !identity)
            continue;
        for (const std::string& input : files.inputs)
            if (identityOf(input) == identity)
                throw UsageError(
                    input == output.path
                        ? QT_TRANSLATE_NOOP("CommandLine",
                                            "%1 is an input of this command; name another file")
                        : QT_TRANSLATE_NOOP(
                              "CommandLine",
                              "%1 is an input of this command (%2); name another file"),
                    {named(output), input});
        for (const auto& [other, earlier] : known)
            if (other == *identity)
                throw UsageError(
                    QT_TRANSLATE_NOOP("CommandLine",
                                      "%1 is already the file of %2; name another file"),
                    {named(output), earlier->option});
        known.emplace_back(*identity, &output);
    }
}

[[noreturn]] void fail(const Output& output, const IssueReason& why)
{
    throw Error(ErrorCode::FileUnwritable, named(output), why);
}

/** The folder must be there; a file to write is none. */
void checkFolder(const Output& output)
{
    const fs::path folder = fs::path(output.path).parent_path();
    std::error_code failure;
    const fs::file_status status = fs::status(folder.empty() ? "." : folder, failure);
    if (!fs::exists(status))
        fail(output, {IssueId::NoFolder, {folder.string()}});
    if (!fs::is_directory(status))
        fail(output, {IssueId::OtherNoFolder, {folder.string()}});
}

void checkOne(const Output& output, const CommandFiles& files)
{
    if (files.json && isStandardOutput(output.path))
        throw UsageError(
            QT_TRANSLATE_NOOP("CommandLine", "%1 and --json both need standard output"),
            {named(output)});
    if (isOpenDescriptor(output.path))
        return;
    checkFolder(output);
    std::error_code failure;
    if (!output.mayExist && !files.force && fs::is_regular_file(output.path, failure))
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "%1 exists; use --force to overwrite it"),
                         {named(output)});
    try {
        checkWritable(output.path);
    } catch (const Error& error) {
        fail(output, error.issues().front().reason);
    }
}

/** Writes and prints, on stderr where standard output is taken; then the first of what failed. */
void finish(const std::string& text, bool isTaken, const std::function<void()>& write)
{
    std::exception_ptr failure;
    try {
        write();
    } catch (...) {
        failure = std::current_exception();
    }
    if (isTaken)
        std::fputs(shown(text).c_str(), stderr);
    else
        print(text);
    if (failure)
        std::rethrow_exception(failure);
}

} // namespace

void checkFiles(const CommandFiles& files)
{
    checkApart(files);
    for (const Output& output : files.outputs)
        if (!output.path.empty())
            checkOne(output, files);
}

std::vector<Output> outputsIn(const std::string& option, const std::string& folder,
                              std::span<const std::string_view> names)
{
    if (folder.empty())
        return {};
    std::error_code failure;
    fs::path there = fs::absolute(folder, failure).lexically_normal();
    const fs::file_status status = fs::status(there, failure);
    const Output asked{.option = option, .path = folder};
    if (fs::exists(status) && !fs::is_directory(status))
        fail(asked, {IssueId::ItselfNoFolder});
    if (!fs::exists(status)) { // the folder is still to be created, so no file exists in it
        while (!fs::exists(there, failure) && there.has_relative_path())
            there = there.parent_path();
        if (!fs::is_directory(there, failure))
            fail(asked, {IssueId::OtherNoFolder, {there.string()}});
        if (::access(there.c_str(), W_OK | X_OK) != 0)
            fail(asked, {IssueId::CannotMakeIt, {std::generic_category().message(errno)}});
        return {};
    }
    std::vector<Output> outputs;
    for (const std::string_view name : names)
        outputs.push_back({.option = option, .path = folder + '/' + std::string(name)});
    return outputs;
}

CLI::Option* addOutputFile(CLI::App& command, const std::string& option, std::string& path,
                           const std::string& help)
{
    const auto assign = [&path](const std::string& text) {
        path = text == "-" ? std::string(kStandardOutput) : text;
    };
    return command.add_option_function<std::string>(option, assign, help);
}

void addForce(CLI::App& command, bool& force)
{
    command.add_flag("--force", force, "Overwrite files that exist");
}

void deliver(std::span<const NewFile> files, const std::string& text,
             const std::function<void()>& before)
{
    const bool isTaken =
        std::ranges::any_of(files, [](const NewFile& file) { return isStandardOutput(file.path); });
    finish(text, isTaken, [&] {
        if (before)
            before();
        writeFileSet(files);
    });
}

void deliver(const std::string& text, const std::function<void()>& write)
{
    finish(text, false, write);
}

} // namespace berg::cli
