#pragma once

#include "core/earth/forecast.h"
#include "core/io/export/content/export_content.h"
#include "core/io/figure/figure.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace berg {

/** Log of one UAV: the first plan and the flight. */
struct LogUav
{
    std::size_t row = 0; ///< index in the scenario
    std::size_t plannedVisits = 0;
    double plannedLength_m = 0; ///< over ground in straight legs, as in the brief
    double plannedTime_s = 0;
    int visits = 0;
    double flown_m = 0;              ///< distance through the air
    double aloft_s = 0;              ///< flight time covered by the record
    std::optional<double> tookOff_s; ///< first take-off
    std::optional<double> landed_s;  ///< last landing; nullopt if the UAV is in the air
    double outside_s = 0;            ///< time outside the flight geography
    std::string planHash;            ///< SHA-256 of the first plan as a file of format wpl
};

/** Log of one iceberg: sightings by UAVs and by reports of others. */
struct LogIceberg
{
    IcebergIndex iceberg;
    std::optional<double> first_s; ///< first sighting; nullopt if it was never seen
    /** last sighting */
    std::optional<double> last_s;
    int visits = 0;
    double longestUnseen_s = 0; ///< counted from when the iceberg was known
    double sigma_m2 = 0;        ///< sigma at the end of the record
};

/** Weather in which the flight was flown, at one time; directions are true. */
struct LogWeather
{
    double time_s = 0;
    Point wind_mps = Point::Zero();
    std::optional<double> gust_mps;
    Point current_mps = Point::Zero();
};

/** Part of the flight for which the forecast lacks a quantity that it gives elsewhere. */
struct LogGap
{
    ForecastQuantity quantity = ForecastQuantity::Wind; ///< wind or current
    double from_s = 0;
    double to_s = 0;
};

/** The forecast of a flight, at the middle of the UAVs' starts. */
struct LogForecast
{
    std::string source;                   ///< empty if unknown
    std::optional<double> issued_s;       ///< run time, negative before the start
    std::optional<double> ageAtTakeOff_h; ///< nullopt if the time of issue is unknown
    LogWeather start;                     ///< at the start of the run
    LogWeather end;                       ///< at the end of the record
    std::vector<LogGap> gaps;             ///< by quantity and time, to the minute
};

/** Log of a flight that is over, or of a flight until now. */
struct FlightLog
{
    double flown_s = 0;
    Metrics metrics;
    std::optional<ZetaPrediction> predicted; ///< made before take-off, for the whole run
    bool wasChanged = false; ///< the flight was changed, so the prediction does not apply to it
    std::vector<LogUav> uavs;
    std::vector<LogIceberg> icebergs;     ///< icebergs that have appeared
    std::vector<MissionEvent> deviations; ///< a drag of tau is one of them
    std::optional<LogForecast> forecast;  ///< nullopt if the flight had none
};

/**
 * Builds the log of the content's mission with all UAVs. Cost: linear in the record. Throws
 * `Error{InvalidInput}` without a mission, and as `exportContent` for the first plan.
 */
[[nodiscard]] FlightLog flightLog(const ExportContent& content);

/** How a page of the log writes quantities: as files do, or in the user's units. Texts are HTML. */
struct LogFormat
{
    using Text = std::function<std::string(double)>;

    std::string start; ///< date and time
    Text time;         ///< of an instant, s
    Text date;         ///< of an instant, with its date
    Text duration;     ///< of s
    Text distance;     ///< of m
    Text zeta;         ///< of m² s
    Text sigma;        ///< of m², without unit
    Text radius;       ///< of the 95 % radius, by sigma in m²
    std::function<std::string(const PlannerSettings&)> planner;
    std::function<std::string(double value, int decimals)> number;
    std::function<std::string(double speed_mps, int decimals)> speed;
    std::function<std::string(const Figure&)> figure;
};

/** The parts of a page of the log, as HTML. */
struct LogPage
{
    std::string title; ///< plain text
    std::string summary;
    std::string figure; ///< empty if nothing was flown
    std::string details;
};

/** Writes the log in the language of the content. Throws as `flightLog`. */
[[nodiscard]] LogPage logPage(const ExportContent& content, const LogFormat& format);

/**
 * Returns the log as a self-contained page in the format of files: HTML that is well-formed XML.
 * Throws as `flightLog`.
 */
[[nodiscard]] std::string flightLogHtml(const ExportContent& content);

} // namespace berg
