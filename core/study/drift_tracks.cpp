#include "core/study/drift_tracks.h"

#include "core/base/error.h"
#include "core/base/stopped.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

constexpr double kLongestDriftStep_s = 900;

/** Returns the distance from the recorded track, or nullopt outside its times. */
std::optional<double> distanceFrom_m(const RecordedTrack& track, double time_s,
                                     const Point& position_m)
{
    if (track.empty() || time_s < track.time_s.front() || time_s > track.time_s.back())
        return std::nullopt;
    return (track.at(time_s) - position_m).norm();
}

/** Start of a prediction. */
struct TrackStart
{
    DriftingIceberg from;
    Track known; ///< with the variances of that time
};

TrackStart startOf(const Iceberg& iceberg)
{
    return {.from = {.position_m = iceberg.position_m, .own_mps = iceberg.velocity_mps},
            .known = initialTrack(iceberg, ObserverModel::Kalman)};
}

/** Returns the track with the variances of a Kalman filter, whatever the observer. */
Track knownTrack(const Iceberg& iceberg, const Track& track, ObserverModel model, double time_s)
{
    if (model == ObserverModel::Kalman)
        return track;
    Track known = initialTrack(iceberg, ObserverModel::Kalman);
    const double before_s = std::max(0.0, track.seen_s - iceberg.appears_s);
    DriftVariances variances = grown(known.variances(), known.process(), before_s);
    if (before_s > 0)
        variances = {.velocity_m2ps2 = variances.velocity_m2ps2};
    known.setVariances(grown(variances, known.process(), std::max(0.0, time_s - track.seen_s)));
    return known;
}

TrackStart startAt(const Iceberg& iceberg, const Track& track, ObserverModel model, double time_s)
{
    return {.from = {.time_s = time_s,
                     .position_m = track.estimate_m(time_s),
                     .own_mps = track.velocity_mps - track.mean_mps},
            .known = knownTrack(iceberg, track, model, time_s)};
}

/** Predicts one iceberg. */
DriftTrack trackOf(const ScenarioWeather& weather, const Iceberg& iceberg, std::size_t index,
                   const TrackStart& start, const DriftTrackSpec& spec, const std::stop_token& stop)
{
    constexpr double kRounding = 1e-9;
    const LocalFrame frame(weather.origin());
    IcebergDrift drift(weather, iceberg, spec.drag, start.from);
    DriftTrack track{.iceberg = index};
    const double intervals = std::floor(spec.duration_s / spec.every_s + kRounding);
    for (double k = 0; k <= intervals; ++k) {
        throwIfStopped(stop);
        const double after_s = k * spec.every_s;
        const double time_s = start.from.time_s + after_s;
        const bool isKnown = drift.advance(time_s);
        const std::optional<Point> velocity_mps = isKnown ? drift.velocity_mps() : std::nullopt;
        if (!velocity_mps) {
            track.end = DriftTrackEnd::ForecastEnds;
            break;
        }
        const DriftingIceberg& now = drift.now();
        track.points.push_back({.time_s = time_s,
                                .position_m = now.position_m,
                                .place = frame.toGeographic(now.position_m),
                                .velocity_mps = *velocity_mps,
                                .sd_m = std::sqrt(start.known.sigmaAfter_m2(after_s)),
                                .isAground = now.grounded_s.has_value(),
                                .error_m = distanceFrom_m(iceberg.track, time_s, now.position_m)});
    }
    track.grounded_s = drift.now().grounded_s;
    return track;
}

} // namespace

std::string_view nameOf(DriftTrackEnd end)
{
    return end == DriftTrackEnd::Complete ? "complete" : "forecast";
}

DriftLaw lawOf(const Iceberg& iceberg, const DragCoefficients& drag)
{
    return iceberg.length_m ? driftLaw(*iceberg.length_m, drag) : DriftLaw{};
}

IcebergDrift::IcebergDrift(const ScenarioWeather& weather, const Iceberg& iceberg,
                           const DragCoefficients& drag, bool fades)
    : m_weather(weather)
    , m_iceberg(iceberg)
    , m_law(lawOf(iceberg, drag))
    , m_fade_s(fades ? iceberg.velocityTime_s : 0)
    , m_frame(weather.origin())
    , m_now{.position_m = iceberg.position_m, .own_mps = iceberg.velocity_mps}
{
    checkDepth();
}

IcebergDrift::IcebergDrift(const ScenarioWeather& weather, const Iceberg& iceberg,
                           const DragCoefficients& drag, const DriftingIceberg& from)
    : m_weather(weather)
    , m_iceberg(iceberg)
    , m_law(lawOf(iceberg, drag))
    , m_fade_s(iceberg.velocityTime_s)
    , m_frame(weather.origin())
    , m_now(from)
{
    checkDepth();
}

