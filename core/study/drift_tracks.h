#pragma once

#include "core/checks/weather_gate.h"
#include "core/tracking/drift_errors.h"

#include <cstddef>
#include <optional>
#include <stop_token>
#include <string_view>
#include <vector>

namespace berg {

/** Times and coefficients of predicted drift. */
struct DriftTrackSpec
{
    double every_s = 3 * 3600.0;     ///< above 0; time between two points
    double duration_s = 48 * 3600.0; ///< at least 0
    DragCoefficients drag = kCCoreDrag;
};

/** Predicted iceberg at one time. */
struct DriftTrackPoint
{
    double time_s = 0;                ///< run time
    Point position_m = Point::Zero(); ///< in the scenario's plane
    LatLon place;
    Point velocity_mps = Point::Zero(); ///< towards east and north of the plane
    double sd_m = 0;                    ///< standard deviation of the position along each axis
    bool isAground = false;
    /** Distance from the recorded track; nullopt without a track, or outside its times. */
    std::optional<double> error_m;
};

/** Why a predicted track ends. */
enum class DriftTrackEnd : std::uint8_t
{
    Complete,    ///< the duration is over
    ForecastEnds ///< the forecast does not give wind or current, though it does elsewhere
};
/** Returns the name of an end in results: "complete" or "forecast". */
[[nodiscard]] std::string_view nameOf(DriftTrackEnd end);

/** Predicted drift of one iceberg. */
struct DriftTrack
{
    std::size_t iceberg = 0; ///< index in the scenario
    std::vector<DriftTrackPoint> points;
    DriftTrackEnd end = DriftTrackEnd::Complete;
    /** Run time from which it is aground; nullopt if it never is. */
    std::optional<double> grounded_s;
};

/**
 * Returns the law by which wind and current carry the iceberg: `driftLaw` of its length, or the
 * current alone if it has none.
 */
[[nodiscard]] DriftLaw lawOf(const Iceberg& iceberg, const DragCoefficients& drag = kCCoreDrag);

/** Position and own velocity of an iceberg that drifts. */
struct DriftingIceberg
{
    double time_s = 0;
    Point position_m = Point::Zero();
    /** Velocity beside wind and current; fades with `Iceberg::velocityTime_s`. */
    Point own_mps = Point::Zero();
    std::optional<double> grounded_s;
};

/**
 * Predicts the mean drift of one iceberg of a scenario from its estimate at run time 0. Its
 * velocity is `lawOf` with wind and current of its place and time (`ScenarioWeather`) plus its own
 * velocity, which fades as in `Track`. Steps of at most 15 minutes use the forcing at their middle.
 * East and north of the forecast are taken as those of the plane, as in flight. An iceberg whose
 * draft
 * (`dimensionsOfLength`) exceeds the depth of the sea stops for good.
 */
class IcebergDrift
{
public:
    /** Refers to both, which must outlive it. With `fades` false, its velocity is constant. */
    IcebergDrift(const ScenarioWeather& weather, const Iceberg& iceberg,
                 const DragCoefficients& drag, bool fades = true);

    /** Drifts from another position, velocity and time than the estimate at run time 0. */
    IcebergDrift(const ScenarioWeather& weather, const Iceberg& iceberg,
                 const DragCoefficients& drag, const DriftingIceberg& from);

    [[nodiscard]] const DriftingIceberg& now() const { return m_now; }
    /** Returns the velocity now, or nullopt if wind or current is unknown. */
    [[nodiscard]] std::optional<Point> velocity_mps() const;
    /** Drifts on; returns false, at the last step that is known, if the forcing is unknown. */
    [[nodiscard]] bool advance(double until_s);

private:
    [[nodiscard]] std::optional<Point> forced_mps(double time_s) const;
    void checkDepth();

    const ScenarioWeather& m_weather;
    const Iceberg& m_iceberg;
    DriftLaw m_law;
    double m_fade_s; ///< 0 means a constant own velocity
    LocalFrame m_frame;
    DriftingIceberg m_now;
};

/**
 * Predicts the drift of each iceberg of a scenario, with a point at run time 0 and then each
 * `every_s`. The mean is that of `IcebergDrift`. Its spread is that of `initialTrack` for the
 * Kalman observer, grown as `Track` grows it without a sighting (`grown`), whatever the observer of
 * the scenario, and also while it is aground, because its draft is known roughly. A track ends
 * before the first point to which the forcing is not known. Throws `Stopped` if a stop is
 * requested.
 */
[[nodiscard]] std::vector<DriftTrack> driftTracks(const Scenario& scenario,
                                                  const DriftTrackSpec& spec = {},
                                                  const std::stop_token& stop = {});

/** Estimates of the icebergs of a flight at one time. */
struct DriftInstant
{
    double time_s = 0;             ///< run time
    std::vector<Iceberg> icebergs; ///< those of the scenario first
    /** By iceberg, with the variances of `time_s`; nullopt if it is not followed. */
    std::vector<std::optional<Track>> tracks;
    bool operator==(const DriftInstant&) const = default;
};

/**
 * Predicts the drift of the icebergs from an instant of a flight of the scenario, as `driftTracks`
 * does from its start: from their estimates, with a point at that time and then each `every_s`. The
 * spread is that of the Kalman track; with the simple observer it grows from the last sighting, or
 * from the start, as a Kalman track does. An iceberg without a track has no points.
 */
[[nodiscard]] std::vector<DriftTrack> driftTracks(const Scenario& scenario,
                                                  const DriftInstant& instant,
                                                  const DriftTrackSpec& spec = {},
                                                  const std::stop_token& stop = {});

/** Predicts one iceberg of the scenario as `driftTracks` does; requires that there is such an
 * iceberg. */
[[nodiscard]] DriftTrack driftTrack(const Scenario& scenario, std::size_t iceberg,
                                    const DriftTrackSpec& spec = {},
                                    const std::stop_token& stop = {});

/**
 * Compares `lawOf` with the recorded track of an iceberg of the scenario as `driftErrors` does,
 * with wind and current of the forecast at the estimate, else those of the scenario. All counts are
 * 0 without a recorded track.
 */
[[nodiscard]] std::vector<DriftLeadError> recordedDriftErrors(const Scenario& scenario,
                                                              const Iceberg& iceberg,
                                                              const DragCoefficients& drag,
                                                              const std::stop_token& stop = {});

} // namespace berg
