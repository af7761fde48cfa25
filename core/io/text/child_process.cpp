#include "core/io/text/child_process.h"

#include "core/base/stopped.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <string_view>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace berg {

namespace {

constexpr int kChildCheck_ms = 10;
constexpr std::size_t kMostChildErrors = 4096;
constexpr int kCannotExecute = 127;

[[noreturn]] void failChild(const char* what)
{
    throw std::system_error(errno, std::generic_category(), what);
}

/** Reading end of a pipe that does not block, and the writing end for the child. */
class ChildPipe
{
public:
    ChildPipe()
    {
        if (pipe2(m_ends.data(), O_CLOEXEC) != 0)
            failChild("pipe");
        fcntl(m_ends[0], F_SETFL, O_NONBLOCK);
    }
    ChildPipe(const ChildPipe&) = delete;
    ChildPipe& operator=(const ChildPipe&) = delete;
    ~ChildPipe()
    {
        closeEnd(0);
        closeEnd(1);
    }

    [[nodiscard]] int reader() const { return m_ends[0]; }
    [[nodiscard]] int writer() const { return m_ends[1]; }
    void closeWriter() { closeEnd(1); }

    /** Appends what can be read now. */
    void readInto(std::string& text)
    {
        std::array<char, 1U << 16U> piece{};
        while (m_ends[0] >= 0) {
            const ssize_t got = read(m_ends[0], piece.data(), piece.size());
            if (got > 0)
                text.append(piece.data(), static_cast<std::size_t>(got));
            else if (got == 0)
                closeEnd(0);
            if (got < static_cast<ssize_t>(piece.size()))
                return; // the rest may follow; limits are checked first
            if (text.size() > kAtOnce)
                return;
        }
    }

private:
    static constexpr std::size_t kAtOnce = 1U << 20U;

    void closeEnd(std::size_t end)
    {
        if (m_ends[end] >= 0)
            close(m_ends[end]);
        m_ends[end] = -1;
    }

    std::array<int, 2> m_ends{-1, -1};
};

std::vector<char*> pointersTo(std::vector<std::string>& texts)
{
    std::vector<char*> pointers;
    for (std::string& text : texts)
        pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
}

void limitTo(decltype(RLIMIT_AS) resource, rlim_t most)
{
    const rlimit limit{.rlim_cur = most, .rlim_max = most};
    setrlimit(resource, &limit);
}

/** Everything that the child needs after the fork, where it may not allocate memory. */
struct PreparedChild
{
    explicit PreparedChild(const ChildCommand& command)
        : program(command.program.string())
        , folder(command.folder.string())
        , arguments(command.arguments)
        , environment(command.environment)
    {
        arguments.insert(arguments.begin(), program);
        argumentPointers = pointersTo(arguments);
        environmentPointers = pointersTo(environment);
    }

    /** Becomes the program; uses only functions that are safe after a fork. */
    [[noreturn]] void become(int input, int output, int errors, const ChildLimits& limits,
                             pid_t parent) const
    {
        setpgid(0, 0);
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        sigset_t none;
        sigemptyset(&none);
        sigprocmask(SIG_SETMASK, &none, nullptr);
        for (const int number : {SIGPIPE, SIGINT, SIGTERM, SIGHUP})
            signal(number, SIG_DFL);
        limitTo(RLIMIT_AS, limits.memory);
        limitTo(RLIMIT_CPU, static_cast<rlim_t>(limits.cpu.count()));
        limitTo(RLIMIT_FSIZE, limits.fileSize);
        limitTo(RLIMIT_CORE, 0);
        const bool isReady = getppid() == parent && dup2(input, STDIN_FILENO) >= 0 &&
                             dup2(output, STDOUT_FILENO) >= 0 && dup2(errors, STDERR_FILENO) >= 0 &&
                             chdir(folder.c_str()) == 0;
        if (isReady)
            execve(program.c_str(), argumentPointers.data(), environmentPointers.data());
        _exit(kCannotExecute);
    }

