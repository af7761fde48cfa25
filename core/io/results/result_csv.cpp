#include "core/io/results/result_csv.h"

#include "core/base/angles.h"
#include "core/io/text/export_numbers.h"
#include "core/plan/solve/names.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace berg {

// Lines end in LF: every reader of RFC 4180 takes it, and line tools would keep the CR of CRLF in
// the last column.

namespace {

/** Room for one row, bytes; only saves reallocation. */
constexpr std::size_t kRowBytes = 128;

constexpr std::array<Named<ChangedPart>, 3> kChangedPartNames{{
    {ChangedPart::Wind, "wind"},
    {ChangedPart::Asset, "asset"},
    {ChangedPart::Assignment, "assigned"},
}};

/** Appends `value` and the separator that follows it. */
void add(std::string& text, double value, char separator)
{
    appendNumber(text, value);
    text += separator;
}

/** Ids of the icebergs as CSV fields, by index. */
std::vector<std::string> idFields(const Mission& mission)
{
    std::vector<std::string> fields;
    for (const Iceberg& iceberg : mission.icebergs())
        fields.push_back(csvField(iceberg.id));
    return fields;
}

/** The same of the UAVs. */
std::vector<std::string> uavFields(const Mission& mission)
{
    std::vector<std::string> fields;
    for (const Uav& uav : mission.scenario().uavs)
        fields.push_back(csvField(uav.id));
    return fields;
}

} // namespace

std::string_view eventName(EventKind kind)
{
    switch (kind) {
    case EventKind::Planned:
        return "planned";
    case EventKind::Reached:
        return "reached";
    case EventKind::Sighted:
        return "sighted";
    case EventKind::Appeared:
        return "appeared";
    case EventKind::PlannerFailed:
        return "planner failed";
    case EventKind::Alarm:
        return "alarm";
    case EventKind::Intervention:
        return "intervention";
    case EventKind::Left:
        return "left";
    case EventKind::Lost:
        return "lost";
    case EventKind::Found:
        return "found";
    case EventKind::GivenUp:
        return "given up";
    case EventKind::HomeBound:
        return "home bound";
    case EventKind::Landed:
        return "landed";
    case EventKind::TookOff:
        return "took off";
    case EventKind::LateHome:
        return "late home";
    case EventKind::Close:
        return "close";
    }
    throw std::logic_error("eventName: unknown kind");
}

std::string eventDetail(const MissionEvent& event, const Mission& mission)
{
    const auto idOf = [](const auto& entries, int index) {
        return entries.at(static_cast<std::size_t>(index)).id;
    };
    std::string text;
    switch (event.kind) {
    case EventKind::Planned:
        return event.fellBack ? "last plan kept" : event.backend;
    case EventKind::Reached:
        for (const int other : event.together)
            text += (text.empty() ? "with " : ", ") + idOf(mission.icebergs(), other);
        return text;
    case EventKind::Sighted:
        return event.reported ? "reported" : "";
    case EventKind::PlannerFailed:
        return event.failure;
    case EventKind::Alarm:
        return "in " + std::to_string(std::llround(event.entry_s)) + " s";
    case EventKind::Intervention:
        return event.changed == ChangedPart::Planner ? nameOf(kPolicyNames, event.policy)
                                                     : nameOf(kChangedPartNames, event.changed);
    case EventKind::Close:
        return idOf(mission.scenario().uavs, event.otherUav) + ", " +
               std::to_string(std::llround(event.distance_m)) + " m";
    case EventKind::Appeared:
    case EventKind::Left:
    case EventKind::Lost:
    case EventKind::Found:
    case EventKind::GivenUp:
    case EventKind::HomeBound:
    case EventKind::Landed:
    case EventKind::TookOff:
    case EventKind::LateHome:
        break;
    }
    return text;
}

std::string numberText(double value)
{
    std::string text;
    appendNumber(text, value);
    return text;
}

