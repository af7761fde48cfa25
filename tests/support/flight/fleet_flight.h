#pragma once

#include "core/base/angles.h"
#include "core/coverage/prediction_input.h"
#include "core/plan/policy/policy.h"
#include "core/scenario/scenario.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace berg::test {

/**
 * Several UAVs over icebergs with known drift: each flies one leg, a Dubins step at a time; sigma
 * is 0 in view of any UAV and grows by q otherwise.
 */
class FleetFlight
{
public:
    explicit FleetFlight(const Scenario& scenario) : m_scenario(scenario), m_dt_s(scenario.dt_s)
    {
        for (const Uav& uav : scenario.uavs) {
            Flyer flyer{
                .state = {.position_m = uav.position_m, .psi_rad = psiFromHeading(uav.heading_deg)},
                .motion = {.airspeed_mps = uav.spec.airspeed_mps,
                           .limit_radps = maxTurnRate_radps(uav.spec),
                           .wind_mps = scenario.wind_mps},
                .sensor = {.fov_m = uav.fov_m, .shape = scenario.fovShape}};
            m_flyers.push_back(flyer);
        }
        for (const Iceberg& iceberg : scenario.icebergs)
            m_tracks.push_back({.anchor_m = iceberg.position_m,
                                .velocity_mps = iceberg.velocity_mps,
                                .sigma_m2 = initialSigma_m2(iceberg),
                                .q_m2ps = iceberg.q_m2ps});
        m_assigned.assign(m_tracks.size(), -1);
        observe();
    }

    [[nodiscard]] double time_s() const { return static_cast<double>(m_step) * m_dt_s; }
    [[nodiscard]] double zeta_m2s() const { return m_zeta_m2s; }
    [[nodiscard]] const Track& track(int iceberg) const { return m_tracks[at(iceberg)]; }
    [[nodiscard]] const DubinsState& uav(int uav) const { return m_flyers[at(uav)].state; }
    [[nodiscard]] int target(int uav) const { return m_flyers[at(uav)].target; }
    /** Assigns the iceberg to this UAV alone; −1 lets any UAV visit it. */
    void assign(int iceberg, int uav) { m_assigned[at(iceberg)] = uav; }
    [[nodiscard]] int assignedUav(int iceberg) const { return m_assigned[at(iceberg)]; }

    [[nodiscard]] PlanRequest request(std::span<const IcebergList> lastRests = {}) const
    {
        PlanRequest request{.sigma_m2 = {0}, .speed_mps = m_flyers[0].motion.airspeed_mps};
        for (int i = 0; i < static_cast<int>(m_tracks.size()); ++i) {
            request.ids.push_back(IcebergIndex::of(i));
            request.sigma_m2.push_back(track(i).sigma_m2);
        }
        for (int u = 0; u < static_cast<int>(m_flyers.size()); ++u)
            request.uavs.push_back(uavRequest(u));
        for (std::size_t u = 0; u < lastRests.size(); ++u)
            request.uavs[u].lastRest = lastRests[u];
        const auto m = static_cast<Eigen::Index>(m_flyers.size());
        request.betweenUavs_m.resize(m, m);
        for (Eigen::Index a = 0; a < m; ++a)
            for (Eigen::Index b = 0; b < m; ++b)
                request.betweenUavs_m(a, b) =
                    (uav(static_cast<int>(a)).position_m - uav(static_cast<int>(b)).position_m)
                        .norm();
        return request;
    }

    /** Sets the target of a UAV; −1 makes it hold. */
    void setLeg(int uav, int target, const std::optional<AimedLeg>& aim = std::nullopt)
    {
        Flyer& flyer = m_flyers[at(uav)];
        flyer.target = target;
        flyer.aim = aim;
        flyer.guidance.startLeg(aim ? aim->from_m : flyer.state.position_m);
    }

