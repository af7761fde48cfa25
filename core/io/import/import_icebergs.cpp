#include "core/io/import/import_icebergs.h"

#include "core/base/angles.h"
#include "core/scenario/validate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace berg {

namespace {

bool onPlane(const Point& position_m)
{
    return position_m.allFinite() && position_m.cwiseAbs().maxCoeff() <= kLargestCoordinate_m;
}

// So many parts of 1 are velocities and q rounded to.
constexpr double kEstimatedParts = 1e5;
constexpr double kGivenParts = 1e7; ///< an export read back is the same in another plane

/** Speed and direction as true east and north. */
Point driftOf(double speed_mps, double direction_deg)
{
    const double direction_rad = radFromDeg(direction_deg);
    return speed_mps * Point(std::sin(direction_rad), std::cos(direction_rad));
}

/** Gathers what is found about one iceberg. */
class Entry
{
public:
    Entry(const SightedIceberg& sighted, const Iceberg* known, const IcebergSetting& setting)
        : m_sighted(sighted), m_known(known), m_setting(setting)
    {
        m_report.id = sighted.id;
        m_report.sightings = sighted.sightings.size();
        if (known != nullptr)
            m_iceberg = *known;
        else
            m_iceberg = {.id = sighted.id,
                         .q_m2ps = setting.options.q_m2ps,
                         .sigma0_m2 = setting.options.sigma0_m2};
        for (const PlacedSighting& placed : sighted.sightings)
            if (placed.fix.time_s <= 0) {
                m_past.push_back(placed.fix);
                m_pastSightings.push_back(&placed);
            }
    }

    IcebergEntry take()
    {
        if (m_past.empty())
            leaveOut(ImportNote::SeenLater);
        else
            build();
        return {.iceberg = std::move(m_iceberg), .report = std::move(m_report)};
    }

private:
    void note(ImportNote what) { m_report.notes.push_back(what); }
    void leaveOut(ImportNote why)
    {
        m_report.outcome = ImportOutcome::LeftOut;
        m_report.notes = {why};
    }

    void build()
    {
        m_estimate = estimateTrack(m_past, m_setting.options.track);
        m_last = m_pastSightings[m_estimate.last];
        m_report.used = m_estimate.used;
        m_report.age_s = 0.0 - m_last->fix.time_s; // not -0
        // A sighting without time is of now whatever is known.
        if (m_known != nullptr && m_last->timeKnown &&
            m_report.age_s > m_known->observed_s + kTimeRounding_s) {
            m_report.outcome = ImportOutcome::Unchanged;
            note(ImportNote::Older);
            return;
        }
        if (m_estimate.repeated > 0)
            note(ImportNote::Repeated);
        if (m_estimate.jumped > 0)
            note(ImportNote::Jumped);
        setMotion();
        setRest();
        const Point drift_mps = m_iceberg.velocity_mps + m_setting.current_mps;
        m_iceberg.position_m = toCentimetre(m_last->fix.position_m + drift_mps * m_report.age_s);
        if (!onPlane(m_iceberg.position_m)) {
            leaveOut(ImportNote::DriftedAway);
            return;
        }
        if (m_setting.options.withTracks)
            attachTrack();
        if (m_known == nullptr)
            m_report.outcome = ImportOutcome::Added;
        else
            m_report.outcome =
                m_iceberg == *m_known ? ImportOutcome::Unchanged : ImportOutcome::Updated;
    }

    void setMotion()
    {
        const Sighting& last = *m_last->sighting;
        const std::optional<Point> given_mps = givenDrift();
        const bool aground = last.grounded || m_estimate.stationary;
        if (aground) {
            note(ImportNote::Stationary);
            m_iceberg.q_m2ps = 0;
            setDrift(Point::Zero(), kGivenParts);
        } else if (given_mps) {
            note(ImportNote::VelocityGiven);
            setDrift(*given_mps, kGivenParts);
        } else if (m_estimate.velocity_mps) {
            m_clamped = m_estimate.velocityClamped;
            setDrift(*m_estimate.velocity_mps, kEstimatedParts);
        } else {
            // Of one that is there already the velocity is known as well as before.
            note(ImportNote::VelocityUnknown);
        }
        if (m_clamped)
            note(ImportNote::VelocityClamped);
        if (last.q_m2ps) {
            m_iceberg.q_m2ps = *last.q_m2ps;
        } else if (m_estimate.q_m2ps && !aground) {
            m_iceberg.q_m2ps = std::round(*m_estimate.q_m2ps * kEstimatedParts) / kEstimatedParts;
            note(ImportNote::GrowthEstimated);
            if (m_estimate.growthClamped)
                note(ImportNote::GrowthClamped);
        }
    }

