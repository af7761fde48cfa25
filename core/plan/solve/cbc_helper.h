#pragma once

#include "core/plan/solve/cbc_wire.h"

#include <filesystem>
#include <functional>
#include <string>

namespace berg {

/** Called about every 10 ms; returns true once the helper must end. Must not be empty. */
using CbcStopCheck = std::function<bool()>;

/**
 * Returns the path of `bergwatch-cbc`: the value of the environment variable BERGWATCH_CBC, else
 * libexec/bergwatch/bergwatch-cbc in a folder above that of this program. Throws
 * `Error{Unsupported}` if there is no program.
 */
[[nodiscard]] std::filesystem::path cbcHelperPath();

/**
 * A process of the program `bergwatch-cbc` for one request. It shares nothing with this process but
 * a socket, so that its failure is an outcome here. The destructor kills it.
 */
class CbcHelper
{
public:
    /**
     * Starts the process. Throws `Error{Unsupported}` as `cbcHelperPath` does, and `CbcWireFault`
     * if it does not start.
     */
    CbcHelper();
    ~CbcHelper();
    CbcHelper(const CbcHelper&) = delete;
    CbcHelper& operator=(const CbcHelper&) = delete;

    /**
     * Sends the version and the request, and waits for the other side's version. Returns false if
     * stopped. Throws `CbcWireFault` as `answer` does, and if the versions differ.
     */
    [[nodiscard]] bool sendRequest(const CbcFrame& request, const CbcStopCheck& isStopped);
    /**
     * Returns the next message, or nullopt if stopped. Throws `CbcWireFault` if the process ended,
     * was killed or sent something that is not a message; it then sends nothing more.
     */
    [[nodiscard]] std::optional<CbcFrame> answer(const CbcStopCheck& isStopped);

private:
    [[nodiscard]] bool send(std::string_view bytes, const CbcStopCheck& isStopped) const;
    /** Describes in words how the process ended: by a signal or with an exit code. */
    [[nodiscard]] std::string exitDescription();

    int m_socket = -1;
    int m_process = -1;
    CbcFrameBuffer m_buffer;
};

} // namespace berg
