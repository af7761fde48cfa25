#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI { // NOLINT(readability-identifier-naming): of CLI11
class App;
}

namespace berg::cli {

/**
 * The words of a command line after the program's name: `help COMMAND` as `COMMAND --help`, and `-`
 * in place of a file to read as /dev/stdin.
 */
[[nodiscard]] std::vector<std::string> wordsOf(int argc, const char* const* argv);

/**
 * The first command or option of `words` that does not exist, as a sentence with the nearest one
 * that does; none when all exist.
 */
[[nodiscard]] std::optional<std::string> unknownWord(const CLI::App& app,
                                                     const std::vector<std::string>& words);

/** "bergwatch-cli plan": the program and the command that `words` name. */
[[nodiscard]] std::string commandOf(const CLI::App& app, const std::vector<std::string>& words);

/** Lines of a help text longer than `width` are broken between words, under their second column. */
[[nodiscard]] std::string wrapped(const std::string& help, std::size_t width);

/** Columns of the terminal on standard output, 80 where there is none. */
[[nodiscard]] std::size_t terminalWidth();

/** A few lines to copy, at the end of the help of each command that is known here. */
void addExamples(CLI::App& app);

/** A bash script that completes the commands, options and files of the program. */
[[nodiscard]] std::string bashCompletion(const CLI::App& app);

} // namespace berg::cli
