#include "core/io/export/flight_log.h"

#include "core/base/sha256.h"
#include "core/io/export/content/export_flight.h"
#include "core/io/export/missions/plan_wpl.h"
#include "core/scenario/flight_weather.h"
#include "core/scenario/utc_time.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace berg {

namespace {

bool isDeviation(const MissionEvent& event)
{
    switch (event.kind) {
    case EventKind::PlannerFailed:
    case EventKind::Alarm:
    case EventKind::Intervention:
    case EventKind::Lost:
    case EventKind::GivenUp:
    case EventKind::LateHome:
    case EventKind::Close:
    case EventKind::LeftFence:
    case EventKind::BackInside:
        return true;
    case EventKind::Planned:
        return event.fellBack;
    case EventKind::Appeared:
    case EventKind::Sighted:
        return event.reported;
    case EventKind::Reached:
    case EventKind::Left:
    case EventKind::Found:
    case EventKind::HomeBound:
    case EventKind::Landed:
    case EventKind::TookOff:
        break;
    }
    return false;
}

bool isPlannerChange(const MissionEvent& event)
{
    return event.kind == EventKind::Intervention && event.changed == ChangedPart::Planner;
}

/**
 * Merges the many changes of a drag of tau into one event: its time is the start of the drag, its
 * tau the final value.
 */
void addDeviation(std::vector<MissionEvent>& deviations, const MissionEvent& event)
{
    constexpr double kDrag_s = 60;
    if (!deviations.empty() && isPlannerChange(deviations.back()) && isPlannerChange(event) &&
        deviations.back().policy == event.policy &&
        event.time_s - deviations.back().time_s <= kDrag_s)
        deviations.back().tau = event.tau;
    else
        deviations.push_back(event);
}

/** Adds the figures of the first plan, and the hash of its file. */
void addPlanned(LogUav& uav, const Mission& mission, const Plan& plan)
{
    const Scenario& scenario = mission.scenario();
    const std::string& id = scenario.uavs[uav.row].id;
    const ExportContent order = exportContent({.scenario = scenario, .plan = plan},
                                              {.what = ExportScope::Order, .uav = id});
    const ExportUav& planned = order.uavs.front();
    const std::vector<TimedPoint> line = pathOf(planned);
    for (std::size_t i = 1; i < line.size(); ++i)
        uav.plannedLength_m += (line[i].position_m - line[i - 1].position_m).norm();
    uav.plannedTime_s = line.back().time_s - line.front().time_s;
    uav.plannedVisits = static_cast<std::size_t>(std::ranges::count_if(
        planned.visits, [](const Visit& visit) { return visit.iceberg.has_value(); }));
    uav.planHash = sha256Text(wplText(order));
}

/** Reads the samples of the record for UAVs and icebergs, one after the other. */
class RecordReader
{
public:
    RecordReader(const ExportContent& content, FlightLog& log)
        : m_content(content), m_log(log), m_icebergs(content.mission->icebergs().size())
    {
    }

    void read()
    {
        const Recorder& recorder = m_content.mission->recorder();
        IcebergReader reader = recorder.reader();
        const std::vector<Intervention>& changes = m_content.mission->interventions();
        auto next = changes.begin();
        double before_s = 0;
        for (std::size_t row = 0; row < recorder.samples().size(); ++row) {
            const Sample& sample = recorder.samples()[row];
            readUavs(sample, sample.time_s - before_s);
            for (; next != changes.end() && next->time_s <= sample.time_s; ++next)
                readReport(*next);
            readIcebergs(reader.at(row), sample.time_s);
            before_s = sample.time_s;
        }
        for (std::size_t i = 0; i < m_icebergs.size(); ++i)
            if (m_icebergs[i].wasThere) {
                close(m_icebergs[i], m_log.flown_s);
                m_icebergs[i].log.iceberg = IcebergIndex::of(i);
                m_log.icebergs.push_back(m_icebergs[i].log);
            }
    }

private:
    struct Watched
    {
        LogIceberg log;
        std::optional<double> known_s; ///< last sighting, or when it became known
        bool wasThere = false;
    };

