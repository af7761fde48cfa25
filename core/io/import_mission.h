#pragma once

// Private to core/io: places in mission files for autopilots.

#include "core/io/import_formats.h"

#include <cstdint>
#include <set>
#include <string>

namespace berg {

/**
 * QGroundControl's JSON: every place to fly to is an iceberg. Survey patterns and other complex
 * items are rejected rows; landing patterns are passed over. `line` of a sighting is the number of
 * its item, from 1. Throws `Error` InvalidInput that names the field of what is no such mission,
 * UnsupportedVersion for other versions of the file.
 */
[[nodiscard]] SightingTable readPlan(const ImportText& source);
[[nodiscard]] bool isPlan(std::string_view text);

/**
 * `QGC WPL 110` (the first row is the home) and `120` (no home): rows of twelve columns set apart
 * by tabs or blanks. An iceberg has the name that follows a `#` behind its row or fills the line
 * above it. Throws `Error` SyntaxError with the line where a row is not of that kind, also for
 * decimal commas.
 */
[[nodiscard]] SightingTable readWpl(const ImportText& source);
[[nodiscard]] bool isWpl(std::string_view text);

/** One item of a mission, of any file. */
struct MissionItem
{
    std::size_t line = 0;
    std::int64_t command = 0; ///< MAV_CMD
    std::int64_t frame = 0;   ///< MAV_FRAME
    std::string latitude;     ///< degrees; empty: none
    std::string longitude;
    std::string name;
};

/**
 * Gathers the places of a mission. Take-off, landing, changes of course and everything that is no
 * place to fly to are passed over, and so is what is at home or where an earlier item is: the
 * circles at the end of a mission.
 */
class MissionPlaces
{
public:
    explicit MissionPlaces(const ImportText& source) : m_subject(source.subject) {}

    /** 0, 0 stands for a home that is not known. */
    void setHome(const MissionItem& home);
    void add(const MissionItem& item);
    /** An item that holds no single place. */
    void reject(std::size_t line, const std::string& what);
    [[nodiscard]] SightingTable take() { return std::move(m_table); }

private:
    [[nodiscard]] bool isNew(const LatLon& place);

    const std::string& m_subject;
    SightingTable m_table;
    std::set<std::pair<std::int64_t, std::int64_t>> m_known; ///< in 1e-7 degrees, a centimetre
};

} // namespace berg
