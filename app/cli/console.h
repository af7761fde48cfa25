#pragma once

#include "app/cli/language.h"

#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace berg::cli {

/** Exit codes: a promise to scripts. */
inline constexpr int kDone = 0;
inline constexpr int kFailure = 1;
inline constexpr int kWrongUsage = 2;
inline constexpr int kBadInput = 3;
inline constexpr int kLimitWithoutPlan = 4;
inline constexpr int kInterrupted = 130;

/** What is said when `Interrupted` ends a command. */
inline constexpr std::string_view kNothingWritten =
    QT_TRANSLATE_NOOP("CommandLine", "interrupted, nothing written");

/** Of an option whose files cannot be standard output. */
inline constexpr std::string_view kNoStream =
    QT_TRANSLATE_NOOP("CommandLine", "%1: '-' is not possible here: give a name");

/** Thrown where Ctrl-C ended a command; main turns it into `kInterrupted`. */
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
/** For options, "--policy, --backend", that the reason is about. */
[[nodiscard]] UsageError wrongOptions(const std::string& options, const IssueReason& reason);

/**
 * Makes Ctrl-C and termination a stop request, and lets a second one end the program at once. To be
 * called first in main, before any thread starts. The token is requested at the first signal.
 */
[[nodiscard]] std::stop_token interruptToken();

/**
 * While one lives, Ctrl-C and termination end the program at once, as nothing is written and
 * nothing can be lost: for reading, which asks for no stop. In the thread of main only.
 */
class EndsAtOnce
{
public:
    EndsAtOnce();
    EndsAtOnce(const EndsAtOnce&) = delete;
    EndsAtOnce& operator=(const EndsAtOnce&) = delete;
    ~EndsAtOnce();
};

/** The result of `read`, which writes nothing and may be ended at once. */
template <class Read>
auto reading(Read&& read)
{
    const EndsAtOnce scope;
    return std::forward<Read>(read)();
}

/** The result of `make`; what it throws names the file, unless a solver has failed by itself. */
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
 * A text of a file fit for a terminal: control characters, escapes and marks that turn the writing
 * direction are `?`; `word` also has no line end.
 */
[[nodiscard]] std::string shown(std::string_view text);
[[nodiscard]] std::string word(std::string_view text);

/** Prints to stdout as `shown`, all or nothing: a closed pipe or full disk is an error. */
void print(const std::string& text);

/** A line on stderr, as `shown`. */
void tell(const std::string& text);

/** The same, but nothing when quiet. */
void tellNote(const std::string& text);

/** From here on no warnings, hints, notes and progress bars. */
void beQuiet();

/** Warnings and hints on stderr, one line each; errors are not for here. */
void printWarnings(const std::string& subject, const std::vector<Issue>& issues);

/**
 * Progress bar with time left on stderr; draws nothing when `wanted` is false or stderr is no
 * terminal. Erased when destroyed.
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
    double m_first = -1; ///< fraction there was from the start: work done earlier
    double m_lastDrawn_s = -1;
};

/** 84 213 -> "84 213": rounded, thousands apart, for people. */
[[nodiscard]] std::string grouped(double value);
/** `decimals` after the point. */
[[nodiscard]] std::string fixed(double value, int decimals);
/** Filled up with blanks in front to `width`: an entry of a table. */
[[nodiscard]] std::string column(const std::string& text, std::size_t width);
/** A line for each row: the first `aligned` entries flush right in columns as wide as the widest of
 * them, what follows as it is; two blanks at least between. All rows have so many. */
[[nodiscard]] std::string tableLines(const std::vector<std::vector<std::string>>& rows,
                                     std::size_t aligned);
/** A name in front of a row of words, filled up with blanks to the width of "objective ", two at
 * least. */
[[nodiscard]] std::string rowLabel(const std::string& name);
/** "a,b" at ',' -> a, b; empty parts are kept, but for one at the end. */
[[nodiscard]] std::vector<std::string> split(const std::string& text, char separator);
/** A whole text as a finite number; `UsageError` naming the option otherwise. */
[[nodiscard]] double numberOf(const std::string& option, const std::string& text);

} // namespace berg::cli
