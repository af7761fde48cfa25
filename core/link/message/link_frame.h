#pragma once

#include "core/link/message/link_message.h"

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace berg {

/** Address of a component of a system. In a target, 0 means all of them. */
struct LinkAddress
{
    std::uint8_t system = 0;
    std::uint8_t component = 0;
    // NOLINTNEXTLINE(modernize-use-nullptr): false alarm of clang-tidy 14
    auto operator<=>(const LinkAddress&) const = default;
};

/** Signature at the end of a signed frame. */
struct FrameSignature
{
    std::uint8_t linkId = 0;
    std::uint64_t time_10us = 0; ///< Units of 10 us since 2015-01-01 00:00 UTC, 48 bits.
    std::array<std::uint8_t, 6> tag{};
    bool operator==(const FrameSignature&) const = default;
};

/** One frame as received. */
struct LinkFrame
{
    int version = 2; ///< Protocol version, 1 or 2.
    std::uint8_t sequence = 0;
    LinkAddress sender;
    std::uint32_t messageId = 0;
    /** Nullopt if Bergwatch does not know the message; its checksum is then unchecked. */
    std::optional<LinkMessage> message;
    std::optional<FrameSignature> signature; ///< Nullopt if the frame is not signed.
    std::vector<std::uint8_t> bytes;         ///< The complete frame.
};

/** Returns the CRC-16/MCRF4XX of `bytes`, continued from `crc`. */
[[nodiscard]] std::uint16_t linkChecksum(std::span<const std::uint8_t> bytes,
                                         std::uint16_t crc = 0xFFFF);

/**
 * Returns a MAVLink 2 frame without signature. Trailing zeros of the payload are removed, except
 * its first byte. `incompatFlags` goes into the frame: 1 announces a signature, which the caller
 * must append.
 */
[[nodiscard]] std::vector<std::uint8_t> frameBytes(const LinkMessage& message, LinkAddress sender,
                                                   std::uint8_t sequence,
                                                   std::uint8_t incompatFlags = 0);

/**
 * Returns the length in bytes announced by the header at the start of `bytes`, checksum and
 * signature included, or nullopt if `bytes` do not begin with a complete header.
 */
[[nodiscard]] std::optional<std::size_t> announcedLength(std::span<const std::uint8_t> bytes);

/** Statistics of a parser. */
struct ParserCounts
{
    std::uint64_t frames = 0;       ///< Frames returned, unknown messages included.
    std::uint64_t unknown = 0;      ///< Frames returned without a message.
    std::uint64_t badChecksums = 0; ///< Known messages with a wrong checksum.
    std::uint64_t unknownFlags = 0; ///< Dropped for an incompatibility flag other than "signed".
    std::uint64_t noise_bytes = 0;  ///< Bytes that belong to no frame.
};

/**
 * Finds frames of MAVLink 2 and 1 in a stream of bytes with anything in between. After a wrong
 * checksum the search continues at the next byte, so noise cannot hide a frame. A message missing
 * in the table cannot be checked: it counts as a frame only if its sender has sent a checked frame
 * before and a start byte (or the end of a datagram) follows. Memory: one frame more than the bytes
 * fed at a time. Single-threaded.
 */
class FrameParser
{
public:
    /** Processes bytes of a stream and returns the frames that they complete, in order. */
    [[nodiscard]] std::vector<LinkFrame> feed(std::span<const std::uint8_t> bytes);
    /**
     * Processes a complete datagram; a frame never spans two. Throws `std::logic_error` after a
     * stream that ended inside a frame.
     */
    [[nodiscard]] std::vector<LinkFrame> feedDatagram(std::span<const std::uint8_t> bytes);
    /** Ends the stream: the beginning of an incomplete frame is searched for other frames. */
    [[nodiscard]] std::vector<LinkFrame> finish();

    [[nodiscard]] const ParserCounts& counts() const { return m_counts; }

private:
    /** Interpretation of the bytes at a start byte. */
    struct Candidate
    {
        enum class Kind
        {
            NeedsMore,
            Noise,   ///< One byte is skipped.
            Dropped, ///< The whole frame is skipped.
            Frame
        };
        Kind kind = Kind::Noise;
        std::size_t length = 1; ///< Bytes to skip.
        std::optional<LinkFrame> frame;
    };

    [[nodiscard]] std::vector<LinkFrame> parse(bool isAtEnd);
    [[nodiscard]] Candidate candidateAt(std::span<const std::uint8_t> bytes, bool isAtEnd);
    [[nodiscard]] Candidate checked(LinkFrame frame, const MessageSpec& spec,
                                    std::span<const std::uint8_t> payload, std::uint8_t flags);

    std::vector<std::uint8_t> m_buffer;
    std::vector<LinkAddress> m_knownSenders; ///< Senders of checked frames; sorted, bounded.
    ParserCounts m_counts;
};

} // namespace berg
