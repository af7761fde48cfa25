#pragma once

#include "core/earth/geodesy.h"
#include "core/io/text/text_sink.h"
#include "core/mission/visits.h"
#include "core/sim/intervention.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** Names of events in events.csv and in the JSON of a run. */
inline constexpr std::array<Named<EventKind>, 18> kEventNames{{
    {EventKind::Planned, "planned"},
    {EventKind::Reached, "reached"},
    {EventKind::Sighted, "sighted"},
    {EventKind::Appeared, "appeared"},
    {EventKind::PlannerFailed, "planner failed"},
    {EventKind::Alarm, "alarm"},
    {EventKind::Intervention, "intervention"},
    {EventKind::Left, "left"},
    {EventKind::Lost, "lost"},
    {EventKind::Found, "found"},
    {EventKind::GivenUp, "given up"},
    {EventKind::HomeBound, "home bound"},
    {EventKind::Landed, "landed"},
    {EventKind::TookOff, "took off"},
    {EventKind::LateHome, "late home"},
    {EventKind::Close, "close"},
    {EventKind::LeftFence, "left geofence"},
    {EventKind::BackInside, "back inside"},
}};
/** Returns the text of column `detail` of events.csv: English, with ids. */
[[nodiscard]] std::string eventDetail(const MissionEvent& event, const Mission& mission);

// Result tables of a recorded mission: RFC 4180, UTF-8, '.' as decimal point, numbers that read
// back exactly, a header row with units.

/** Writes `time_s,iceberg,sigma_m2,east_m,north_m,in_view` with true positions. */
void writeSigma(const Mission& mission, const TextSink& put);
/** Writes `time_s,event,uav,iceberg,detail`. */
void writeEvents(const Mission& mission, const TextSink& put);
/** Writes `time_s,sigma_sum_m2,zeta_m2s`, and `weighted_sigma_sum_m2` if there is an asset. */
void writeZeta(const Mission& mission, const TextSink& put);

/** Rows of the tables of a flight's samples, for writers that get the samples one by one. */
class SampleTables
{
public:
    /**
     * `icebergs` are those of the scenario and those that appear in flight, by index; `weighted`
     * says whether there is or will be an asset.
     */
    SampleTables(const Scenario& scenario, std::span<const Iceberg> icebergs, bool weighted);

    /** Returns the header line of each table, with its line end. */
    [[nodiscard]] std::string trajectoryHeader() const;
    [[nodiscard]] std::string sigmaHeader() const;
    [[nodiscard]] std::string zetaHeader() const;
    /**
     * The following append the rows of a sample to `text`; `icebergs` belong to the same sample,
     * and only those active in it get a row.
     */
    void addTrajectory(std::string& text, const Sample& sample) const;
    void addSigma(std::string& text, const Sample& sample,
                  std::span<const IcebergSample> icebergs) const;
    void addZeta(std::string& text, const Sample& sample) const;

private:
    LocalFrame m_frame;
    std::vector<std::string> m_uavs;     ///< ids as CSV fields
    std::vector<std::string> m_icebergs; ///< ids as CSV fields
    bool m_weighted;
};

/** Returns the tables of a flight of the scenario with the given interventions. */
[[nodiscard]] SampleTables sampleTables(const Scenario& scenario,
                                        std::span<const Intervention> changes);

/** One of the tables: its header line and a function that appends the rows of a sample. */
struct SampleTable
{
    std::string (SampleTables::*header)() const;
    void (*addRows)(const SampleTables& tables, std::string& text, const Sample& sample,
                    std::span<const IcebergSample> icebergs);
};

/** Returns the track point of UAV `row` in the scenario. Throws `std::out_of_range` without it. */
[[nodiscard]] TrackPoint trackPointOf(const Sample& sample, std::size_t row);

/**
 * Returns the header line of the trajectory table, with its line end:
 * `time_s,uav,east_m,north_m,latitude_deg,longitude_deg,heading_deg,turn_rate_radps,cross_track_m`.
 */
[[nodiscard]] std::string_view trajectoryHeader();
/** Appends one row of the trajectory table; `uav` is a CSV field. */
void appendTrajectoryRow(std::string& text, const LocalFrame& frame, const std::string& uav,
                         const TrackPoint& point);

/**
 * Returns a text as one CSV field, quoted if necessary; terminal control characters become U+FFFD.
 * A text that a spreadsheet would run as a formula gets an apostrophe in front, which imports
 * remove again (`cleanText`).
 */
[[nodiscard]] std::string csvField(const std::string& given);

} // namespace berg