    /**
     * Advances one step. Returns true if an iceberg came into view or an aimed leg is 2 s overdue.
     */
    bool advance()
    {
        ++m_step;
        bool isOverdue = false;
        for (Flyer& flyer : m_flyers) {
            const double u_radps = steer(flyer);
            flyer.state = step(flyer.state, flyer.motion.airspeed_mps, u_radps, m_dt_s,
                               flyer.motion.wind_mps);
            isOverdue = isOverdue || (flyer.aim && time_s() > flyer.aim->sighting_s + 2);
        }
        const bool isNew = observe();
        for (Track& track : m_tracks) {
            if (!track.inView)
                track.grow(m_dt_s);
            m_zeta_m2s += track.sigma_m2 * m_dt_s;
        }
        return isNew || isOverdue;
    }

private:
    struct Flyer
    {
        DubinsState state;
        Motion motion;
        SensorSpec sensor;
        int target = -1;
        std::optional<AimedLeg> aim;
        LosGuidance guidance;
    };

    static std::size_t at(int i) { return static_cast<std::size_t>(i); }

    [[nodiscard]] UavRequest uavRequest(int uav) const
    {
        const Flyer& flyer = m_flyers[at(uav)];
        UavRequest request{.uav = uav};
        std::vector<Point> places_m{flyer.state.position_m};
        for (int i = 0; i < static_cast<int>(m_tracks.size()); ++i) {
            const bool isOurs = assignedUav(i) < 0 || assignedUav(i) == uav;
            request.available.push_back(!track(i).inView && isOurs);
            places_m.push_back(track(i).estimate_m(time_s()));
        }
        const auto n = static_cast<Eigen::Index>(places_m.size());
        request.distance_m.resize(n, n);
        for (Eigen::Index a = 0; a < n; ++a)
            for (Eigen::Index b = 0; b < n; ++b)
                request.distance_m(a, b) =
                    m_flyers[0].motion.airspeed_mps *
                    flightTime_s(places_m[static_cast<std::size_t>(b)] -
                                     places_m[static_cast<std::size_t>(a)],
                                 flyer.motion.airspeed_mps, flyer.motion.wind_mps);
        request.prediction = std::make_shared<const PredictionInput>(
            PredictionInput{.time_s = time_s(),
                            .until_s = m_scenario.duration_s,
                            .uav = flyer.state,
                            .motion = flyer.motion,
                            .sensor = flyer.sensor,
                            .tracks = m_tracks,
                            .seed = static_cast<std::uint64_t>(m_scenario.seed),
                            .step = m_step});
        return request;
    }

    double steer(Flyer& flyer) const
    {
        const double limit_radps = flyer.motion.limit_radps;
        if (flyer.target < 0)
            return limit_radps / 1.2;
        if (flyer.aim && flyer.aim->turn_rad != 0) {
            const double u_radps =
                std::clamp(flyer.aim->turn_rad / m_dt_s, -limit_radps, limit_radps);
            const bool isLast = std::abs(u_radps) < limit_radps;
            flyer.aim->turn_rad = isLast ? 0 : flyer.aim->turn_rad - u_radps * m_dt_s;
            return u_radps;
        }
        const Point end_m =
            flyer.aim ? flyer.aim->abeam_m : track(flyer.target).estimate_m(time_s());
        const LosGuidance::Command command =
            flyer.guidance.steer(flyer.state, end_m, flyer.motion, m_dt_s);
        if (command.passedEnd && !flyer.aim)
            flyer.guidance.startLeg(flyer.state.position_m);
        return command.u_radps;
    }

    bool observe()
    {
        bool isNew = false;
        for (Track& track : m_tracks) {
            const Point place_m = track.estimate_m(time_s());
            const bool wasInView = track.inView;
            track.inView = false;
            for (const Flyer& flyer : m_flyers)
                if (FieldOfView(flyer.sensor, flyer.state.position_m, flyer.state.psi_rad)
                        .contains(place_m))
                    track.seen(place_m, time_s());
            isNew = isNew || (track.inView && !wasInView);
        }
        return isNew;
    }

    Scenario m_scenario;
    double m_dt_s;
    std::int64_t m_step = 0;
    double m_zeta_m2s = 0;
    std::vector<Flyer> m_flyers;
    std::vector<Track> m_tracks;
    std::vector<int> m_assigned;
};

/** Returns the scenario with `uavs` copies of its UAV, each a kilometre farther north. */
inline Scenario withUavs(Scenario scenario, int uavs)
{
    for (int u = 1; u < uavs; ++u) {
        Uav uav = scenario.uavs[0];
        uav.id += "-" + std::to_string(u + 1);
        uav.position_m.y() += 1000 * u;
        scenario.uavs.push_back(uav);
    }
    return scenario;
}

} // namespace berg::test
