#pragma once

#include "core/base/issue.h"
#include "core/earth/geodesy.h"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace berg {

/** Position data of one NMEA 0183 sentence; members that it does not contain are empty. */
struct NmeaFix
{
    std::string talker;   ///< Two letters, such as "GP" (GPS) or "AI" (AIS).
    std::string sentence; ///< "GGA", "RMC" or "VTG".
    std::optional<LatLon> place;
    std::optional<double> altitude_m;    ///< Above mean sea level; GGA.
    std::optional<double> speed_mps;     ///< Over ground; RMC, VTG.
    std::optional<double> course_deg;    ///< Over ground from true north, 0 to 360; RMC, VTG.
    std::optional<double> timeOfDay_s;   ///< UTC; GGA, RMC.
    std::optional<std::int64_t> unix_us; ///< With the date, which only RMC contains.
};

/** Something that a radar tracks, or that AIS reports, in one sentence or message. */
struct NmeaTarget
{
    enum class Kind
    {
        Radar, ///< TLL, TTM: the sentence does not say whether it is ice.
        Ship,  ///< AIS types 1 to 3.
        Aid    ///< AIS type 21: a buoy, or a mark that somebody has set, such as on ice.
    };
    Kind kind = Kind::Radar;
    std::uint64_t line = 0; ///< Number in the stream, from 1; that of the last part of a message.
    std::uint32_t id = 0;   ///< Number of the radar target, or MMSI.
    std::string name;       ///< Any bytes; empty if there is none.
    LatLon place;
    std::optional<double> speed_mps;     ///< Over ground.
    std::optional<double> course_deg;    ///< Over ground from true north, 0 to 360.
    std::optional<double> timeOfDay_s;   ///< UTC, of a radar.
    std::optional<std::int64_t> unix_us; ///< With the date of the stream; nullopt before that.
};

/** Reason why a line gives nothing. */
enum class NmeaFault
{
    NoSentence, ///< Neither `$` nor `!` with a type, or longer than 256 bytes.
    Checksum,   ///< Wrong or missing.
    Fields,     ///< Too few, or one that cannot be read.
    AisMessage, ///< An AIS message that is cut or contradicts its type.
    AisPart,    ///< A part of an AIS message without the others before or behind it.
    NoShip ///< A bearing without the own position, and heading if it is relative, of that minute.
};

/** Returns the sentence of a fault for reports. */
[[nodiscard]] IssueId issueOf(NmeaFault fault);

/** A line that gives nothing. */
struct NmeaFinding
{
    std::uint64_t line = 0;
    NmeaFault fault = NmeaFault::NoSentence;
    bool operator==(const NmeaFinding&) const = default;
};

/** Statistics of a reader's lines. */
struct NmeaCounts
{
    std::uint64_t fixes = 0;
    std::uint64_t targets = 0;
    std::uint64_t withoutFix = 0;   ///< Receivers without a position, radar targets not tracked.
    std::uint64_t badChecksums = 0; ///< Wrong or missing checksum.
    std::uint64_t malformed = 0;    ///< Correct checksum, but unreadable fields or messages.
    std::uint64_t badParts = 0;     ///< Parts of AIS messages without the others.
    std::uint64_t withoutShip = 0;  ///< Bearings without an own position or heading.
    std::uint64_t others = 0;       ///< Other sentences, and lines that are no sentence.
};

/**
 * Reads a stream of NMEA 0183 sentences of any talker, with a correct checksum: positions of GPS
 * receivers, trackers and ships (GGA, RMC, VTG), radar targets (TLL, TTM), and ships and marks by
 * AIS (VDM, VDO; messages 1 to 3, 5, 21). Own position, heading (HDT, THS, VDO) and date (RMC, ZDA,
 * tag blocks) of the stream place and date the targets. Memory: one line, some parts of AIS
 * messages, the names of 500 ships, and at most 1000 targets and findings that were not taken.
 */
class NmeaReader
{
public:
    NmeaReader() = default;
    /** Begins at a time that the stream reaches only later. */
    explicit NmeaReader(std::optional<std::int64_t> clock_us) : m_clock_us(clock_us) {}

    /** Processes bytes of the stream and returns the fixes of the lines that they complete. */
    [[nodiscard]] std::vector<NmeaFix> feed(std::span<const std::uint8_t> bytes);
    /** Ends the stream: reads a last line without an end, and gives up waiting for parts. */
    [[nodiscard]] std::vector<NmeaFix> finish();

    /** Returns the targets since the last call; further ones than 1000 are dropped. */
    [[nodiscard]] std::vector<NmeaTarget> takeTargets() { return std::exchange(m_targets, {}); }
    /** Returns the lines that gave nothing since the last call, by number except parts of AIS. */
    [[nodiscard]] std::vector<NmeaFinding> takeFindings() { return std::exchange(m_findings, {}); }

    [[nodiscard]] const NmeaCounts& counts() const { return m_counts; }
    /** Returns the newest time of the stream, microseconds since 1970; nullopt before a date. */
    [[nodiscard]] std::optional<std::int64_t> clock_us() const { return m_clock_us; }

private:
    /** Own ship of the stream. */
    struct Ship
    {
        std::optional<LatLon> place;
        std::optional<double> time_s; ///< Time of day of `place`.
        std::optional<double> heading_deg;
    };
    /** An AIS message of which parts have arrived. */
    struct Parts
    {
        std::size_t count = 0;
        std::size_t received = 0;
        std::string payload;
        std::vector<std::uint64_t> lines;
    };

    void endLine(std::vector<NmeaFix>& fixes);
    [[nodiscard]] std::optional<NmeaFix> fixOf(std::string_view line);
    [[nodiscard]] std::optional<NmeaFix> ownFix(std::span<const std::string_view> fields);
    void readRadar(std::span<const std::string_view> fields);
    void readAis(std::span<const std::string_view> fields);
    void readAisMessage(std::string_view payload, int fillBits, bool isOwn);
    void readTime(std::span<const std::string_view> fields);
    [[nodiscard]] bool placeByBearing(NmeaTarget& target, std::span<const std::string_view> fields);
    [[nodiscard]] std::optional<std::int64_t> dated(std::optional<double> timeOfDay_s) const;
    void add(NmeaTarget target);
    void fail(NmeaFault fault, std::uint64_t line);
    void drop(const Parts& parts);

    std::string m_line;
    bool m_isTooLong = false; ///< The rest of this line is ignored.
    std::uint64_t m_number = 1;
    NmeaCounts m_counts;
    Ship m_ship;
    std::optional<std::int64_t> m_clock_us;
    std::map<std::string, Parts> m_parts; ///< By sentence, sequence and channel.
    std::map<std::uint32_t, std::string> m_names;
    std::vector<NmeaTarget> m_targets;
    std::vector<NmeaFinding> m_findings;
};

/** Returns a sentence with `$`, checksum and line end, for content such as "GPVTG,90.0,T,,M,...".
 */
[[nodiscard]] std::string nmeaSentence(std::string_view content);

} // namespace berg
