#include "core/link/message/frame_signing.h"

#include "core/base/sha256.h"

#include <algorithm>

namespace berg {

namespace {

constexpr std::int64_t kSigningEpoch_us = 1'420'070'400'000'000; ///< 2015-01-01 00:00 UTC
constexpr std::uint64_t kNewStreamMayLag_10us = 6'000'000;       ///< a minute
constexpr std::size_t kMostStreams = 256;
constexpr std::size_t kTagBytes = 6;

/** Returns the first bytes of the digest of the key and `signedBytes` (frame, link id and time). */
std::array<std::uint8_t, kTagBytes> tagOf(const SigningKey& key,
                                          std::span<const std::uint8_t> signedBytes)
{
    std::vector<std::uint8_t> text(key.begin(), key.end());
    text.insert(text.end(), signedBytes.begin(), signedBytes.end());
    const std::array<std::uint8_t, 32> digest = sha256(text);
    std::array<std::uint8_t, kTagBytes> tag{};
    std::copy_n(digest.begin(), tag.size(), tag.begin());
    return tag;
}

} // namespace

std::uint64_t signingTime_10us(std::int64_t unix_us)
{
    return static_cast<std::uint64_t>(std::max<std::int64_t>(unix_us - kSigningEpoch_us, 0) / 10);
}

FrameWriter::FrameWriter(LinkAddress sender, std::optional<SigningKey> key, std::uint8_t linkId)
    : m_sender(sender), m_key(key), m_linkId(linkId)
{
}

std::vector<std::uint8_t> FrameWriter::write(const LinkMessage& message, std::int64_t unix_us)
{
    std::vector<std::uint8_t> bytes =
        frameBytes(message, m_sender, m_sequence++, m_key ? std::uint8_t{1} : std::uint8_t{0});
    if (m_key) {
        m_lastTime_10us = std::max(signingTime_10us(unix_us), m_lastTime_10us + 1);
        bytes.push_back(m_linkId);
        for (unsigned shift = 0; shift < 48; shift += 8)
            bytes.push_back(static_cast<std::uint8_t>(m_lastTime_10us >> shift & 0xFFU));
        const std::array<std::uint8_t, kTagBytes> tag = tagOf(*m_key, bytes);
        bytes.insert(bytes.end(), tag.begin(), tag.end());
    }
    return bytes;
}

SignatureVerdict SignatureChecker::check(const LinkFrame& frame)
{
    if (!frame.signature)
        return SignatureVerdict::Unsigned;
    if (!m_key)
        return SignatureVerdict::NoKey;
    const std::span<const std::uint8_t> covered =
        std::span(frame.bytes).first(frame.bytes.size() - kTagBytes);
    if (tagOf(*m_key, covered) != frame.signature->tag)
        return SignatureVerdict::WrongTag;

    const std::uint64_t time_10us = frame.signature->time_10us;
    const Stream stream{.sender = frame.sender, .linkId = frame.signature->linkId};
    const auto last = m_lastTimes_10us.find(stream);
    if (last == m_lastTimes_10us.end()) {
        if (time_10us + kNewStreamMayLag_10us < m_newest_10us)
            return SignatureVerdict::TooOld;
        if (m_lastTimes_10us.size() >= kMostStreams)
            return SignatureVerdict::TooManyStreams;
    } else if (time_10us <= last->second) {
        return SignatureVerdict::TooOld;
    }
    m_lastTimes_10us[stream] = time_10us;
    m_newest_10us = std::max(m_newest_10us, time_10us);
    return SignatureVerdict::Valid;
}

} // namespace berg
