#pragma once

#include "core/plan/solve/cbc_wire.h"

#include <filesystem>
#include <functional>
#include <string>

namespace berg {

/** Asked about every 10 ms; true once the helper must end. */
using CbcCut = std::function<bool()>;

/**
 * Where `bergwatch-cbc` is: what the environment variable BERGWATCH_CBC names, else
 * libexec/bergwatch/bergwatch-cbc in a folder above that of this program. Throws
 * `Error{Unsupported}` when no program is there.
 */
[[nodiscard]] std::filesystem::path cbcHelperPath();

/**
 * The program `bergwatch-cbc` at work on one request. It shares nothing with this process but a
 * socket, so that whatever becomes of it is an outcome here. Ended by force when this object goes.
 */
class CbcHelper
{
public:
    /** Starts it. Throws `Error{Unsupported}` as `cbcHelperPath`, `CbcWireFault` when it does not
     * start. */
    CbcHelper();
    ~CbcHelper();
    CbcHelper(const CbcHelper&) = delete;
    CbcHelper& operator=(const CbcHelper&) = delete;

    /** Sends it the request; both tell their version first. False when cut. */
    [[nodiscard]] bool ask(const CbcFrame& request, const CbcCut& cut);
    /**
     * What it says next; none when cut. Throws `CbcWireFault` when it ended, was killed or says
     * what is no message; then nothing more comes of it.
     */
    [[nodiscard]] std::optional<CbcFrame> answer(const CbcCut& cut);

private:
    [[nodiscard]] bool send(std::string_view bytes, const CbcCut& cut) const;
    /** In words: a signal or an exit code. */
    [[nodiscard]] std::string howItEnded();

    int m_socket = -1;
    int m_process = -1;
    CbcFrameBuffer m_buffer;
};

} // namespace berg
