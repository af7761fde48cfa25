#include "core/link/nmea/nmea_reader.h"

#include "core/base/angles.h"
#include "core/geometry/geometry.h"
#include "core/link/nmea/ais_message.h"
#include "core/link/nmea/nmea_fields.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>

namespace berg {

namespace {

constexpr std::size_t kLongestLine = 256; ///< The standard allows 82, receivers send more.
constexpr std::size_t kMostWaiting = 1000;
constexpr std::size_t kMostParts = 32;
constexpr std::size_t kMostNames = 500;
constexpr double kShipKept_s = 60; ///< An own position places radar targets for this time.
constexpr double kDay_s = 86'400;
constexpr double kFarthestTarget_m = 200'000;
constexpr std::int64_t kSecond_us = 1'000'000;

constexpr std::array<std::string_view, 10> kUsedSentences{"GGA", "RMC", "VTG", "HDT", "THS",
                                                          "ZDA", "TLL", "TTM", "VDM", "VDO"};

/** Returns the start of the last sentence of a line: skips noise and a multiplexer's tag block. */
std::size_t sentenceStart(std::string_view line)
{
    const std::size_t dollar = line.rfind('$');
    const std::size_t mark = line.rfind('!'); // also a character of texts
    const bool isAis = mark != std::string_view::npos && line.size() > mark + 6 &&
                       line.substr(mark + 3, 2) == "VD";
    return isAis && (dollar == std::string_view::npos || mark > dollar) ? mark : dollar;
}

std::optional<std::uint32_t> numberOf(std::string_view text, std::uint32_t limit)
{
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool isRead = error == std::errc() && end == text.data() + text.size();
    return isRead && value <= limit ? std::optional(value) : std::nullopt;
}

/** Returns metres in a unit of distance: nautical miles, statute miles, kilometres. */
std::optional<double> metresIn(std::string_view unit)
{
    if (unit == "N" || unit == "K" || unit == "S")
        return unit == "N" ? 1852.0 : unit == "K" ? 1000.0 : 1609.344;
    return std::nullopt;
}

} // namespace

std::vector<NmeaFix> NmeaReader::feed(std::span<const std::uint8_t> bytes)
{
    std::vector<NmeaFix> fixes;
    for (std::uint8_t byte : bytes) {
        if (byte == '\n') {
            endLine(fixes);
            ++m_number;
        } else if (byte == '\r') {
            endLine(fixes);
        } else {
            m_isTooLong = m_isTooLong || m_line.size() >= kLongestLine;
            if (!m_isTooLong)
                m_line.push_back(static_cast<char>(byte));
        }
    }
    return fixes;
}

std::vector<NmeaFix> NmeaReader::finish()
{
    std::vector<NmeaFix> fixes;
    endLine(fixes);
    for (const auto& [key, parts] : m_parts)
        drop(parts);
    m_parts.clear();
    return fixes;
}

void NmeaReader::endLine(std::vector<NmeaFix>& fixes)
{
    if (m_isTooLong) {
        ++m_counts.others;
        fail(NmeaFault::NoSentence, m_number);
    } else if (!m_line.empty() && m_line.front() != '#') { // a comment of a log
        if (std::optional<NmeaFix> fix = fixOf(m_line)) {
            ++m_counts.fixes;
            fixes.push_back(std::move(*fix));
        }
    }
    m_line.clear();
    m_isTooLong = false;
}

void NmeaReader::fail(NmeaFault fault, std::uint64_t line)
{
    if (m_findings.size() < kMostWaiting)
        m_findings.push_back({.line = line, .fault = fault});
}

void NmeaReader::drop(const Parts& parts)
{
    for (const std::uint64_t line : parts.lines) {
        ++m_counts.badParts;
        fail(NmeaFault::AisPart, line);
    }
}

void NmeaReader::add(NmeaTarget target)
{
    ++m_counts.targets;
    target.line = m_number;
    if (m_targets.size() < kMostWaiting)
        m_targets.push_back(std::move(target));
}

std::optional<NmeaFix> NmeaReader::fixOf(std::string_view line)
{
    const std::size_t start = sentenceStart(line);
    if (start == std::string_view::npos || line.size() < start + 7) {
        ++m_counts.others;
        fail(NmeaFault::NoSentence, m_number);
        return std::nullopt;
    }
    const std::size_t star = line.rfind('*');
    const bool hasStar = star != std::string_view::npos && star > start;
    const std::string_view content =
        line.substr(start + 1, hasStar ? star - start - 1 : std::string_view::npos);
    const std::string_view sentence = line.substr(start + 3, 3);
    const bool isUsed = std::ranges::find(kUsedSentences, sentence) != kUsedSentences.end();
    if (!hasNmeaChecksum(line.substr(start), content)) {
        ++(isUsed ? m_counts.badChecksums : m_counts.others);
        fail(NmeaFault::Checksum, m_number);
        return std::nullopt;
    }
    if (const std::optional<std::int64_t> time_us = nmeaTagTime(line.substr(0, start)))
        m_clock_us = time_us;
    if (!isUsed) {
        ++m_counts.others;
        return std::nullopt;
    }
    const std::vector<std::string_view> fields = nmeaFields(content);
    if (sentence == "GGA" || sentence == "RMC" || sentence == "VTG")
        return ownFix(fields);
    if (sentence == "TLL" || sentence == "TTM")
        readRadar(fields);
    else if (sentence == "VDM" || sentence == "VDO")
        readAis(fields);
    else
        readTime(fields);
    return std::nullopt;
}

std::optional<NmeaFix> NmeaReader::ownFix(std::span<const std::string_view> fields)
{
    const std::string_view content = fields[0];
    const std::string_view sentence = content.substr(2, 3);
    NmeaFix fix{.talker = std::string(content.substr(0, 2)), .sentence = std::string(sentence)};
    bool isFix = true;
    bool isRead = false;
    if (sentence == "GGA" && fields.size() >= 10) {
        isFix = fields[6] != "0" && !fields[6].empty();
        fix.place = nmeaPlace(fields.subspan(2, 4));
        fix.timeOfDay_s = nmeaTimeOfDay(fields[1]);
        fix.altitude_m = nmeaNumber(fields[9], -1000, 100'000);
        isRead = fix.place.has_value();
    } else if (sentence == "RMC" && fields.size() >= 10) {
        isFix = fields[2] == "A";
        fix.place = nmeaPlace(fields.subspan(3, 4));
        fix.timeOfDay_s = nmeaTimeOfDay(fields[1]);
        fix.unix_us = nmeaUnixTime(fields[9], fix.timeOfDay_s);
        fix.speed_mps = nmeaSpeed(fields[7]);
        fix.course_deg = nmeaNumber(fields[8], 0, 360);
        isRead = fix.place.has_value();
    } else if (sentence == "VTG" && fields.size() >= 9) {
        isFix = fields.size() < 10 || fields[9] != "N";
        fix.course_deg = nmeaNumber(fields[1], 0, 360);
        fix.speed_mps = nmeaSpeed(fields[5]);
        isRead = fix.speed_mps.has_value();
    }
    if (!isFix) {
        ++m_counts.withoutFix;
        return std::nullopt;
    }
    if (!isRead) {
        ++m_counts.malformed;
        fail(NmeaFault::Fields, m_number);
        return std::nullopt;
    }
    if (fix.place) {
        m_ship.place = fix.place;
        m_ship.time_s = fix.timeOfDay_s;
    }
    if (const auto time_us = fix.unix_us ? fix.unix_us : dated(fix.timeOfDay_s))
        m_clock_us = time_us;
    return fix;
}

/** Reads the date (ZDA) or the own heading (HDT, THS). */
void NmeaReader::readTime(std::span<const std::string_view> fields)
{
    if (fields[0].ends_with("ZDA")) {
        const bool isWhole = fields.size() >= 5 && fields[2].size() == 2 && fields[3].size() == 2 &&
                             fields[4].size() == 4;
        const std::optional<std::int64_t> time_us =
            isWhole ? nmeaUnixTime(std::string(fields[2]) + std::string(fields[3]) +
                                       std::string(fields[4].substr(2)),
                                   nmeaTimeOfDay(fields[1]))
                    : std::nullopt;
        if (time_us)
            m_clock_us = time_us;
        else if (isWhole || fields.size() < 5)
            fail(NmeaFault::Fields, m_number);
        ++(time_us ? m_counts.others : m_counts.malformed);
        return;
    }
    const bool isThs = fields[0].ends_with("THS");
    m_ship.heading_deg.reset(); // a compass that reports a fault has none
    if (isThs && fields.size() >= 3 && fields[2] == "V") {
        ++m_counts.withoutFix;
        return;
    }
    if (fields.size() >= 3)
        m_ship.heading_deg = nmeaNumber(fields[1], 0, 360);
    if (!m_ship.heading_deg)
        fail(NmeaFault::Fields, m_number);
    ++(m_ship.heading_deg ? m_counts.others : m_counts.malformed);
}

/** Returns the instant with this time of day that is nearest to the newest time of the stream. */
std::optional<std::int64_t> NmeaReader::dated(std::optional<double> timeOfDay_s) const
{
    if (!m_clock_us || !timeOfDay_s)
        return std::nullopt;
    constexpr std::int64_t kDay_us = 86'400 * kSecond_us;
    const std::int64_t midnight_us = *m_clock_us - *m_clock_us % kDay_us;
    std::int64_t time_us = midnight_us + std::llround(1e6 * *timeOfDay_s);
    if (time_us - *m_clock_us > kDay_us / 2)
        time_us -= kDay_us;
    else if (*m_clock_us - time_us > kDay_us / 2)
        time_us += kDay_us;
    return time_us;
}

void NmeaReader::readRadar(std::span<const std::string_view> fields)
{
    const bool isTll = fields[0].ends_with("TLL");
    const std::size_t status = isTll ? 8 : 12;
    const std::size_t time = isTll ? 7 : 14;
    const auto malformed = [this] {
        ++m_counts.malformed;
        fail(NmeaFault::Fields, m_number);
    };
    if (fields.size() <= status)
        return malformed();
    if (fields[status] == "L" || fields[status] == "Q") { // lost, or not yet tracked
        ++m_counts.withoutFix;
        return;
    }
    const std::optional<std::uint32_t> number = numberOf(fields[1], 999);
    if (!number || (fields[status] != "T" && !fields[status].empty()))
        return malformed();
    NmeaTarget target{.id = *number, .name = std::string(fields[isTll ? 6 : 11])};
    if (fields.size() > time && !fields[time].empty()) {
        target.timeOfDay_s = nmeaTimeOfDay(fields[time]);
        if (!target.timeOfDay_s)
            return malformed();
    }
    if (isTll) {
        const std::optional<LatLon> place = nmeaPlace(fields.subspan(2, 4));
        if (!place)
            return malformed();
        target.place = *place;
    } else if (!placeByBearing(target, fields)) {
        return;
    }
    target.unix_us = target.timeOfDay_s ? dated(target.timeOfDay_s) : m_clock_us;
    if (!target.timeOfDay_s && m_ship.time_s && !m_clock_us)
        target.timeOfDay_s = m_ship.time_s;
    add(std::move(target));
}

/** Places a TTM by its distance and bearing; counts and names what it lacks. */
bool NmeaReader::placeByBearing(NmeaTarget& target, std::span<const std::string_view> fields)
{
    const std::optional<double> unit_m = metresIn(fields[10]);
    const std::optional<double> distance = nmeaNumber(fields[2], 0, 1000);
    std::optional<double> bearing_deg = nmeaNumber(fields[3], 0, 360);
    const bool isRelative = fields[4] == "R";
    if (!unit_m || !distance || !bearing_deg || (!isRelative && fields[4] != "T") ||
        *distance * *unit_m > kFarthestTarget_m) {
        ++m_counts.malformed;
        fail(NmeaFault::Fields, m_number);
        return false;
    }
    bool isOld = false;
    if (target.timeOfDay_s && m_ship.time_s) {
        const double apart_s = std::abs(*target.timeOfDay_s - *m_ship.time_s);
        isOld = std::min(apart_s, kDay_s - apart_s) > kShipKept_s;
    }
    if (!m_ship.place || isOld || (isRelative && !m_ship.heading_deg)) {
        ++m_counts.withoutShip;
        fail(NmeaFault::NoShip, m_number);
        return false;
    }
    if (isRelative)
        *bearing_deg += *m_ship.heading_deg;
    const double bearing_rad = radFromDeg(*bearing_deg);
    const double distance_m = *distance * *unit_m;
    target.place = LocalFrame(*m_ship.place)
                       .toGeographic(Point(distance_m * std::sin(bearing_rad),
                                           distance_m * std::cos(bearing_rad)));
    if (fields[7] != "T") // a relative motion is that of the ship, too
        return true;
    if (const std::optional<double> speed = nmeaNumber(fields[5], 0, 2000))
        target.speed_mps = *speed * *unit_m / 3600;
    target.course_deg = nmeaNumber(fields[6], 0, 360);
    return true;
}

void NmeaReader::readAis(std::span<const std::string_view> fields)
{
    const auto malformed = [this] {
        ++m_counts.malformed;
        fail(NmeaFault::Fields, m_number);
    };
    if (fields.size() < 7)
        return malformed();
    const std::optional<std::uint32_t> count = numberOf(fields[1], 9);
    const std::optional<std::uint32_t> part = numberOf(fields[2], 9);
    const std::optional<std::uint32_t> fill = numberOf(fields[6], 5);
    if (!count || !part || !fill || *part < 1 || *part > *count || fields[5].empty())
        return malformed();
    const bool isOwn = fields[0].ends_with("VDO");
    const int fillBits = static_cast<int>(*fill);
    if (*count == 1)
        return readAisMessage(fields[5], fillBits, isOwn);
    const std::string key =
        std::string(fields[0]) + ',' + std::string(fields[3]) + ',' + std::string(fields[4]);
    const auto known = m_parts.find(key);
    const bool isNext = known != m_parts.end() && known->second.count == *count &&
                        known->second.received + 1 == *part;
    if (known != m_parts.end() && !isNext) { // the message before was never completed
        drop(known->second);
        m_parts.erase(known);
    }
    if (!isNext && *part != 1) {
        ++m_counts.badParts;
        fail(NmeaFault::AisPart, m_number);
        return;
    }
    if (!isNext && m_parts.size() >= kMostParts) {
        const auto oldest = std::ranges::min_element(
            m_parts, {}, [](const auto& entry) { return entry.second.lines.front(); });
        drop(oldest->second);
        m_parts.erase(oldest);
    }
    Parts& parts = m_parts[key];
    parts.count = *count;
    parts.received = *part;
    parts.payload += fields[5];
    parts.lines.push_back(m_number);
    if (*part < *count)
        return;
    const std::string payload = std::move(parts.payload);
    m_parts.erase(key);
    readAisMessage(payload, fillBits, isOwn);
}

void NmeaReader::readAisMessage(std::string_view payload, int fillBits, bool isOwn)
{
    const AisReading reading = aisMessageOf(payload, fillBits);
    const AisMessage& message = reading.message;
    if (reading.outcome != AisOutcome::Read) {
        const bool isOther = reading.outcome == AisOutcome::OtherType;
        ++(isOther ? m_counts.others : m_counts.malformed);
        if (!isOther)
            fail(NmeaFault::AisMessage, m_number);
        return;
    }
    if (message.type == 5) {
        ++m_counts.others;
        if (m_names.size() < kMostNames || m_names.contains(message.mmsi))
            m_names[message.mmsi] = message.name;
        return;
    }
    if (!message.place) {
        ++m_counts.withoutFix;
        return;
    }
    if (isOwn) {
        ++m_counts.others;
        m_ship = {.place = message.place,
                  .heading_deg = message.heading_deg ? message.heading_deg : m_ship.heading_deg};
        return;
    }
    NmeaTarget target{.kind = message.type == 21 ? NmeaTarget::Kind::Aid : NmeaTarget::Kind::Ship,
                      .id = message.mmsi,
                      .name = message.name,
                      .place = *message.place,
                      .speed_mps = message.speed_mps,
                      .course_deg = message.course_deg,
                      .unix_us = m_clock_us};
    if (const auto name = m_names.find(message.mmsi); name != m_names.end() && target.name.empty())
        target.name = name->second;
    if (message.second && target.unix_us) { // the nearest instant with that second of the minute
        constexpr std::int64_t kMinute_us = 60 * kSecond_us;
        std::int64_t ahead_us = *message.second * kSecond_us - *target.unix_us % kMinute_us;
        if (ahead_us > kMinute_us / 2)
            ahead_us -= kMinute_us;
        else if (ahead_us < -kMinute_us / 2)
            ahead_us += kMinute_us;
        *target.unix_us += ahead_us;
    }
    add(std::move(target));
}

IssueId issueOf(NmeaFault fault)
{
    switch (fault) {
    case NmeaFault::NoSentence:
        return IssueId::NmeaNoSentence;
    case NmeaFault::Checksum:
        return IssueId::NmeaChecksum;
    case NmeaFault::Fields:
        return IssueId::NmeaFields;
    case NmeaFault::AisMessage:
        return IssueId::NmeaAisMessage;
    case NmeaFault::AisPart:
        return IssueId::NmeaAisPart;
    case NmeaFault::NoShip:
        return IssueId::NmeaNoShip;
    }
    return IssueId::NmeaNoSentence;
}

std::string nmeaSentence(std::string_view content)
{
    constexpr std::string_view kHex = "0123456789ABCDEF";
    const std::uint8_t sum = nmeaChecksum(content);
    std::string sentence = "$";
    sentence += content;
    sentence += '*';
    sentence += kHex[sum / 16U];
    sentence += kHex[sum % 16U];
    return sentence + "\r\n";
}

} // namespace berg
