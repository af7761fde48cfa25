#include "app/cli/console.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <mutex>
#include <pthread.h>
#include <sstream>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace berg::cli {

namespace {

double now_s()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

std::string clock(double seconds)
{
    const auto whole = static_cast<long>(std::ceil(seconds));
    char text[32];
    std::snprintf(text, sizeof text, "%02ld:%02ld", whole / 60, whole % 60);
    return text;
}

/** State shared by main and the thread that waits for signals. */
struct Interrupts
{
    std::mutex mutex;
    std::stop_source source;
    int readers = 0; ///< `ImmediateInterruptScope` that live
};

Interrupts& interrupts()
{
    static Interrupts shared;
    return shared;
}

[[noreturn]] void endAtOnce()
{
    ::dprintf(STDERR_FILENO, "%s\n", said(kNothingWritten).data());
    _exit(kInterrupted);
}

/** Waits for signals in the mask of all threads, from the first on. */
void awaitInterrupts(const sigset_t& set)
{
    int signal = 0;
    sigwait(&set, &signal);
    {
        const std::lock_guard lock(interrupts().mutex);
        if (interrupts().readers > 0)
            endAtOnce();
        interrupts().source.request_stop();
    }
    sigwait(&set, &signal);
    _exit(kInterrupted);
}

bool isQuiet = false; // set in main before anything runs

} // namespace

ImmediateInterruptScope::ImmediateInterruptScope()
{
    const std::lock_guard lock(interrupts().mutex);
    ++interrupts().readers;
    if (interrupts().source.stop_requested())
        endAtOnce();
}

ImmediateInterruptScope::~ImmediateInterruptScope()
{
    const std::lock_guard lock(interrupts().mutex);
    --interrupts().readers;
}

UsageError wrongOptions(const std::string& options, const IssueReason& reason)
{
    return UsageError(Sentence{.english = options + ": " + englishText(reason),
                               .said = options + ": " + said(reason)});
}

std::stop_token interruptToken()
{
    // Signals are taken by one waiting thread: a stop request runs callbacks that a signal handler
    // must not. All later threads inherit the mask.
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    try {
        std::thread([set] { awaitInterrupts(set); }).detach();
    } catch (const std::system_error&) { // no memory for a thread: they end the program as usual
        pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
    }
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN); // a file that grows too large is reported like any other failure
    return interrupts().source.get_token();
}

std::string shown(std::string_view text)
{
    // C1 controls, overrides of the writing direction and its isolates, line separators.
    constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kUnseen{
        {{"\xC2\x80", "\xC2\x9F"},
         {"\xE2\x80\xAA", "\xE2\x80\xAE"},
         {"\xE2\x81\xA6", "\xE2\x81\xA9"},
         {"\xE2\x80\xA8", "\xE2\x80\xA9"}}};
    std::string safe;
    for (std::size_t i = 0; i < text.size();) {
        const auto code = static_cast<unsigned char>(text[i]);
        std::size_t unseen = (code < 0x20U && code != '\n' && code != '\t') || code == 0x7FU;
        for (const auto& [first, last] : kUnseen)
            if (const std::string_view at = text.substr(i, first.size()); at >= first && at <= last)
                unseen = first.size();
        safe += unseen > 0 ? '?' : text[i];
        i += std::max<std::size_t>(unseen, 1);
    }
    return safe;
}

std::string word(std::string_view text)
{
    std::string safe = shown(text);
    std::ranges::replace_if(
        safe, [](char c) { return c == '\n' || c == '\t'; }, '?');
    return safe;
}

void printMessage(const std::string& text)
{
    std::fprintf(stderr, "%s\n", shown(text).c_str());
}

void print(const std::string& text)
{
    const std::string printed = shown(text);
    const bool written = std::fwrite(printed.data(), 1, printed.size(), stdout) == printed.size();
    if (std::fflush(stdout) != 0 || !written)
        throw Error(ErrorCode::FileUnwritable, "standard output", {IssueId::StreamUnwritable});
}

void beQuiet()
{
    isQuiet = true;
}

void printNote(const std::string& text)
{
    if (!isQuiet)
        printMessage(text);
}

void printWarnings(const std::string& subject, const std::vector<Issue>& issues)
{
    for (const Issue& issue : issues) {
        if (isQuiet || issue.severity == Severity::Error)
            continue;
        const char* const kind = issue.severity == Severity::Warning
                                     ? QT_TRANSLATE_NOOP("CommandLine", "warning")
                                     : QT_TRANSLATE_NOOP("CommandLine", "hint");
        printMessage(word(subject) + ": " + said(kind, {}) + ": " + said(issue));
    }
}

ProgressBar::ProgressBar(std::string label, bool wanted)
    : m_label(std::move(label))
    , m_active(wanted && !isQuiet && isatty(STDERR_FILENO) == 1)
    , m_start_s(now_s())
{
}

ProgressBar::~ProgressBar()
{
    if (m_active && m_lastDrawn_s)
        std::fputs("\r\033[K", stderr);
}

void ProgressBar::update(double fraction)
{
    const double time_s = now_s();
    if (!m_first)
        m_first = fraction;
    if (!m_active || (m_lastDrawn_s && time_s - *m_lastDrawn_s < 0.1))
        return;
    m_lastDrawn_s = time_s;
    constexpr int kWidth = 30;
    const int filled = static_cast<int>(std::lround(fraction * kWidth));
    const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                            std::string(static_cast<std::size_t>(kWidth - filled), '.');
    const double elapsed_s = time_s - m_start_s;
    const double now = fraction - *m_first;
    const std::string left = now > 0.01 ? clock(elapsed_s * (1 - fraction) / now) : "--:--";
    std::fprintf(stderr, "\r\033[K%s [%s] %3.0f %%  %s", m_label.c_str(), bar.c_str(),
                 100 * fraction, said(QT_TRANSLATE_NOOP("CommandLine", "%1 left"), {left}).c_str());
    std::fflush(stderr);
}

std::string fixed(double value, int decimals)
{
    return fixedText(value, decimals);
}

std::string grouped(double value)
{
    return groupedText(value, 0, " ");
}

std::string column(const std::string& text, std::size_t width)
{
    return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

std::string tableLines(const std::vector<std::vector<std::string>>& rows, std::size_t aligned)
{
    constexpr std::size_t kBetween = 2;
    std::vector<std::size_t> widths(aligned, 0);
    for (const std::vector<std::string>& row : rows)
        for (std::size_t k = 0; k < aligned; ++k)
            widths[k] = std::max(widths[k], row[k].size() + (k > 0 ? kBetween : 0));
    std::string text;
    for (const std::vector<std::string>& row : rows) {
        for (std::size_t k = 0; k < row.size(); ++k)
            text += k < aligned ? column(row[k], widths[k]) : "  " + row[k];
        text += '\n';
    }
    return text;
}

std::string rowLabel(const std::string& name)
{
    constexpr std::size_t kWidth = 10;
    constexpr std::size_t kBetween = 2;
    const std::string shownName = word(name);
    const auto width = static_cast<std::size_t>(std::ranges::count_if(
        shownName, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
    return shownName + std::string(std::max(kWidth, width + kBetween) - width, ' ');
}

std::vector<std::string> split(const std::string& text, char separator)
{
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);)
        parts.push_back(part);
    return parts;
}

double numberOf(const std::string& option, const std::string& text)
{
    double value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "%1: %2 is not a number"),
                         {option, text});
    return value;
}

} // namespace berg::cli