    void readUavs(const Sample& sample, double passed_s)
    {
        for (LogUav& uav : m_log.uavs) {
            const UavSample& now = sample.uavs.at(uav.row);
            if (now.onGround) {
                if (uav.tookOff_s && !uav.landed_s)
                    uav.landed_s = sample.time_s;
                continue;
            }
            uav.tookOff_s = uav.tookOff_s.value_or(sample.time_s - passed_s);
            uav.landed_s.reset();
            uav.aloft_s += passed_s;
            if (m_content.operation &&
                !insidePolygon(m_content.operation->outline_m(VolumePart::Geography),
                               now.pose.position_m))
                uav.outside_s += passed_s;
        }
    }

    static void close(Watched& watched, double time_s)
    {
        if (watched.known_s)
            watched.log.longestUnseen_s =
                std::max(watched.log.longestUnseen_s, time_s - *watched.known_s);
    }

    /** Counts a sighting that another observer reported by radio. */
    void readReport(const Intervention& change)
    {
        const std::vector<Iceberg>& icebergs = m_content.mission->icebergs();
        const std::optional<std::string> id =
            change.appears ? std::optional(change.appears->id) : change.seen;
        const std::optional<IcebergIndex> index = id ? indexOfId(icebergs, *id) : std::nullopt;
        if (index && toIndex(*index) < m_icebergs.size())
            see(m_icebergs[toIndex(*index)], change.time_s - (change.seen ? change.seenAge_s : 0));
    }

    static void see(Watched& watched, double time_s)
    {
        close(watched, time_s);
        watched.known_s = std::max(watched.known_s.value_or(time_s), time_s);
        watched.log.first_s = std::min(watched.log.first_s.value_or(time_s), time_s);
        watched.log.last_s = std::max(watched.log.last_s.value_or(time_s), time_s);
    }

    void readIcebergs(const std::vector<IcebergSample>& icebergs, double time_s)
    {
        for (std::size_t i = 0; i < icebergs.size() && i < m_icebergs.size(); ++i) {
            Watched& watched = m_icebergs[i];
            if (!icebergs[i].active) { // not there yet, outside the area or removed
                close(watched, time_s);
                watched.known_s.reset();
                continue;
            }
            watched.wasThere = true;
            watched.log.sigma_m2 = icebergs[i].sigma_m2;
            if (!watched.known_s)
                watched.known_s = time_s;
            if (icebergs[i].inView)
                see(watched, time_s);
        }
    }

    const ExportContent& m_content;
    FlightLog& m_log;
    std::vector<Watched> m_icebergs;
};

/** Reads the forecast of a flight whose scenario has one that is used. */
class ForecastLog
{
public:
    ForecastLog(const ExportContent& content, const FlightWeather& weather)
        : m_content(content)
        , m_weather(weather)
        , m_scenario(content.mission->scenario())
        , m_start(*parseUtc(m_scenario.startUtc))
    {
        for (const Uav& uav : m_scenario.uavs)
            m_middle_m += uav.position_m / static_cast<double>(m_scenario.uavs.size());
    }

    [[nodiscard]] LogForecast read(const FlightLog& log) const
    {
        const Forecast& first = m_scenario.forecast->places.front();
        LogForecast read{.source = first.source, .start = at(0), .end = at(log.flown_s)};
        if (first.issued)
            read.issued_s = std::chrono::duration<double>(*first.issued - m_start).count();
        double takeOff_s = log.flown_s;
        for (const LogUav& uav : log.uavs)
            takeOff_s = std::min(takeOff_s, uav.tookOff_s.value_or(takeOff_s));
        if (read.issued_s)
            read.ageAtTakeOff_h = (takeOff_s - *read.issued_s) / kHour_s;
        addGaps(read, ForecastQuantity::Wind, windUntil_s(log.flown_s));
        addGaps(read, ForecastQuantity::Current, log.flown_s);
        return read;
    }

private:
    static constexpr double kHour_s = 3600;

