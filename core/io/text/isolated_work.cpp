#include "core/io/text/isolated_work.h"

#include "core/base/error.h"
#include "core/base/stopped.h"
#include "core/io/text/byte_stream.h"
#include "core/io/text/read_budget.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <new>
#include <poll.h>
#include <string_view>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace berg {

namespace {

/** First byte of what the copy sends. */
enum class Message : char
{
    Progress = 'P',
    Result = 'R',
    Failure = 'E'
};

void sendAll(int pipe, std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t sent = write(pipe, bytes.data(), bytes.size());
        if (sent < 0 && errno == EINTR)
            continue;
        if (sent <= 0)
            _exit(1);
        bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
}

std::string errorBytes(const Error& error)
{
    ByteWriter bytes;
    bytes.add(static_cast<int>(error.code()));
    bytes.add(error.subject());
    bytes.add(error.issues().size());
    for (const Issue& issue : error.issues()) {
        bytes.add(issue.field);
        bytes.add(static_cast<int>(issue.reason.id));
        bytes.add(issue.reason.arguments.size());
        for (const IssueArgument& argument : issue.reason.arguments) {
            bytes.add(argument.index());
            if (const auto* number = std::get_if<double>(&argument))
                bytes.add(*number);
            else if (const auto* count = std::get_if<std::int64_t>(&argument))
                bytes.add(*count);
            else if (const auto* text = std::get_if<std::string>(&argument))
                bytes.add(*text);
            else if (const auto* path = std::get_if<FieldPath>(&argument))
                bytes.add(path->path);
            else if (const auto* kind = std::get_if<ValueKind>(&argument))
                bytes.add(*kind);
            else
                require(false, "runIsolated: an amount in an error");
        }
    }
    return bytes.done();
}

IssueArgument argumentFrom(ByteReader& bytes)
{
    const IssueArgument kinds[] = {0.0, std::int64_t{0}, std::string(), ValueKind::Null,
                                   FieldPath{}};
    const auto index = bytes.take<std::size_t>();
    if (index == kinds[0].index())
        return bytes.take<double>();
    if (index == kinds[1].index())
        return bytes.take<std::int64_t>();
    if (index == kinds[2].index())
        return bytes.takeText();
    if (index == kinds[3].index())
        return bytes.take<ValueKind>();
    return FieldPath{bytes.takeText()};
}

Error errorFrom(std::string_view text)
{
    ByteReader bytes(text);
    const auto code = static_cast<ErrorCode>(bytes.take<int>());
    const std::string subject = bytes.takeText();
    std::vector<Issue> issues(bytes.take<std::size_t>());
    for (Issue& issue : issues) {
        issue.field = bytes.takeText();
        issue.reason.id = static_cast<IssueId>(bytes.take<int>());
        const auto arguments = bytes.take<std::size_t>();
        for (std::size_t i = 0; i < arguments; ++i)
            issue.reason.arguments.push_back(argumentFrom(bytes));
    }
    return {code, subject, std::move(issues)};
}

void limitTo(int resource, rlim_t most)
{
    const rlimit limit{.rlim_cur = most, .rlim_max = most};
    (void)setrlimit(static_cast<__rlimit_resource>(resource), &limit);
}

/** Bytes of address space that this process has. */
std::size_t addressSpace()
{
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true; // its shadow memory takes terabytes of address space
#else
constexpr bool kIsSanitized = false;
#endif

[[noreturn]] void
runCopy(const std::string& subject, int pipe,
        const std::function<std::string(const std::function<void(double)>&)>& work,
        const IsolationLimits& limits)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int number : {SIGINT, SIGTERM, SIGSEGV, SIGBUS, SIGABRT, SIGFPE})
        (void)signal(number, SIG_DFL);
    (void)signal(SIGPIPE, SIG_IGN);
    limitTo(RLIMIT_CORE, 0);
    limitTo(RLIMIT_CPU, limits.processor_s);
    if (!kIsSanitized) {
        limitTo(RLIMIT_AS, addressSpace() + limits.memory);
        if (const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0) {
            (void)dup2(nowhere, STDOUT_FILENO); // libraries print what they think of a file
            (void)dup2(nowhere, STDERR_FILENO);
        }
    }
    const auto report = [pipe](double share) {
        std::array<char, 1 + sizeof share> bytes{static_cast<char>(Message::Progress)};
        std::memcpy(bytes.data() + 1, &share, sizeof share);
        sendAll(pipe, {bytes.data(), bytes.size()});
    };
    try {
        const std::string result = work(report);
        sendAll(pipe, std::string(1, static_cast<char>(Message::Result)));
        sendAll(pipe, result);
    } catch (const Error& error) {
        sendAll(pipe, static_cast<char>(Message::Failure) + errorBytes(error));
    } catch (const std::bad_alloc&) {
        const Error error(
            ErrorCode::FileTooLarge, subject,
            {IssueId::TooMuchMemory, {countOf(limits.memory / 1'000'000), doubledLimits()}});
        sendAll(pipe, static_cast<char>(Message::Failure) + errorBytes(error));
    } catch (...) {
        _exit(1);
    }
    _exit(0);
}

