#include "core/io/results/result_csv.h"

#include "core/base/angles.h"
#include "core/base/number_text.h"
#include "core/io/text/export_numbers.h"
#include "core/io/text/json_writer.h"
#include "core/plan/solve/names.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace berg {

// Lines end in LF: every reader of RFC 4180 accepts it, and line tools would add the CR of CRLF to
// the last column.

namespace {

constexpr std::array<Named<ChangedPart>, 4> kChangedPartNames{{
    {ChangedPart::Wind, "wind"},
    {ChangedPart::Asset, "asset"},
    {ChangedPart::Assignment, "assigned"},
    {ChangedPart::Removal, "removed"},
}};

/** Appends `value` and the separator that follows it. */
void add(std::string& text, double value, char separator)
{
    appendNumber(text, value);
    text += separator;
}

/** Returns ids as CSV fields, by index. */
template <class Named>
std::vector<std::string> idFields(std::span<const Named> all)
{
    std::vector<std::string> fields;
    for (const Named& one : all)
        fields.push_back(csvField(one.id));
    return fields;
}

SampleTables tablesOf(const Mission& mission)
{
    return {mission.scenario(), mission.icebergs(),
            mission.simulation().world().asset().has_value()};
}

/** Whether terminals act on the character; line ends and tabs are excluded, as they are quoted. */
bool isControl(std::string_view character)
{
    const auto code = static_cast<unsigned char>(character.back());
    if (character.size() == 2)
        return character[0] == '\xC2' && code < 0xA0U;
    return character.size() == 1 &&
           (code == 0x7FU || (code < 0x20U && code != '\n' && code != '\r' && code != '\t'));
}

} // namespace

std::string eventDetail(const MissionEvent& event, const Mission& mission)
{
    const auto idOf = [](const auto& entries, auto index) { return entries.at(toIndex(index)).id; };
    std::string text;
    switch (event.kind) {
    case EventKind::Planned:
        return event.fellBack ? "last plan kept" : nameOf(kSourceNames, event.source);
    case EventKind::Reached:
        for (const IcebergIndex other : event.together)
            text += (text.empty() ? "with " : ", ") + idOf(mission.icebergs(), other);
        return text;
    case EventKind::Sighted:
        return event.reported ? "reported" : "";
    case EventKind::Appeared:
        return event.reported ? "added" : "";
    case EventKind::PlannerFailed:
        return event.failure;
    case EventKind::Alarm:
        return "in " + std::to_string(std::llround(event.entry_s)) + " s";
    case EventKind::Intervention:
        if (event.changed == ChangedPart::Order)
            return nameOf(kFlightOrderNames, event.order);
        return event.changed == ChangedPart::Planner ? nameOf(kPolicyNames, event.policy)
                                                     : nameOf(kChangedPartNames, event.changed);
    case EventKind::Close:
        return idOf(mission.scenario().uavs, *event.otherUav) + ", " +
               std::to_string(std::llround(event.distance_m)) + " m";
    case EventKind::Left:
    case EventKind::Lost:
    case EventKind::Found:
    case EventKind::GivenUp:
    case EventKind::HomeBound:
    case EventKind::Landed:
    case EventKind::TookOff:
    case EventKind::LateHome:
    case EventKind::LeftFence:
    case EventKind::BackInside:
        break;
    }
    return text;
}

