// bergwatch-cbc: solves one problem for Bergwatch with COIN-OR CBC and ends. A program of its own,
// so that CBC's licence, its crashes and its memory stay here. It is not for use by hand: its
// standard input is the socket of `CbcHelper`, over which `cbc_wire.h` is spoken.

#include "core/cbc/cbc_partition.h"
#include "core/cbc/cbc_search.h"
#include "core/plan/solve/cbc_wire.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <sys/resource.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace {

using namespace berg;

constexpr int kSocket = STDIN_FILENO;

/** The asker has gone: so has all reason to go on. */
[[noreturn]] void endAtOnce()
{
    _exit(1);
}

void say(const CbcFrame& frame)
{
    const std::string bytes = cbcBytes(frame);
    for (std::string_view rest = bytes; !rest.empty();) {
        const ssize_t sent = send(kSocket, rest.data(), rest.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno != EINTR)
            endAtOnce();
        rest.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(0, sent)));
    }
}

CbcFrame heard(CbcFrameBuffer& buffer)
{
    std::array<char, 65536> bytes; // NOLINT(cppcoreguidelines-pro-type-member-init): written first
    while (true) {
        if (std::optional<CbcFrame> frame = buffer.nextFrame())
            return *frame;
        const ssize_t count = recv(kSocket, bytes.data(), bytes.size(), 0);
        if (count == 0 || (count < 0 && errno != EINTR))
            endAtOnce();
        buffer.add({bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(0, count))});
    }
}

/** Nothing more is said after the request: whatever comes is the end of the asker. */
void endWithTheAsker()
{
    std::thread([] {
        char byte = 0;
        while (recv(kSocket, &byte, 1, 0) != 0) {
        }
        endAtOnce();
    }).detach();
}

/** Beyond it the system gives no more; the sanitizers reserve more than any limit. */
void limitMemory([[maybe_unused]] const std::optional<std::int64_t>& most_bytes)
{
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    constexpr rlim_t kOwn_bytes = 400'000'000; // libraries and stacks, mostly never touched
    if (!most_bytes)
        return;
    const rlim_t limit_bytes =
        static_cast<rlim_t>(std::max<std::int64_t>(0, *most_bytes)) + kOwn_bytes;
    const rlimit limit{.rlim_cur = limit_bytes, .rlim_max = limit_bytes};
    setrlimit(RLIMIT_AS, &limit);
#endif
}

CbcFrame answerTo(const CbcFrame& request)
{
    if (request.kind == CbcFrameKind::Partition) {
        limitMemory(SolveOptions().memoryLimit_bytes);
        return cbcFrame(bestPartition(cbcPartitionOf(request)));
    }
    CbcProblem asked = cbcProblemOf(request);
    limitMemory(asked.options.memoryLimit_bytes);
    asked.options.onProgress = [](const SolveProgress& progress) { say(cbcFrame(progress)); };
    return cbcFrame(searchByCbc(asked.problem, asked.formulation, asked.options));
}

} // namespace

int main(int argc, char* argv[])
{
    if (argc > 1 || isatty(kSocket) != 0) {
        std::fprintf(stderr, "%s: works for Bergwatch alone; run bergwatch or bergwatch-cli\n",
                     argv[0]);
        return 2;
    }
    CbcFrameBuffer buffer;
    try {
        say(cbcHello());
        requireCbcHello(heard(buffer));
        const CbcFrame request = heard(buffer);
        endWithTheAsker();
        say(answerTo(request));
    } catch (const Error& error) {
        say(cbcFrame(CbcFailure{std::string(error.what()).substr(error.subject().size() + 2)}));
    } catch (const std::bad_alloc&) {
        say(cbcFrame(CbcFailure{"CBC has run out of memory", true}));
    } catch (const std::exception& fault) {
        say(cbcFrame(CbcFailure{fault.what()}));
    }
    _exit(0); // not through destructors: another thread waits for the asker
}
