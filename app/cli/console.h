#pragma once

#include "app/cli/language.h"

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace berg::cli {

/** Exit codes. Scripts rely on them, so they never change. */
inline constexpr int kDone = 0;
inline constexpr int kFailure = 1;
inline constexpr int kWrongUsage = 2;
inline constexpr int kBadInput = 3;
inline constexpr int kLimitWithoutPlan = 4;
inline constexpr int kInterrupted = 130;

/** The message after `Interrupted` has ended a command. */
inline constexpr std::string_view kNothingWritten =
    QT_TRANSLATE_NOOP("CommandLine", "interrupted, nothing written");

/** The message for an option whose file cannot be standard output. */
inline constexpr std::string_view kNoStream =
    QT_TRANSLATE_NOOP("CommandLine", "%1: '-' is not possible here; give a file name");

/** Thrown when Ctrl-C ends a command; `runProgram` returns `kInterrupted` for it. */
struct Interrupted
{
};

/** Thrown for options that contradict each other. */
struct UsageError
{
    explicit UsageError(Sentence words) : message(std::move(words)) {}
    explicit UsageError(std::string_view pattern, const std::vector<IssueArgument>& arguments = {})
        : message(sentence(pattern, arguments))
    {
    }
    Sentence message;
};
/** Returns the error of the named options ("--policy, --backend"), with `reason` as its text. */
[[nodiscard]] UsageError wrongOptions(const std::string& options, const IssueReason& reason);

/**
 * Turns Ctrl-C and termination into a stop request; a second signal ends the program at once. Call
 * it first in main, before any thread starts. The token is stopped at the first signal.
 */
[[nodiscard]] std::stop_token interruptToken();

/**
 * While a scope of this type lives, Ctrl-C and termination end the program at once. Reading files
 * uses it: reading has no stop token, and nothing can be lost. Main thread only.
 */
class ImmediateInterruptScope
{
public:
    ImmediateInterruptScope();
    ImmediateInterruptScope(const ImmediateInterruptScope&) = delete;
    ImmediateInterruptScope& operator=(const ImmediateInterruptScope&) = delete;
    ~ImmediateInterruptScope();
};

/** Returns the result of `read`, which writes nothing, so that Ctrl-C may end it at once. */
template <class Read>
auto reading(Read&& read)
{
    const ImmediateInterruptScope scope;
    return std::forward<Read>(read)();
}

/** Returns the result of `make`. Errors that it throws get the name of the file, except
 * `SolverFailed`. */
template <class Make>
auto naming(const std::string& file, const Make& make)
{
    try {
        return make();
    } catch (const Error& error) {
        if (error.code() == ErrorCode::SolverFailed)
            throw;
        throw Error(error.code(), file, error.issues());
    }
}

/**
 * Makes the text of a file safe for a terminal: control characters, escapes and marks that change
 * the writing direction become `?`. `word` replaces line ends as well.
 */
[[nodiscard]] std::string shown(std::string_view text);
[[nodiscard]] std::string word(std::string_view text);

/** Prints `shown(text)` to stdout. A closed pipe or a full disk throws `Error`. */
void print(const std::string& text);

/** Prints `shown(text)` as a line on stderr. */
void printMessage(const std::string& text);

/** Prints a note as a line on stderr, unless the program is quiet. */
void printNote(const std::string& text);

/** Turns off warnings, hints, notes and progress bars. */
void beQuiet();

/** Prints warnings and hints on stderr, one line each. `issues` contains no errors. */
void printWarnings(const std::string& subject, const std::vector<Issue>& issues);

/**
 * Progress bar with the time left, on stderr. It draws nothing if `wanted` is false or stderr is no
 * terminal, and erases itself when destroyed.
 */
class ProgressBar
{
public:
    ProgressBar(std::string label, bool wanted);
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;
    ~ProgressBar();

    /** `fraction` in [0, 1]; draws at most ten times a second. */
    void update(double fraction);

private:
    std::string m_label;
    bool m_active;
    double m_start_s;
    std::optional<double> m_first; ///< fraction of the first update, from earlier work
    std::optional<double> m_lastDrawn_s;
};

/** Returns 84213.4 as "84 213": rounded, with thousands separated. */
[[nodiscard]] std::string grouped(double value);
/** Returns the value with `decimals` digits after the point. */
[[nodiscard]] std::string fixed(double value, int decimals);
/** Returns the text right-aligned in a column of `width` characters. */
[[nodiscard]] std::string column(const std::string& text, std::size_t width);
/** Returns a line for each row. The first `aligned` entries are right-aligned in columns as wide as
 * their widest entry, the others follow unchanged, with at least two blanks between. Every row has
 * at least `aligned` entries. */
[[nodiscard]] std::string tableLines(const std::vector<std::vector<std::string>>& rows,
                                     std::size_t aligned);
/** Returns the name filled up with blanks, at least two, to the width of "objective ". */
[[nodiscard]] std::string rowLabel(const std::string& name);
/** Splits a text at the separator. Keeps empty parts, except one at the end. */
[[nodiscard]] std::vector<std::string> split(const std::string& text, char separator);
/** Returns the whole text as a finite number; throws `UsageError` with the option's name otherwise.
 */
[[nodiscard]] double numberOf(const std::string& option, const std::string& text);

} // namespace berg::cli
