#pragma once

#include "core/link/message/link_frame.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace berg {

/** Secret shared by both ends of a signed link. */
using SigningKey = std::array<std::uint8_t, 32>;

/** Returns the time stamp of a signature for microseconds since 1970; 0 before 2015. */
[[nodiscard]] std::uint64_t signingTime_10us(std::int64_t unix_us);

/** Numbers the frames of one sender, and signs them if it has a key. */
class FrameWriter
{
public:
    /** Without a `key` frames are not signed. `linkId` distinguishes links of one sender. */
    explicit FrameWriter(LinkAddress sender, std::optional<SigningKey> key = std::nullopt,
                         std::uint8_t linkId = 0);

    /** Returns the next frame. The time stamp of its signature is later than the previous one. */
    [[nodiscard]] std::vector<std::uint8_t> write(const LinkMessage& message, std::int64_t unix_us);

    [[nodiscard]] LinkAddress sender() const { return m_sender; }

private:
    LinkAddress m_sender;
    std::optional<SigningKey> m_key;
    std::uint8_t m_linkId;
    std::uint8_t m_sequence = 0;
    std::uint64_t m_lastTime_10us = 0;
};

/** Result of checking a frame's signature. */
enum class SignatureVerdict
{
    Unsigned,
    NoKey, ///< Signed, but there is no key to check the signature.
    Valid,
    WrongTag,
    TooOld, ///< Replayed frame, or a wrong clock.
    TooManyStreams
};

/** Checks signatures and remembers the newest time stamp of each stream. */
class SignatureChecker
{
public:
    explicit SignatureChecker(std::optional<SigningKey> key) : m_key(key) {}

    /**
     * Checks the next received frame. Time stamps of a stream (sender and link id) must increase; a
     * new stream may lag the newest signature by a minute. At most 256 streams are remembered.
     */
    [[nodiscard]] SignatureVerdict check(const LinkFrame& frame);

private:
    struct Stream
    {
        LinkAddress sender;
        std::uint8_t linkId = 0;
        // NOLINTNEXTLINE(modernize-use-nullptr): false alarm of clang-tidy 14
        auto operator<=>(const Stream&) const = default;
    };

    std::optional<SigningKey> m_key;
    std::map<Stream, std::uint64_t> m_lastTimes_10us;
    std::uint64_t m_newest_10us = 0;
};

} // namespace berg