/** The process that works, ended with this object. */
class Copy
{
public:
    Copy(pid_t process, int pipe) : m_process(process), m_pipe(pipe) {}
    Copy(const Copy&) = delete;
    Copy& operator=(const Copy&) = delete;
    ~Copy()
    {
        (void)kill(m_process, SIGKILL);
        while (waitpid(m_process, nullptr, 0) < 0 && errno == EINTR) {
        }
        (void)close(m_pipe);
    }

    /** Returns all that it sends; passes progress on. */
    std::string received(const std::function<void(double)>& progress, const std::stop_token& stop)
    {
        std::string bytes;
        std::array<char, 65536> part{};
        while (true) {
            throwIfStopped(stop);
            pollfd wait{.fd = m_pipe, .events = POLLIN};
            if (poll(&wait, 1, 10) <= 0)
                continue;
            const ssize_t count = read(m_pipe, part.data(), part.size());
            if (count < 0 && errno == EINTR)
                continue;
            if (count <= 0)
                return bytes;
            bytes.append(part.data(), static_cast<std::size_t>(count));
            takeProgress(bytes, progress);
        }
    }

private:
    static void takeProgress(std::string& bytes, const std::function<void(double)>& progress)
    {
        double share = 0;
        constexpr std::size_t kLength = 1 + sizeof share;
        std::size_t taken = 0;
        while (bytes.size() - taken >= kLength &&
               bytes[taken] == static_cast<char>(Message::Progress)) {
            std::memcpy(&share, bytes.data() + taken + 1, sizeof share);
            if (progress)
                progress(share);
            taken += kLength;
        }
        bytes.erase(0, taken);
    }

    pid_t m_process;
    int m_pipe;
};

} // namespace

std::string runIsolated(const std::string& subject,
                        const std::function<std::string(const std::function<void(double)>&)>& work,
                        const IsolationLimits& limits, const std::function<void(double)>& progress,
                        const std::stop_token& stop)
{
    const auto fail = [&](IssueReason reason) {
        return Error(ErrorCode::FileUnreadable, subject, std::move(reason));
    };
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
        throw fail({IssueId::CannotRead, {std::strerror(errno)}}); // NOLINT(concurrency-mt-unsafe)
    const pid_t process = fork();
    if (process == 0)
        runCopy(subject, ends[1], work, limits);
    (void)close(ends[1]);
    if (process < 0) {
        (void)close(ends[0]);
        throw fail({IssueId::CannotRead, {std::strerror(errno)}}); // NOLINT(concurrency-mt-unsafe)
    }
    Copy copy(process, ends[0]);
    std::string bytes = copy.received(progress, stop);
    if (bytes.empty())
        throw fail({IssueId::Damaged});
    const std::string_view content = std::string_view(bytes).substr(1);
    if (bytes.front() == static_cast<char>(Message::Failure))
        throw errorFrom(content);
    return std::string(content);
}

} // namespace berg
