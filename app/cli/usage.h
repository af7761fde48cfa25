#pragma once

#include "app/cli/language.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI { // NOLINT(readability-identifier-naming): of CLI11
class App;
class ParseError;
} // namespace CLI

namespace berg::cli {

/** Returns the words after the program's name, with `help COMMAND` as `COMMAND --help`. */
[[nodiscard]] std::vector<std::string> wordsOf(int argc, const char* const* argv);

/**
 * Returns a message about the first unknown command or option in `words`, with the nearest known
 * one. Returns nullopt if all are known.
 */
[[nodiscard]] std::optional<Sentence> unknownWord(const CLI::App& app,
                                                  const std::vector<std::string>& words);

/** Returns the message about an unknown command alone, which CLI11 ignores next to --help. */
[[nodiscard]] std::optional<Sentence> unknownCommand(const CLI::App& app,
                                                     const std::vector<std::string>& words);

/** Replaces `-` by /dev/stdin for files to read: arguments and --into. */
void readDashFromStandardInput(CLI::App& app);

/** Returns the first option or argument with an empty value, or "" if there is none. */
[[nodiscard]] std::string emptyOption(const CLI::App& app);

/** Returns both languages of a message in one text, because a check of CLI11 has only one. */
[[nodiscard]] std::string inOne(const Sentence& fault);
/** Returns an error of CLI11 in plain words. */
[[nodiscard]] Sentence plainWords(const CLI::ParseError& error);

/** Returns the program and the command in `words`, such as "bergwatch-cli plan". */
[[nodiscard]] std::string commandOf(const CLI::App& app, const std::vector<std::string>& words);

/** Breaks lines of a help text that are longer than `width` between words, and indents the rest to
 * the second column. */
[[nodiscard]] std::string wrapped(const std::string& help, std::size_t width);

/** Returns the columns of the terminal on standard output; without one, COLUMNS or 80. */
[[nodiscard]] std::size_t terminalWidth();

/** Adds examples to the end of each command's help. */
void addExamples(CLI::App& app);

/** Returns a bash script that completes commands, options and files. */
[[nodiscard]] std::string bashCompletion(const CLI::App& app);

} // namespace berg::cli
