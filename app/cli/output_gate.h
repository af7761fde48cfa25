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
    std::string option;    ///< name of its option, for example "--output"
    std::string path;      ///< empty if the option was not given
    bool mayExist = false; ///< the command continues an existing file
};

/** The files that a command reads and writes. */
struct CommandFiles
{
    std::vector<std::string> inputs;
    std::vector<Output> outputs;
    bool force = false; ///< overwrite existing files
    bool json = false;  ///< a JSON document goes to standard output
};

/**
 * Checks all files of a command; call it before any work. Throws `UsageError` if an output is also
 * an input or another output (directly or through a link), or if it exists and must not be
 * overwritten. Throws `Error{FileUnwritable}` if its folder is missing or it cannot be written.
 * Each error names the option and the file. Devices, pipes and standard output may always exist.
 */
void checkFiles(const CommandFiles& files);

/** Returns the outputs `names` in a folder, which may be missing. */
[[nodiscard]] std::vector<Output> outputsIn(const std::string& option, const std::string& folder,
                                            std::span<const std::string_view> names);

/** Adds an option that names a file to write; `-` is standard output. */
CLI::Option* addOutputFile(CLI::App& command, const std::string& option, std::string& path,
                           const std::string& help);
/** Adds the option `--force`. */
void addForce(CLI::App& command, bool& force);

/**
 * Calls `before`, writes all files or none, and prints `text`, on stderr if a file goes to standard
 * output. It prints the text even if writing fails, and then throws.
 */
void deliver(std::span<const NewFile> files, const std::string& text,
             const std::function<void()>& before = {});
/** Calls `write`, which writes no file to standard output, and prints `text`, also if writing
 * fails. */
void deliver(const std::string& text, const std::function<void()>& write);

} // namespace berg::cli
