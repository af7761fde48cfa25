#pragma once

#include "core/base/geodesy.h"
#include "core/io/text/text_sink.h"
#include "core/sim/intervention.h"
#include "core/sim/visits.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** Of an event in events.csv and in the JSON of a run. */
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
/** The rest of what happened, as events.csv says it: English, with ids. */
[[nodiscard]] std::string eventDetail(const MissionEvent& event, const Mission& mission);

// Result tables of a recorded mission: RFC 4180, UTF-8, '.' decimals, numbers that read back
// exactly, a header row with units.

/** `time_s,iceberg,sigma_m2,east_m,north_m,in_view` (true positions) */
void writeSigma(const Mission& mission, const TextSink& put);
/** `time_s,event,uav,iceberg,detail` */
void writeEvents(const Mission& mission, const TextSink& put);
/** `time_s,sigma_sum_m2,zeta_m2s`, and `weighted_sigma_sum_m2` where there is an asset */
void writeZeta(const Mission& mission, const TextSink& put);

/** Rows of the tables of a flight's samples, for whoever writes them as they come. */
class SampleTables
{
public:
    /** `icebergs`: of the scenario and those that appear in flight, by index; `weighted`: there is
     * an asset, or there will be. */
    SampleTables(const Scenario& scenario, std::span<const Iceberg> icebergs, bool weighted);

    [[nodiscard]] std::string trajectoryHeader() const;
    [[nodiscard]] std::string sigmaHeader() const;
    [[nodiscard]] std::string zetaHeader() const;
    void addTrajectory(std::string& text, const Sample& sample) const;
    void addSigma(std::string& text, const Sample& sample,
                  std::span<const IcebergSample> icebergs) const;
    void addZeta(std::string& text, const Sample& sample) const;

private:
    LocalFrame m_frame;
    std::vector<std::string> m_uavs;     ///< ids as CSV fields
    std::vector<std::string> m_icebergs; ///< likewise
    bool m_weighted;
};

/** Of a flight of the scenario in which these changes will be made. */
[[nodiscard]] SampleTables sampleTables(const Scenario& scenario,
                                        std::span<const Intervention> changes);

/** One of these tables: its first line, and the rows of a sample. */
struct SampleTable
{
    std::string (SampleTables::*header)() const;
    void (*addRows)(const SampleTables& tables, std::string& text, const Sample& sample,
                    std::span<const IcebergSample> icebergs);
};

/** Of UAV `row` of the scenario. */
[[nodiscard]] TrackPoint trackPointOf(const Sample& sample, std::size_t row);

/** With its line end:
 * `time_s,uav,east_m,north_m,latitude_deg,longitude_deg,heading_deg,turn_rate_radps,cross_track_m`
 */
[[nodiscard]] std::string_view trajectoryHeader();
/** One row of it; `uav` is a CSV field. */
void appendTrajectoryRow(std::string& text, const LocalFrame& frame, const std::string& uav,
                         const TrackPoint& point);

/**
 * One CSV field, quoted when it must be; controls that terminals obey become U+FFFD. A text that a
 * spreadsheet would run as a formula gets an apostrophe in front, which imports take off again
 * (`cleanText`).
 */
[[nodiscard]] std::string csvField(const std::string& given);

} // namespace berg