    std::string program;
    std::string folder;
    std::vector<std::string> arguments;
    std::vector<std::string> environment;
    std::vector<char*> argumentPointers;
    std::vector<char*> environmentPointers;
};

/** A child process with its group, which is killed and waited for at the end. */
class ChildGroup
{
public:
    ChildGroup(const PreparedChild& prepared, int output, int errors, const ChildLimits& limits)
    {
        const int input = open("/dev/null", O_RDONLY | O_CLOEXEC);
        if (input < 0)
            failChild("/dev/null");
        const pid_t parent = getpid();
        m_process = fork();
        if (m_process == 0)
            prepared.become(input, output, errors, limits, parent);
        const int error = errno;
        close(input);
        errno = error;
        if (m_process < 0)
            failChild("fork");
        setpgid(m_process, m_process); // whichever of the two comes first
    }
    ChildGroup(const ChildGroup&) = delete;
    ChildGroup& operator=(const ChildGroup&) = delete;
    ~ChildGroup() { end(); }

    /** Whether the program has ended; it is not waited for, so that its group stays known. */
    [[nodiscard]] bool hasEnded() const
    {
        siginfo_t info{};
        return waitid(P_PID, static_cast<id_t>(m_process), &info, WEXITED | WNOHANG | WNOWAIT) ==
                   0 &&
               info.si_pid == m_process;
    }

    /** Kills the group and returns the status of the program. */
    int end()
    {
        int status = 0;
        if (m_process <= 0)
            return status;
        kill(-m_process, SIGKILL);
        kill(m_process, SIGKILL); // if it had no time to form its group
        while (waitpid(m_process, &status, 0) < 0 && errno == EINTR) {
        }
        m_process = -1;
        return status;
    }

private:
    pid_t m_process = -1;
};

void shortenErrors(std::string& errors)
{
    if (errors.size() > kMostChildErrors)
        errors.erase(0, errors.size() - kMostChildErrors);
}

} // namespace

ChildResult runChild(const ChildCommand& command, const ChildLimits& limits,
                     const std::stop_token& stop)
{
    using Clock = std::chrono::steady_clock;
    throwIfStopped(stop);
    const PreparedChild prepared(command);
    ChildPipe output;
    ChildPipe errors;
    const Clock::time_point end = Clock::now() + limits.wall;
    ChildGroup child(prepared, output.writer(), errors.writer(), limits);
    output.closeWriter();
    errors.closeWriter();
    ChildResult result;
    for (bool hasEnded = false; !hasEnded;) {
        throwIfStopped(stop);
        std::array<pollfd, 2> wait{{{.fd = output.reader(), .events = POLLIN, .revents = 0},
                                    {.fd = errors.reader(), .events = POLLIN, .revents = 0}}};
        poll(wait.data(), wait.size(), kChildCheck_ms);
        hasEnded = child.hasEnded(); // what it wrote before is in the pipes
        for (std::size_t before = 0, now = 1; before != now;) {
            before = result.output.size();
            output.readInto(result.output);
            now = hasEnded && result.output.size() <= limits.output ? result.output.size() : before;
        }
        errors.readInto(result.errors);
        shortenErrors(result.errors);
        if (result.output.size() > limits.output) {
            child.end();
            result.end = ChildResult::End::TooMuchOutput;
            result.output.clear();
            return result;
        }
        if (!hasEnded && Clock::now() >= end) {
            child.end();
            result.end = ChildResult::End::TooSlow;
            result.output.clear();
            return result;
        }
    }
    const int status = child.end();
    const bool isSignalled = WIFSIGNALED(status);
    result.end = isSignalled ? ChildResult::End::Signalled : ChildResult::End::Exited;
    result.code = isSignalled ? WTERMSIG(status) : WEXITSTATUS(status);
    return result;
}

} // namespace berg
