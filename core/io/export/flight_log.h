#pragma once

#include "core/io/export/export_content.h"

#include <optional>
#include <string>
#include <vector>

namespace berg {

/** Of one UAV: what the first plan had in mind, and what came of it. */
struct LogUav
{
    std::size_t row = 0; ///< in the scenario
    std::size_t plannedVisits = 0;
    double plannedLength_m = 0; ///< over ground, in straight legs, as the brief has it
    double plannedTime_s = 0;
    int visits = 0;
    double flown_m = 0;   ///< through the air
    double aloft_s = 0;   ///< as far as the record tells
    double outside_s = 0; ///< of the flight geography, where there is an operation
    std::string planHash; ///< SHA-256 of the first plan as a file of the format wpl
};

/** Of one iceberg: how it was kept in sight. */
struct LogIceberg
{
    std::size_t iceberg = 0;       ///< index
    std::optional<double> first_s; ///< seen first; none: never
    std::optional<double> last_s;
    int visits = 0;
    double longestUnseen_s = 0; ///< from when it was known of
    double sigma_m2 = 0;        ///< at the end of the record
};

/** What is told of a flight when it is over, or until now. */
struct FlightLog
{
    double flown_s = 0;
    Metrics metrics;
    std::optional<ZetaPrediction> predicted; ///< of the content: before take-off, of the whole run
    bool wasChanged = false; ///< in flight: then the prediction was for another flight
    std::vector<LogUav> uavs;
    std::vector<LogIceberg> icebergs;     ///< those that have appeared
    std::vector<MissionEvent> deviations; ///< from what was planned; of a drag of tau the last
};

/**
 * The log of the mission of the content, all UAVs. Cost: linear in the record. Throws
 * `Error{InvalidInput}` without a mission.
 */
[[nodiscard]] FlightLog flightLog(const ExportContent& content);

/** The log as a page of its own for browsers: HTML that is well-formed XML, in the words of the
 * content. */
[[nodiscard]] std::string flightLogHtml(const ExportContent& content);

} // namespace berg
