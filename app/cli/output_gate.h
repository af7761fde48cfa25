#pragma once

#include "core/io/text/file_set.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace CLI { // NOLINT(readability-identifier-naming): of CLI11
class App;
class Option;
} // namespace CLI

namespace berg::cli {

/** A file that a command is about to write. */
struct Output
{
    std::string option;    ///< that names it, e.g. "--output"
    std::string path;      ///< empty: not asked for
    bool mayExist = false; ///< it is carried on, not overwritten
};

/** What a command reads and writes. */
struct CommandFiles
{
    std::vector<std::string> inputs;
    std::vector<Output> outputs;
    bool force = false; ///< files that exist are overwritten
    bool json = false;  ///< standard output is taken by a JSON document
};

/**
 * To be called before any work. Throws `UsageError` for an output that is an input or another
 * output (also by a link), or that exists and is not to be overwritten; `Error{FileUnwritable}`
 * when its folder is missing or it cannot be written. Each names the option and the file. Devices,
 * pipes and standard output always exist.
 */
void checkFiles(const CommandFiles& files);

/** The same for the files `names` in a folder, which need not be there yet. */
[[nodiscard]] std::vector<Output> outputsIn(const std::string& option, const std::string& folder,
                                            std::span<const std::string_view> names);

/** An option that names a file to write; `-` is standard output. */
CLI::Option* addOutputFile(CLI::App& command, const std::string& option, std::string& path,
                           const std::string& help);
/** `--force` */
void addForce(CLI::App& command, bool& force);

/**
 * Calls `before`, writes the files, all or none, and prints `text`: on stderr where a file goes to
 * standard output. What was computed is printed even when the rest fails; then throws.
 */
void deliver(std::span<const NewFile> files, const std::string& text,
             const std::function<void()>& before = {});
/** The same with `write`, which writes no file to standard output. */
void deliver(const std::string& text, const std::function<void()>& write);

} // namespace berg::cli
