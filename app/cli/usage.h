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

/** The words of a command line after the program's name: `help COMMAND` as `COMMAND --help`. */
[[nodiscard]] std::vector<std::string> wordsOf(int argc, const char* const* argv);

/**
 * The first command or option of `words` that does not exist, as a sentence with the nearest one
 * that does; none when all exist.
 */
[[nodiscard]] std::optional<Sentence> unknownWord(const CLI::App& app,
                                                  const std::vector<std::string>& words);

/** The same of the command alone, which CLI11 overlooks beside --help. */
[[nodiscard]] std::optional<Sentence> unknownCommand(const CLI::App& app,
                                                     const std::vector<std::string>& words);

/** A file to read, an argument or that of --into, that is `-` becomes /dev/stdin. */
void readDashFromStandardInput(CLI::App& app);

/** The first option or argument of the command that was given as an empty text; none: "". */
[[nodiscard]] std::string emptyOption(const CLI::App& app);

/** What a check of CLI11's is to say, in one text: it knows no two languages. */
[[nodiscard]] std::string inOne(const Sentence& fault);
/** What CLI11 found wrong, in words of a user. */
[[nodiscard]] Sentence plainWords(const CLI::ParseError& error);

/** "bergwatch-cli plan": the program and the command that `words` name. */
[[nodiscard]] std::string commandOf(const CLI::App& app, const std::vector<std::string>& words);

/** Lines of a help text longer than `width` are broken between words, under their second column. */
[[nodiscard]] std::string wrapped(const std::string& help, std::size_t width);

/** Columns of the terminal on standard output; where there is none, COLUMNS or 80. */
[[nodiscard]] std::size_t terminalWidth();

/** A few lines to copy, at the end of the help of each command that is known here. */
void addExamples(CLI::App& app);

/** A bash script that completes the commands, options and files of the program. */
[[nodiscard]] std::string bashCompletion(const CLI::App& app);

} // namespace berg::cli