std::string csvField(const std::string& given)
{
    constexpr std::string_view kFormulaStarts = "=+-@\t\r";
    const bool isFormula = !given.empty() && kFormulaStarts.find(given[0]) != std::string::npos;
    std::string text = isFormula ? "'" : "";
    for (std::string_view rest = given; !rest.empty();) {
        const std::size_t size = std::max<std::size_t>(characterSize(rest), 1);
        text += isControl(rest.substr(0, size)) ? "\uFFFD" : rest.substr(0, size);
        rest.remove_prefix(size);
    }
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

SampleTables::SampleTables(const Scenario& scenario, std::span<const Iceberg> icebergs,
                           bool weighted)
    : m_frame(scenario.origin)
    , m_uavs(idFields(std::span(scenario.uavs)))
    , m_icebergs(idFields(icebergs))
    , m_weighted(weighted)
{
}

std::string SampleTables::trajectoryHeader() const
{
    return std::string(berg::trajectoryHeader());
}

std::string SampleTables::sigmaHeader() const
{
    return "time_s,iceberg,sigma_m2,east_m,north_m,in_view\n";
}

std::string SampleTables::zetaHeader() const
{
    return std::string("time_s,sigma_sum_m2,zeta_m2s") +
           (m_weighted ? ",weighted_sigma_sum_m2\n" : "\n");
}

void SampleTables::addTrajectory(std::string& text, const Sample& sample) const
{
    for (std::size_t i = 0; i < sample.uavs.size(); ++i)
        appendTrajectoryRow(text, m_frame, m_uavs[i], trackPointOf(sample, i));
}

void SampleTables::addSigma(std::string& text, const Sample& sample,
                            std::span<const IcebergSample> icebergs) const
{
    const std::string time = numberText(sample.time_s) + ',';
    for (std::size_t i = 0; i < icebergs.size(); ++i) {
        const IcebergSample& iceberg = icebergs[i];
        if (!iceberg.active)
            continue;
        text += time;
        text += m_icebergs.at(i);
        text += ',';
        add(text, iceberg.sigma_m2, ',');
        add(text, iceberg.truth_m.x(), ',');
        add(text, iceberg.truth_m.y(), ',');
        text += iceberg.inView ? "1\n" : "0\n";
    }
}

void SampleTables::addZeta(std::string& text, const Sample& sample) const
{
    add(text, sample.time_s, ',');
    add(text, sample.sigmaSum_m2, ',');
    add(text, sample.zeta_m2s, m_weighted ? ',' : '\n');
    if (m_weighted)
        add(text, sample.weightedSum_m2, '\n');
}

SampleTables sampleTables(const Scenario& scenario, std::span<const Intervention> changes)
{
    std::vector<Iceberg> icebergs = scenario.icebergs;
    bool weighted = scenario.asset.has_value();
    for (const Intervention& change : changes) {
        if (change.appears)
            icebergs.push_back(*change.appears);
        weighted = weighted || change.asset;
    }
    return {scenario, icebergs, weighted};
}

void writeSigma(const Mission& mission, const TextSink& put)
{
    const SampleTables tables = tablesOf(mission);
    const Recorder& recorder = mission.recorder();
    put(tables.sigmaHeader());
    std::string text;
    IcebergReader rows = recorder.reader();
    for (std::size_t row = 0; row < recorder.samples().size(); ++row) {
        tables.addSigma(text, recorder.samples()[row], rows.at(row));
        put(text);
        text.clear();
    }
}

void writeZeta(const Mission& mission, const TextSink& put)
{
    const SampleTables tables = tablesOf(mission);
    put(tables.zetaHeader());
    std::string text;
    for (const Sample& sample : mission.recorder().samples()) {
        tables.addZeta(text, sample);
        put(text);
        text.clear();
    }
}

void writeEvents(const Mission& mission, const TextSink& put)
{
    const std::vector<std::string> ids = idFields(std::span(mission.icebergs()));
    const std::vector<std::string> uavs = idFields(std::span(mission.scenario().uavs));
    put("time_s,event,uav,iceberg,detail\n");
    for (const MissionEvent& event : mission.events()) {
        std::string text;
        add(text, event.time_s, ',');
        text += nameOf(kEventNames, event.kind);
        text += ',';
        if (event.uav || uavs.size() == 1) // with one UAV, all events concern it
            text += uavs.at(static_cast<std::size_t>(event.uav.value_or(0)));
        text += ',';
        if (event.iceberg)
            text += ids.at(toIndex(*event.iceberg));
        text += ',' + csvField(eventDetail(event, mission)) + '\n';
        put(text);
    }
}

} // namespace berg
