#include "core/plan/solve/cbc_helper.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

extern char** environ; // NOLINT(readability-redundant-declaration): POSIX leaves it to the program

namespace berg {

namespace {

constexpr int kCheckEvery_ms = 10;

/** Waits until the socket is ready for `events`, or until the next check for a stop. */
bool isReady(int socket, short events)
{
    pollfd wait{.fd = socket, .events = events, .revents = 0};
    return poll(&wait, 1, kCheckEvery_ms) > 0;
}

[[noreturn]] void cannotStart(int error)
{
    throw CbcWireFault("it cannot start: " + std::generic_category().message(error));
}

/**
 * Starts the program with its standard input on the socket and without output. Returns the process,
 * or the negative error number.
 */
int started(const std::filesystem::path& program, int socket)
{
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, socket, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
    std::string name = program.string();
    std::array<char*, 2> arguments{name.data(), nullptr};
    pid_t process = -1;
    const int error =
        posix_spawn(&process, name.c_str(), &files, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    return error == 0 ? process : -error;
}

} // namespace

std::filesystem::path cbcHelperPath()
{
    std::error_code error;
    // NOLINTNEXTLINE(concurrency-mt-unsafe): nothing here sets the environment
    if (const char* named = std::getenv("BERGWATCH_CBC"); named != nullptr && *named != 0) {
        if (access(named, X_OK) == 0)
            return named;
        throw Error(ErrorCode::Unsupported, "planner.backend", {IssueId::CbcMissing, {named}});
    }
    const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe", error);
    for (std::filesystem::path folder = own.parent_path(); folder != folder.root_path();
         folder = folder.parent_path()) {
        std::filesystem::path program = folder / "libexec/bergwatch/bergwatch-cbc";
        if (access(program.c_str(), X_OK) == 0)
            return program;
    }
    throw Error(ErrorCode::Unsupported, "planner.backend",
                {IssueId::CbcMissing, {"bergwatch-cbc"}});
}

CbcHelper::CbcHelper()
{
    const std::filesystem::path program = cbcHelperPath();
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, ends.data()) != 0)
        cannotStart(errno);
    // The helper's end of the socket blocks: the flag belongs to the end, not to the pair.
    fcntl(ends[1], F_SETFL, fcntl(ends[1], F_GETFL) & ~O_NONBLOCK);
    m_process = started(program, ends[1]);
    close(ends[1]);
    m_socket = ends[0];
    if (m_process < 0) {
        close(m_socket);
        cannotStart(-m_process);
    }
}

CbcHelper::~CbcHelper()
{
    close(m_socket);
    if (m_process > 0) {
        kill(m_process, SIGKILL);
        while (waitpid(m_process, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
}

bool CbcHelper::send(std::string_view bytes, const CbcStopCheck& isStopped) const
{
    while (!bytes.empty()) {
        if (isStopped())
            return false;
        if (!isReady(m_socket, POLLOUT))
            continue;
        // Without SIGPIPE, `answer` detects an early end and its reason.
        const ssize_t sent = ::send(m_socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent > 0)
            bytes.remove_prefix(static_cast<std::size_t>(sent));
        else if (errno != EAGAIN && errno != EINTR)
            return true;
    }
    return true;
}

bool CbcHelper::sendRequest(const CbcFrame& request, const CbcStopCheck& isStopped)
{
    if (!send(cbcBytes(cbcHello()) + cbcBytes(request), isStopped))
        return false;
    const std::optional<CbcFrame> hello = answer(isStopped);
    if (hello)
        requireCbcHello(*hello);
    return hello.has_value();
}

std::optional<CbcFrame> CbcHelper::answer(const CbcStopCheck& isStopped)
{
    std::array<char, 65536> bytes; // NOLINT(cppcoreguidelines-pro-type-member-init): written first
    while (true) {
        if (std::optional<CbcFrame> frame = m_buffer.nextFrame())
            return frame;
        if (isStopped())
            return std::nullopt;
        if (!isReady(m_socket, POLLIN))
            continue;
        const ssize_t count = recv(m_socket, bytes.data(), bytes.size(), 0);
        if (count > 0)
            m_buffer.add({bytes.data(), static_cast<std::size_t>(count)});
        else if (count == 0 || (errno != EAGAIN && errno != EINTR))
            throw CbcWireFault(exitDescription());
    }
}

std::string CbcHelper::exitDescription()
{
    // The helper has closed its end: it is about to exit, or has stopped answering.
    constexpr int kTries = 100;
    int status = 0;
    for (int i = 0; i < kTries; ++i) {
        if (waitpid(m_process, &status, WNOHANG) == m_process) {
            m_process = -1;
            if (WIFSIGNALED(status)) {
                const char* description = sigdescr_np(WTERMSIG(status));
                return "it was ended by signal " + std::to_string(WTERMSIG(status)) +
                       (description != nullptr ? std::string(" (") + description + ')' : "");
            }
            return "it ended with exit code " + std::to_string(WEXITSTATUS(status));
        }
        poll(nullptr, 0, kCheckEvery_ms);
    }
    return "it stopped answering";
}

} // namespace berg