    [[nodiscard]] LogWeather at(double time_s) const
    {
        const auto trueOf_mps = [this](const Point& velocity_mps) {
            return eastNorth_mps(m_content, velocity_mps, m_middle_m);
        };
        const bool isReported = time_s > windUntil_s(time_s);
        const Point wind_mps = isReported ? m_content.mission->simulation().motion(0).wind_mps
                                          : WindAhead(m_weather.wind(), time_s).at_mps(0);
        return {.time_s = time_s,
                .wind_mps = trueOf_mps(wind_mps),
                .gust_mps = m_weather.gust_mps(time_s),
                .current_mps = trueOf_mps(m_weather.forcingAt(m_middle_m, time_s).current_mps)};
    }

    /** Returns when the crew's first report replaced the wind of the forecast, at most `end_s`. */
    [[nodiscard]] double windUntil_s(double end_s) const
    {
        for (const Intervention& change : m_content.mission->interventions())
            if (change.wind_mps)
                return std::min(end_s, change.time_s);
        return end_s;
    }

    void addGaps(LogForecast& read, ForecastQuantity quantity, double end_s) const
    {
        constexpr double kGapStep_s = 60;
        const ForecastField& field = *m_scenario.forecast;
        const bool isGiven = std::ranges::any_of(
            field.places, [quantity](const Forecast& place) { return gives(place, quantity); });
        if (!isGiven)
            return;
        const Forecast local =
            forecastAt(field, LocalFrame(m_scenario.origin).toGeographic(m_middle_m));
        bool isInGap = false;
        for (double time_s = 0; time_s <= end_s; time_s += kGapStep_s) {
            const auto time = m_start + std::chrono::milliseconds(std::llround(1000 * time_s));
            const bool isMissing = !gives(entryAt(local, time), quantity);
            if (isMissing && !isInGap)
                read.gaps.push_back({.quantity = quantity, .from_s = time_s, .to_s = end_s});
            else if (!isMissing && isInGap)
                read.gaps.back().to_s = time_s;
            isInGap = isMissing;
        }
    }

    const ExportContent& m_content;
    const FlightWeather& m_weather;
    const Scenario& m_scenario;
    ForecastTime m_start;
    Point m_middle_m = Point::Zero();
};

} // namespace

FlightLog flightLog(const ExportContent& content)
{
    if (content.mission == nullptr)
        throw Error(ErrorCode::InvalidInput, "format", {IssueId::NothingFlown});
    const Mission& mission = *content.mission;
    FlightLog log{.flown_s = mission.simulation().time_s(),
                  .metrics = mission.metrics(),
                  .predicted = content.predicted,
                  .wasChanged = !mission.interventions().empty()};
    const Plan none;
    const Plan& plan = mission.plans().empty() ? none : *mission.plans().front();
    for (std::size_t row = 0; row < mission.scenario().uavs.size(); ++row) {
        LogUav uav{.row = row,
                   .visits = mission.visits(static_cast<int>(row)),
                   .flown_m = mission.simulation().uav(static_cast<int>(row)).flown_m};
        addPlanned(uav, mission, plan);
        log.uavs.push_back(std::move(uav));
    }
    RecordReader(content, log).read();
    for (const MissionEvent& event : mission.events()) {
        if (event.kind == EventKind::Reached)
            for (LogIceberg& iceberg : log.icebergs)
                if (event.iceberg == iceberg.iceberg ||
                    std::ranges::find(event.together, iceberg.iceberg) != event.together.end())
                    ++iceberg.visits;
        if (isDeviation(event))
            addDeviation(log.deviations, event);
    }
    if (const auto& weather = mission.simulation().world().weather())
        log.forecast = ForecastLog(content, *weather).read(log);
    return log;
}

} // namespace berg
