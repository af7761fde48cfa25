#include "core/io/import/fields/import_fields.h"
#include "core/io/import/receivers/receiver_readers.h"
#include "core/io/text/byte_order_mark.h"
#include "core/link/logs/nmea_log.h"
#include "core/link/nmea/ais_message.h"
#include "core/link/nmea/nmea_reader.h"
#include "core/link/traffic.h"
#include "core/tracking/position_error.h"

#include <algorithm>
#include <map>
#include <set>

namespace berg {

namespace {

constexpr std::int64_t kNumberReused_us = 1'800'000'000; ///< half an hour of silence

std::span<const std::uint8_t> bytesOf(std::string_view text)
{
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/** Returns the first line of a text with its end. */
std::string_view firstLine(std::string_view text)
{
    const std::size_t end = text.find('\n');
    return text.substr(0, end == std::string_view::npos ? end : end + 1);
}

/** Reads a log line by line. */
class NmeaImport
{
public:
    explicit NmeaImport(const ImportText& source)
        : m_budget(source.budget), m_text(withoutByteOrderMark(source.text))
    {
    }

    SightingTable take()
    {
        NmeaReader reader(firstClock());
        for (std::string_view rest = m_text; !rest.empty();) {
            m_budget.throwIfStopped();
            const std::string_view line = firstLine(rest);
            rest.remove_prefix(line.size());
            static_cast<void>(reader.feed(bytesOf(line)));
            takeFrom(reader);
        }
        static_cast<void>(reader.finish());
        takeFrom(reader);
        leaveOutShips();
        std::ranges::stable_sort(m_table.rejected.first, {}, &RejectedRow::line);
        return std::move(m_table);
    }

private:
    /** A number of the radar, and when it was used last. */
    struct RadarNumber
    {
        std::optional<std::int64_t> last_us;
        int uses = 1;
    };

    /** Returns the first time of the log, which dates the lines before it. */
    [[nodiscard]] std::optional<std::int64_t> firstClock() const
    {
        NmeaReader reader;
        for (std::string_view rest = m_text; !rest.empty() && !reader.clock_us();) {
            m_budget.throwIfStopped();
            const std::string_view line = firstLine(rest);
            rest.remove_prefix(line.size());
            static_cast<void>(reader.feed(bytesOf(line)));
        }
        return reader.clock_us();
    }

    void takeFrom(NmeaReader& reader)
    {
        for (const NmeaFinding& finding : reader.takeFindings()) {
            m_budget.takeRow(0);
            m_table.rejected.add({.line = finding.line, .fault = issueOf(finding.fault)});
        }
        for (const NmeaTarget& target : reader.takeTargets()) {
            const double now_s = static_cast<double>(target.unix_us.value_or(0)) / 1e6;
            const std::string id = idOf(target);
            if (target.kind == NmeaTarget::Kind::Radar && m_ships.isAtShip(target.place, now_s))
                m_shipTargets.insert(id);
            if (target.kind == NmeaTarget::Kind::Ship)
                m_ships.receive(target, now_s);
            else if (target.kind == NmeaTarget::Kind::Radar || saysIce(target.name))
                add(target, id);
        }
    }

    [[nodiscard]] std::string idOf(const NmeaTarget& target)
    {
        if (target.kind != NmeaTarget::Kind::Radar)
            return std::to_string(target.id);
        RadarNumber& number = m_numbers[target.id];
        if (number.last_us && target.unix_us &&
            *target.unix_us - *number.last_us > kNumberReused_us)
            ++number.uses;
        number.last_us = target.unix_us;
        const std::string id = "radar " + std::to_string(target.id);
        return number.uses == 1 ? id : id + " (" + std::to_string(number.uses) + ')';
    }

    void add(const NmeaTarget& target, const std::string& id)
    {
        Sighting sighting{.line = target.line,
                          .id = id,
                          .name = cleanText(target.name, kLongestName),
                          .place = target.place};
        if (sighting.place.longitude_deg >= 180)
            sighting.place.longitude_deg -= 360;
        if (target.unix_us)
            sighting.time = std::chrono::floor<std::chrono::milliseconds>(
                std::chrono::sys_time<std::chrono::microseconds>(
                    std::chrono::microseconds(*target.unix_us)));
        else
            m_table.noted.add({.line = target.line, .fault = IssueId::TimeNotGiven});
        if (target.kind == NmeaTarget::Kind::Aid)
            sighting.sigma_m2 = errorOf(SightingSource::Ais).sigma_m2();
        addRow(m_table, std::move(sighting), m_budget);
    }

    /** Rejects the targets that were at a ship with AIS at any time. */
    void leaveOutShips()
    {
        if (m_shipTargets.empty())
            return;
        for (const Sighting& row : m_table.sightings)
            if (m_shipTargets.contains(row.id))
                m_table.rejected.add(
                    {.line = row.line, .fault = IssueId::NmeaShip, .detail = row.id});
        std::erase_if(m_table.sightings,
                      [this](const Sighting& row) { return m_shipTargets.contains(row.id); });
    }

    ReadBudget& m_budget;
    std::string_view m_text;
    SightingTable m_table;
    TrafficList m_ships;
    std::map<std::uint32_t, RadarNumber> m_numbers;
    std::set<std::string> m_shipTargets;
};

} // namespace

bool isNmea(std::string_view text)
{
    return isNmeaLog(withoutByteOrderMark(text));
}

SightingTable readNmea(const ImportText& source)
{
    return NmeaImport(source).take();
}

} // namespace berg