std::string csvField(const std::string& given)
{
    constexpr std::string_view kFormulaStarts = "=+-@\t\r";
    const bool isFormula = !given.empty() && kFormulaStarts.find(given[0]) != std::string::npos;
    const std::string text = isFormula ? '\'' + given : given;
    if (text.find_first_of(",\"\r\n") == std::string::npos)
        return text;
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"')
            quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

std::string_view trajectoryHeader()
{
    return "time_s,uav,east_m,north_m,latitude_deg,longitude_deg,heading_deg,turn_rate_radps,"
           "cross_track_m\n";
}

void appendTrajectoryRow(std::string& text, const LocalFrame& frame, const std::string& uav,
                         const TrackPoint& point)
{
    const LatLon place = frame.toGeographic(point.state.position_m);
    add(text, point.time_s, ',');
    text += uav;
    text += ',';
    add(text, point.state.position_m.x(), ',');
    add(text, point.state.position_m.y(), ',');
    add(text, place.latitude_deg, ',');
    add(text, place.longitude_deg, ',');
    add(text, headingFromPsi(point.state.psi_rad), ',');
    add(text, point.u_radps, ',');
    add(text, point.crossTrack_m, '\n');
}

TrackPoint trackPointOf(const Sample& sample, std::size_t row)
{
    const UavSample& uav = sample.uavs.at(row);
    return {.time_s = sample.time_s,
            .state = uav.pose,
            .u_radps = uav.u_radps,
            .crossTrack_m = uav.crossTrack_m};
}

std::string trajectoryCsv(const Mission& mission)
{
    const LocalFrame frame(mission.scenario().origin);
    const std::vector<std::string> uavs = uavFields(mission);
    const std::vector<Sample>& samples = mission.recorder().samples();
    std::string text(trajectoryHeader());
    text.reserve((samples.size() * uavs.size() + 1) * kRowBytes);
    for (const Sample& sample : samples)
        for (std::size_t i = 0; i < sample.uavs.size(); ++i)
            appendTrajectoryRow(text, frame, uavs[i], trackPointOf(sample, i));
    return text;
}

std::string sigmaCsv(const Mission& mission)
{
    const std::vector<std::string> ids = idFields(mission);
    const Recorder& recorder = mission.recorder();
    std::string text = "time_s,iceberg,sigma_m2,east_m,north_m,in_view\n";
    for (std::size_t row = 0; row < recorder.samples().size(); ++row) {
        const std::string time = numberText(recorder.samples()[row].time_s) + ',';
        const std::span<const IcebergSample> icebergs = recorder.icebergs(row);
        for (std::size_t i = 0; i < icebergs.size(); ++i) {
            const IcebergSample& iceberg = icebergs[i];
            if (!iceberg.active)
                continue;
            text += time;
            text += ids[i];
            text += ',';
            add(text, iceberg.sigma_m2, ',');
            add(text, iceberg.truth_m.x(), ',');
            add(text, iceberg.truth_m.y(), ',');
            text += iceberg.inView ? "1\n" : "0\n";
        }
    }
    return text;
}

std::string eventsCsv(const Mission& mission)
{
    const std::vector<std::string> ids = idFields(mission);
    const std::vector<std::string> uavs = uavFields(mission);
    std::string text = "time_s,event,uav,iceberg,detail\n";
    for (const MissionEvent& event : mission.events()) {
        add(text, event.time_s, ',');
        text += eventName(event.kind);
        text += ',';
        if (event.uav >= 0 || uavs.size() == 1) // with one UAV all events are its own
            text += uavs.at(static_cast<std::size_t>(std::max(0, event.uav)));
        text += ',';
        if (event.iceberg >= 0)
            text += ids.at(static_cast<std::size_t>(event.iceberg));
        text += ',' + csvField(eventDetail(event, mission)) + '\n';
    }
    return text;
}

std::string zetaCsv(const Mission& mission)
{
    const bool weighted = mission.simulation().asset().has_value();
    std::string text = "time_s,sigma_sum_m2,zeta_m2s";
    text += weighted ? ",weighted_sigma_sum_m2\n" : "\n";
    for (const Sample& sample : mission.recorder().samples()) {
        add(text, sample.time_s, ',');
        add(text, sample.sigmaSum_m2, ',');
        add(text, sample.zeta_m2s, weighted ? ',' : '\n');
        if (weighted)
            add(text, sample.weightedSum_m2, '\n');
    }
    return text;
}

} // namespace berg
