#pragma once

#include "core/base/random.h"
#include "core/scenario/scenario.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace berg::test {

/** Draws whole valid scenarios in which every field also takes unusual values. */
class AnyScenario
{
public:
    explicit AnyScenario(std::uint64_t seed) : m_random(seed, 4711) {}

    Scenario draw()
    {
        Scenario s;
        s.name = text();
        s.notes = text();
        s.origin = {.latitude_deg = number(-90, 90), .longitude_deg = number(-180, 180)};
        if (often())
            s.startUtc = "2024-02-29T23:59:59.125Z";
        s.duration_s = number(1, 604800);
        s.seed = static_cast<std::int64_t>(m_random.below((std::uint64_t{1} << 53U) + 1));
        s.dt_s = number(0.01, 1);
        s.noise = often();
        if (often())
            s.wind_mps = point(10);
        if (often())
            s.current_mps = point(5);
        if (often())
            s.area_m = star();
        s.geofence = !s.area_m.empty() && often();
        const std::uint64_t uavs = 1 + m_random.below(3);
        for (std::uint64_t i = 0; i < uavs; ++i)
            s.uavs.push_back(uav(s.geofence ? 100 : 1e6));
        const std::uint64_t icebergs = m_random.below(6);
        for (std::uint64_t i = 0; i < icebergs; ++i) {
            s.icebergs.push_back(iceberg());
            if (often())
                s.icebergs.back().uav = s.uavs[m_random.below(s.uavs.size())].id;
        }
        s.separation_m = number(0, 1e6);
        if (often())
            s.asset = asset();
        s.planner = planner();
        if (often())
            s.observer = {.model = often() ? ObserverModel::Kalman : ObserverModel::Simple,
                          .positionSd_m = number(0, 100),
                          .interval_s = number(1, 60),
                          .detection = number(0.01, 1),
                          .search = static_cast<SearchPattern>(m_random.below(3))};
        s.clusters = often();
        s.observerExtraJson = extra();
        if (often())
            s.reachRadius_m = number(1, 500);
        s.fovShape = static_cast<FovShape>(m_random.below(3));
        s.plannerExtraJson = extra();
        s.originExtraJson = extra();
        s.extraJson = extra();
        return s;
    }

private:
    bool often() { return m_random.below(2) == 0; }

    /**
     * Returns a number in the range: sometimes a limit, a round number or one that needs 17 digits.
     */
    double number(double low, double high)
    {
        switch (m_random.below(6)) {
        case 0:
            return low;
        case 1:
            return high;
        case 2:
            return std::clamp(std::round(m_random.uniform(low, high)), low, high);
        case 3:
            return low < 0 ? -0.1 : low + (high - low) * 0x1.0p-52; // one of the next doubles
        default:
            return m_random.uniform(low, high);
        }
    }
    Point point(double largest) { return {number(-largest, largest), number(-largest, largest)}; }
    std::string text()
    {
        static const std::array<std::string, 7> kTexts = {
            "",
            "Grønland, 12 isfjell",
            "quote \" backslash \\ slash /",
            "line\nbreak\ttab\rreturn",
            std::string("nul \0 and bell \a", 16),
            "\xF0\x9F\xA7\x8A \xE6\xB5\xB7\xE5\x86\xB0 \xEF\xBB\xBF",
            "{\"not\": [\"json\"]}"};
        return kTexts[m_random.below(kTexts.size())];
    }
    /** Returns members of a newer version, as compact text. */
    std::string extra()
    {
        static const std::array<std::string, 4> kExtras = {
            "", R"({"later":1.25})", R"({"b":{"deep":[1,[2,{"x":null}],"é"]},"a":true})",
            R"({"big":18446744073709551615,"small":-1e-300,"text":"\u0001"})"};
        return kExtras[m_random.below(kExtras.size())];
    }
    std::string id(const std::string& prefix)
    {
        return prefix + std::to_string(++m_lastId) + (often() ? "" : text());
    }
    /** Returns a polygon around its centre, corner by corner, so that it cannot cross itself. */
    std::vector<Point> star()
    {
        std::vector<Point> corners_m;
        const std::uint64_t count = 3 + m_random.below(6);
        for (std::uint64_t i = 0; i < count; ++i) {
            const double angle_rad = 6.283 * static_cast<double>(i) / static_cast<double>(count);
            const double radius_m = m_random.uniform(1000, 9000);
            corners_m.emplace_back(radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad));
        }
        return corners_m;
    }
    Uav uav(double farthest_m)
    {
        Uav uav;
        uav.id = id("uav ");
        uav.name = text();
        uav.position_m = point(farthest_m);
        if (often())
            uav.home_m = point(farthest_m);
        uav.turnaround_s = number(0, 1e6);
        uav.heading_deg = number(-720, 720);
        uav.spec = {.airspeed_mps = number(15, 40),
                    .maxBank_deg = number(1, 80),
                    .altitude_m = number(10, 5000),
                    .endurance_s = often() ? 0 : number(1, 86400)};
        uav.fov_m = {number(1, 2000), number(1, 2000)};
        uav.aircraft =
            readyProfiles()[static_cast<std::size_t>(m_lastId) % readyProfiles().size()].profile;
        uav.extraJson = extra();
        return uav;
    }
    Iceberg iceberg()
    {
        Iceberg iceberg;
        iceberg.id = id("berg ");
        iceberg.name = text();
        iceberg.position_m = point(1e6);
        iceberg.velocity_mps = point(5);
        iceberg.velocitySd_mps = number(0, 5);
        iceberg.velocitySpread_mps = number(0, 5);
        iceberg.velocityTime_s = often() ? number(0, 1e9) : 0;
        iceberg.q_m2ps = number(0, 10);
        iceberg.sigma0_m2 = number(0, 1e6);
        iceberg.observed_s = number(0, 1e6);
        iceberg.appears_s = number(0, 1e6);
        iceberg.radius_m = number(0, 1000);
        if (often()) {
            iceberg.track = track();
            iceberg.trackExtraJson = extra();
        }
        iceberg.extraJson = extra();
        return iceberg;
    }
    RecordedTrack track()
    {
        RecordedTrack track;
        double time_s = number(-1000, 1000);
        for (std::uint64_t count = 2 + m_random.below(5); count > 0; --count) {
            track.time_s.push_back(time_s);
            track.position_m.push_back(point(1e6));
            time_s += m_random.uniform(1e-3, 1e4);
        }
        return track;
    }
    Asset asset()
    {
        Asset asset;
        asset.name = text();
        asset.position_m = point(1e6);
        asset.velocity_mps = point(20);
        asset.range_m = number(1, 1e6);
        asset.gain = number(0, 100);
        asset.extraJson = extra();
        return asset;
    }
    PlannerSettings planner()
    {
        return {.policy = static_cast<PolicyKind>(m_random.below(7)),
                .tau = number(0, 100),
                .route = static_cast<Route>(m_random.below(2)),
                .backend = static_cast<Backend>(m_random.below(4)),
                .formulation = static_cast<Formulation>(m_random.below(3))};
    }

    Random m_random;
    int m_lastId = 0;
};

} // namespace berg::test