void IcebergDrift::checkDepth()
{
    if (m_now.grounded_s || !m_iceberg.length_m)
        return;
    const std::optional<double> depth_m = m_weather.depth_m(m_now.position_m);
    if (depth_m && dimensionsOfLength(*m_iceberg.length_m).draft_m > *depth_m)
        m_now.grounded_s = m_now.time_s;
}

std::optional<Point> IcebergDrift::forced_mps(double time_s) const
{
    const ForecastEntry weather = m_weather.at(time_s, m_now.position_m);
    if (!weather.current_mps || (m_law.windShare != 0 && !weather.wind_mps))
        return std::nullopt;
    return driftVelocity_mps(
        m_law,
        {.wind_mps = weather.wind_mps.value_or(Point::Zero()), .current_mps = *weather.current_mps},
        m_frame.toGeographic(m_now.position_m).latitude_deg);
}

std::optional<Point> IcebergDrift::velocity_mps() const
{
    if (m_now.grounded_s)
        return Point(Point::Zero());
    const std::optional<Point> forced = forced_mps(m_now.time_s);
    return forced ? std::optional<Point>(*forced + m_now.own_mps) : std::nullopt;
}

bool IcebergDrift::advance(double until_s)
{
    const double left_s = until_s - m_now.time_s;
    const double start_s = m_now.time_s;
    const double steps = std::ceil(left_s / kLongestDriftStep_s);
    const double step_s = steps > 0 ? left_s / steps : 0;
    for (double k = 0; k < steps; ++k) {
        if (!m_now.grounded_s) {
            const std::optional<Point> forced = forced_mps(m_now.time_s + step_s / 2);
            if (!forced)
                return false;
            m_now.position_m += *forced * step_s + m_now.own_mps * carriedFor_s(m_fade_s, step_s);
        }
        if (m_fade_s > 0)
            m_now.own_mps *= std::exp(-step_s / m_fade_s);
        m_now.time_s = start_s + (k + 1) * step_s;
        checkDepth();
    }
    return true;
}

DriftTrack driftTrack(const Scenario& scenario, std::size_t iceberg, const DriftTrackSpec& spec,
                      const std::stop_token& stop)
{
    require(spec.every_s > 0 && spec.duration_s >= 0 && iceberg < scenario.icebergs.size(),
            "driftTrack: spec or iceberg");
    const Iceberg& only = scenario.icebergs[iceberg];
    return trackOf(ScenarioWeather(scenario), only, iceberg, startOf(only), spec, stop);
}

std::vector<DriftTrack> driftTracks(const Scenario& scenario, const DriftTrackSpec& spec,
                                    const std::stop_token& stop)
{
    require(spec.every_s > 0 && spec.duration_s >= 0, "driftTracks: duration or interval");
    const ScenarioWeather weather(scenario);
    std::vector<DriftTrack> tracks;
    for (std::size_t i = 0; i < scenario.icebergs.size(); ++i)
        tracks.push_back(
            trackOf(weather, scenario.icebergs[i], i, startOf(scenario.icebergs[i]), spec, stop));
    return tracks;
}

std::vector<DriftTrack> driftTracks(const Scenario& scenario, const DriftInstant& instant,
                                    const DriftTrackSpec& spec, const std::stop_token& stop)
{
    require(spec.every_s > 0 && spec.duration_s >= 0, "driftTracks: duration or interval");
    require(instant.tracks.size() == instant.icebergs.size(), "driftTracks: instant");
    const ScenarioWeather weather(scenario);
    std::vector<DriftTrack> tracks;
    for (std::size_t i = 0; i < instant.icebergs.size(); ++i) {
        const Iceberg& iceberg = instant.icebergs[i];
        if (const std::optional<Track>& known = instant.tracks[i])
            tracks.push_back(trackOf(
                weather, iceberg, i,
                startAt(iceberg, *known, scenario.observer.model, instant.time_s), spec, stop));
        else
            tracks.push_back({.iceberg = i});
    }
    return tracks;
}

std::vector<DriftLeadError> recordedDriftErrors(const Scenario& scenario, const Iceberg& iceberg,
                                                const DragCoefficients& drag,
                                                const std::stop_token& stop)
{
    const LocalFrame frame(scenario.origin);
    const std::optional<ForecastTime> start = startTime(scenario);
    const double start_s =
        start ? std::chrono::duration<double>(start->time_since_epoch()).count() : 0;
    PlacedTrack placed;
    for (std::size_t i = 0; i < iceberg.track.time_s.size(); ++i)
        placed.push_back({.time_s = start_s + iceberg.track.time_s[i],
                          .place = frame.toGeographic(iceberg.track.position_m[i])});
    Forecast forecast;
    if (start && scenario.forecast && isGrid(*scenario.forecast))
        forecast = forecastAt(*scenario.forecast, frame.toGeographic(iceberg.position_m));
    const ForcingAt forcing =
        forcingOf(forecast, {.wind_mps = scenario.wind_mps, .current_mps = scenario.current_mps});
    return driftErrors({&placed, 1}, lawOf(iceberg, drag), forcing, {}, stop);
}

} // namespace berg