    /** Over ground, as the last sighting tells it. */
    [[nodiscard]] std::optional<Point> givenDrift() const
    {
        const Sighting& last = *m_last->sighting;
        if (last.drift_mps)
            return inPlane(*last.drift_mps);
        if (last.speed_mps && *last.speed_mps == 0)
            return Point(Point::Zero());
        if (last.speed_mps && last.direction_deg)
            return inPlane(driftOf(*last.speed_mps, *last.direction_deg));
        return std::nullopt;
    }

    [[nodiscard]] Point inPlane(const Point& drift_mps) const
    {
        return turned(drift_mps, m_setting.frame.trueNorth_rad(m_last->sighting->place));
    }

    /** `total_mps` over ground; the scenario adds its current to the iceberg's own velocity. */
    void setDrift(const Point& total_mps, double parts)
    {
        const Point exact_mps = total_mps - m_setting.current_mps;
        const Point own_mps = (exact_mps * parts).array().round() / parts;
        m_iceberg.velocity_mps =
            own_mps.cwiseMax(-kLargestVelocity_mps).cwiseMin(kLargestVelocity_mps);
        m_clamped = m_clamped || m_iceberg.velocity_mps != own_mps;
    }

    void setRest()
    {
        const Sighting& last = *m_last->sighting;
        m_iceberg.observed_s = std::min(m_report.age_s, kLargestTime_s);
        if (last.sigma_m2)
            m_iceberg.sigma0_m2 = *last.sigma_m2;
        if (last.appearsIn_s)
            m_iceberg.appears_s =
                std::clamp(*last.appearsIn_s - m_report.age_s, 0.0, kLargestTime_s);
        // Name and size need not be told at each sighting: the latest word counts.
        double radiusFrom_s = -std::numeric_limits<double>::infinity();
        for (const PlacedSighting* placed : m_pastSightings) {
            if (m_iceberg.name.empty())
                m_iceberg.name = placed->sighting->name;
            if (placed->sighting->radius_m && placed->fix.time_s >= radiusFrom_s) {
                radiusFrom_s = placed->fix.time_s;
                m_iceberg.radius_m = *placed->sighting->radius_m;
            }
        }
    }

    void attachTrack()
    {
        std::vector<Fix> fixes;
        for (const PlacedSighting& placed : m_sighted.sightings)
            if (placed.timeKnown && std::abs(placed.fix.time_s) <= kLargestTime_s)
                fixes.push_back(placed.fix);
        RecordedTrack whole;
        for (const std::size_t i : consistentFixes(fixes, m_setting.options.track).indices) {
            whole.time_s.push_back(fixes[i].time_s);
            whole.position_m.push_back(fixes[i].position_m);
        }
        if (whole.empty() || whole.time_s.back() <= 0) {
            note(ImportNote::NoTrack);
            return;
        }
        RecordedTrack track{.time_s = {0}, .position_m = {toCentimetre(whole.at(0))}};
        for (std::size_t i = 0; i < whole.time_s.size(); ++i)
            if (whole.time_s[i] > 0) {
                track.time_s.push_back(whole.time_s[i]);
                track.position_m.push_back(toCentimetre(whole.position_m[i]));
            }
        double tolerance_m = m_setting.options.tolerance_m;
        m_iceberg.track = thinned(track, tolerance_m);
        while (m_iceberg.track.time_s.size() > kMostTrackPoints)
            m_iceberg.track = thinned(track, tolerance_m = 2 * std::max(1.0, tolerance_m));
        note(ImportNote::TrackAttached);
    }

    static constexpr double kTimeRounding_s = 0.002;

    const SightedIceberg& m_sighted;
    const Iceberg* m_known;
    const IcebergSetting& m_setting;
    Iceberg m_iceberg;
    ImportedIceberg m_report;
    std::vector<Fix> m_past; ///< at or before t = 0
    std::vector<const PlacedSighting*> m_pastSightings;
    TrackEstimate m_estimate;
    const PlacedSighting* m_last = nullptr;
    bool m_clamped = false;
};

} // namespace

Point toCentimetre(const Point& position_m)
{
    return (position_m * 100).array().round() / 100;
}

IcebergEntry entryOf(const SightedIceberg& sighted, const Iceberg* known,
                     const IcebergSetting& setting)
{
    return Entry(sighted, known, setting).take();
}

} // namespace berg
