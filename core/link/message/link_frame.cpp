#include "core/link/message/link_frame.h"

#include "core/base/error.h"

#include <algorithm>

namespace berg {

namespace {

constexpr std::uint8_t kStart1 = 0xFE;
constexpr std::uint8_t kStart2 = 0xFD;
constexpr std::size_t kHeader1 = 6;
constexpr std::size_t kHeader2 = 10;
constexpr std::size_t kChecksumBytes = 2;
constexpr std::size_t kSignatureBytes = 13;
constexpr std::uint8_t kSignedFlag = 1;
constexpr std::size_t kMostKnownSenders = 256;

bool isStartByte(std::uint8_t byte)
{
    return byte == kStart1 || byte == kStart2;
}

/** Reads the 13-byte signature at the end of a signed frame. */
FrameSignature signatureOf(std::span<const std::uint8_t> bytes)
{
    FrameSignature signature{.linkId = bytes[0]};
    for (std::size_t i = 6; i > 0; --i)
        signature.time_10us = signature.time_10us << 8U | bytes[i];
    std::copy_n(bytes.begin() + 7, signature.tag.size(), signature.tag.begin());
    return signature;
}

} // namespace

std::uint16_t linkChecksum(std::span<const std::uint8_t> bytes, std::uint16_t crc)
{
    unsigned c = crc;
    for (std::uint8_t byte : bytes) {
        unsigned t = byte ^ (c & 0xFFU);
        t ^= (t << 4U) & 0xFFU;
        c = ((c >> 8U) ^ (t << 8U) ^ (t << 3U) ^ (t >> 4U)) & 0xFFFFU;
    }
    return static_cast<std::uint16_t>(c);
}

std::vector<std::uint8_t> frameBytes(const LinkMessage& message, LinkAddress sender,
                                     std::uint8_t sequence, std::uint8_t incompatFlags)
{
    const std::span<const std::uint8_t> full = message.payload();
    std::size_t length = full.size();
    while (length > 1 && full[length - 1] == 0)
        --length;
    const std::uint32_t id = message.spec().id;
    const auto byteOfId = [&](unsigned shift) {
        return static_cast<std::uint8_t>(id >> shift & 0xFFU);
    };
    const std::array<std::uint8_t, kHeader2> header{
        kStart2,          static_cast<std::uint8_t>(length),
        incompatFlags,    0,
        sequence,         sender.system,
        sender.component, byteOfId(0),
        byteOfId(8),      byteOfId(16)};
    std::vector<std::uint8_t> bytes(header.size() + length);
    std::copy(header.begin(), header.end(), bytes.begin());
    std::copy_n(full.begin(), length, bytes.begin() + kHeader2);
    const std::uint8_t extra = message.spec().crcExtra;
    const std::uint16_t crc =
        linkChecksum(std::span(&extra, 1), linkChecksum(std::span(bytes).subspan(1)));
    bytes.push_back(static_cast<std::uint8_t>(crc & 0xFFU));
    bytes.push_back(static_cast<std::uint8_t>(crc >> 8U));
    return bytes;
}

std::optional<std::size_t> announcedLength(std::span<const std::uint8_t> bytes)
{
    if (bytes.empty() || !isStartByte(bytes[0]))
        return std::nullopt;
    const bool isVersion2 = bytes[0] == kStart2;
    const std::size_t header = isVersion2 ? kHeader2 : kHeader1;
    if (bytes.size() < header)
        return std::nullopt;
    const bool isSigned = isVersion2 && (bytes[2] & kSignedFlag) != 0;
    return header + bytes[1] + kChecksumBytes + (isSigned ? kSignatureBytes : 0);
}

std::vector<LinkFrame> FrameParser::feed(std::span<const std::uint8_t> bytes)
{
    m_buffer.insert(m_buffer.end(), bytes.begin(), bytes.end());
    return parse(false);
}

std::vector<LinkFrame> FrameParser::feedDatagram(std::span<const std::uint8_t> bytes)
{
    require(m_buffer.empty(), "datagrams do not follow half a stream");
    m_buffer.assign(bytes.begin(), bytes.end());
    return parse(true);
}

std::vector<LinkFrame> FrameParser::finish()
{
    return parse(true);
}

std::vector<LinkFrame> FrameParser::parse(bool isAtEnd)
{
    std::vector<LinkFrame> frames;
    std::size_t at = 0;
    while (at < m_buffer.size()) {
        Candidate candidate = candidateAt(std::span(m_buffer).subspan(at), isAtEnd);
        if (candidate.kind == Candidate::Kind::NeedsMore) {
            if (!isAtEnd)
                break;
            candidate.kind = Candidate::Kind::Noise; // nothing can complete it
        }
        if (candidate.kind == Candidate::Kind::Noise)
            ++m_counts.noise_bytes;
        if (candidate.kind == Candidate::Kind::Frame) {
            ++m_counts.frames;
            m_counts.unknown += candidate.frame->message ? 0U : 1U;
            frames.push_back(std::move(*candidate.frame));
        }
        at += candidate.length;
    }
    m_buffer.erase(m_buffer.begin(), m_buffer.begin() + static_cast<std::ptrdiff_t>(at));
    return frames;
}

FrameParser::Candidate FrameParser::candidateAt(std::span<const std::uint8_t> bytes, bool isAtEnd)
{
    if (!isStartByte(bytes[0]))
        return {};
    const bool isVersion2 = bytes[0] == kStart2;
    const std::size_t header = isVersion2 ? kHeader2 : kHeader1;
    if (bytes.size() < header)
        return {.kind = Candidate::Kind::NeedsMore};

    LinkFrame frame{.version = isVersion2 ? 2 : 1};
    const std::uint8_t flags = isVersion2 ? bytes[2] : std::uint8_t{0};
    // From the sequence number on.
    const std::span<const std::uint8_t> ids = bytes.subspan(isVersion2 ? 4 : 2);
    frame.sequence = ids[0];
    frame.sender = {.system = ids[1], .component = ids[2]};
    frame.messageId =
        isVersion2 ? ids[3] | std::uint32_t{ids[4]} << 8U | std::uint32_t{ids[5]} << 16U : ids[3];

    const MessageSpec* spec = findMessage(frame.messageId);
    const std::size_t payload = bytes[1];
    const bool cannotBeFrame =
        spec != nullptr
            ? !isVersion2 && payload != spec->baseLength // version 1 is never shortened
            : (flags & ~kSignedFlag) != 0 ||
                  !std::binary_search(m_knownSenders.begin(), m_knownSenders.end(), frame.sender);
    if (cannotBeFrame)
        return {};
    const std::size_t length = *announcedLength(bytes);
    if (bytes.size() < length)
        return {.kind = Candidate::Kind::NeedsMore};
    frame.bytes.assign(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
    if ((flags & kSignedFlag) != 0)
        frame.signature = signatureOf(bytes.subspan(length - kSignatureBytes, kSignatureBytes));
    if (spec != nullptr)
        return checked(std::move(frame), *spec, bytes.subspan(header, payload), flags);

    if (bytes.size() == length && !isAtEnd)
        return {.kind = Candidate::Kind::NeedsMore};
    if (bytes.size() > length && !isStartByte(bytes[length]))
        return {};
    return {.kind = Candidate::Kind::Frame, .length = length, .frame = std::move(frame)};
}

FrameParser::Candidate FrameParser::checked(LinkFrame frame, const MessageSpec& spec,
                                            std::span<const std::uint8_t> payload,
                                            std::uint8_t flags)
{
    const std::size_t header = frame.version == 2 ? kHeader2 : kHeader1;
    const std::span<const std::uint8_t> covered =
        std::span<const std::uint8_t>(frame.bytes).subspan(1, header - 1 + payload.size());
    const std::uint16_t crc = linkChecksum(std::span(&spec.crcExtra, 1), linkChecksum(covered));
    const std::size_t at = header + payload.size();
    if (frame.bytes[at] != (crc & 0xFFU) || frame.bytes[at + 1] != crc >> 8U) {
        ++m_counts.badChecksums;
        return {};
    }
    const std::size_t length = frame.bytes.size();
    if ((flags & ~kSignedFlag) != 0) {
        ++m_counts.unknownFlags;
        return {.kind = Candidate::Kind::Dropped, .length = length};
    }
    const auto place = std::lower_bound(m_knownSenders.begin(), m_knownSenders.end(), frame.sender);
    if ((place == m_knownSenders.end() || *place != frame.sender) &&
        m_knownSenders.size() < kMostKnownSenders)
        m_knownSenders.insert(place, frame.sender);
    frame.message.emplace(spec, payload);
    return {.kind = Candidate::Kind::Frame, .length = length, .frame = std::move(frame)};
}

} // namespace berg
