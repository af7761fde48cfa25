#include "core/io/import/scenario/import_icebergs.h"

#include "core/base/angles.h"
#include "core/checks/validate.h"
#include "core/land/land_data.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace berg {

namespace {

// Velocities and q are rounded to this fraction of 1.
constexpr double kEstimatedParts = 1e5;
constexpr double kGivenParts = 1e7; ///< fine enough for exports read in another plane

/** Returns speed and direction as true east and north. */
Point driftOf(double speed_mps, double direction_deg)
{
    const double direction_rad = radFromDeg(direction_deg);
    return speed_mps * Point(std::sin(direction_rad), std::cos(direction_rad));
}

/** Builds the entry of one iceberg. */
class Entry
{
public:
    Entry(const SightedIceberg& sighted, const Iceberg* known, const IcebergInputs& inputs)
        : m_sighted(sighted), m_known(known), m_inputs(inputs)
    {
        m_report.id = sighted.id;
        m_report.sightings = sighted.sightings.size();
        if (known != nullptr)
            m_iceberg = *known;
        else
            m_iceberg = {.id = sighted.id, .q_m2ps = inputs.options.q_m2ps};
        const double sd_m = inputs.options.positionSd_m.value_or(0);
        for (const PlacedSighting& placed : sighted.sightings)
            if (placed.fix.time_s <= 0) {
                m_past.push_back(placed.fix);
                if (!placed.sighting->sigma_m2)
                    m_past.back().variance_m2 = sd_m * sd_m;
                m_past.back().drift_mps = statedDrift(*placed.sighting);
                m_past.back().driftVariance_m2ps2 =
                    inputs.options.statedDriftSd_mps * inputs.options.statedDriftSd_mps;
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
        TrackRules rules = m_inputs.options.track;
        rules.mean_mps = m_inputs.current_mps;
        rules.drift.q_m2ps = m_iceberg.q_m2ps;
        m_estimate = estimateTrack(m_past, rules);
        m_last = m_pastSightings[m_estimate.last];
        m_report.used = m_estimate.used;
        m_report.age_s = 0.0 - m_last->fix.time_s; // avoids -0
        // A sighting without time counts as present, whatever the scenario has.
        if (m_known != nullptr && m_last->timeKnown &&
            m_report.age_s > m_known->observed_s + kTimeRounding_s) {
            m_report.outcome = ImportOutcome::Unchanged;
            note(ImportNote::Older);
            return;
        }
        if (!m_last->timeKnown && m_inputs.hasStart)
            note(ImportNote::TimeUnknown);
        if (m_estimate.repeated > 0)
            note(ImportNote::Repeated);
        if (m_estimate.jumped > 0)
            note(ImportNote::Jumped);
        setMotion();
        setRest();
        moveToStart();
        if (!onPlane(m_iceberg.position_m)) {
            leaveOut(ImportNote::DriftedAway);
            return;
        }
        if (!m_last->sighting->drift_mps) // Bergwatch exports repeat what a scenario had
            noteDoubts();
        if (m_inputs.options.withTracks)
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
        const bool aground = last.grounded || m_estimate.stationary;
        const bool isStatedAlone = m_estimate.stated && !m_estimate.fit;
        if (aground) {
            note(ImportNote::Stationary);
            m_iceberg.q_m2ps = 0;
            setDrift(Point::Zero(), kGivenParts);
            setChange(0, {});
            setSource(m_estimate.stationary ? VelocitySource::Fixes : VelocitySource::File,
                      m_report.age_s);
        } else if (last.drift_mps) {
            note(ImportNote::VelocityGiven);
            setDrift(inPlane(*last.drift_mps, last.place), kGivenParts);
            if (last.change)
                take(*last.change);
            setSource(VelocitySource::File, m_report.age_s);
        } else if (isStatedAlone) {
            const Fix& stating = m_past[*m_estimate.stated];
            note(ImportNote::VelocityGiven);
            setDrift(*stating.drift_mps, kGivenParts);
            setChange(std::min(m_inputs.options.statedDriftSd_mps, drift().velocitySpread_mps),
                      drift());
            setSource(VelocitySource::File, 0.0 - stating.time_s);
        } else if (m_estimate.velocity_mps) {
            setFitted();
        } else {
            note(ImportNote::VelocityUnknown);
            if (m_known == nullptr)
                setChange(drift().velocitySpread_mps, drift());
            else
                fadeKnownVelocity();
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

    void setFitted()
    {
        m_clamped = m_estimate.velocityClamped;
        setDrift(*m_estimate.velocity_mps, kEstimatedParts);
        m_isFitted = m_estimate.fit.has_value();
        if (m_isFitted)
            setChange(std::sqrt(m_estimate.fit->variances.velocity_m2ps2), drift());
        const bool isBoth = m_isFitted && m_estimate.fit->stated == DriftUse::Combined;
        setSource(isBoth ? VelocitySource::Both : VelocitySource::Fixes, m_report.age_s);
        if (m_isFitted && m_estimate.fit->stated == DriftUse::Contradicted)
            note(ImportNote::Contradicted);
    }

    void setSource(VelocitySource from, double age_s)
    {
        m_report.velocityFrom = from;
        m_report.velocityAge_s = age_s;
    }

    /**
     * Returns the drift over ground, in the plane, of a speed and direction that a sighting states.
     */
    [[nodiscard]] std::optional<Point> statedDrift(const Sighting& sighting) const
    {
        if (sighting.speed_mps && *sighting.speed_mps == 0)
            return Point(Point::Zero());
        if (sighting.speed_mps && sighting.direction_deg)
            return inPlane(driftOf(*sighting.speed_mps, *sighting.direction_deg), sighting.place);
        return std::nullopt;
    }

    [[nodiscard]] Point inPlane(const Point& drift_mps, const LatLon& place) const
    {
        return turned(drift_mps, m_inputs.frame.trueNorth_rad(place));
    }

    /**
     * Sets the velocity from a drift over ground; the scenario adds its current to the iceberg's
     * own velocity.
     */
    void setDrift(const Point& total_mps, double parts)
    {
        const Point exact_mps = total_mps - m_inputs.current_mps;
        const Point own_mps = (exact_mps * parts).array().round() / parts;
        m_iceberg.velocity_mps =
            own_mps.cwiseMax(-kLargestVelocity_mps).cwiseMin(kLargestVelocity_mps);
        m_clamped = m_clamped || m_iceberg.velocity_mps != own_mps;
    }

    [[nodiscard]] const DriftProcess& drift() const { return m_inputs.options.track.drift; }

    void setChange(double sd_mps, const DriftProcess& process)
    {
        m_iceberg.velocitySd_mps =
            std::min(kLargestVelocity_mps, std::round(sd_mps * kEstimatedParts) / kEstimatedParts);
        m_iceberg.velocitySpread_mps = process.velocitySpread_mps;
        m_iceberg.velocityTime_s = process.velocitySpread_mps > 0 ? process.velocityTime_s : 0;
    }

    void take(const SightedDriftChange& change)
    {
        m_iceberg.velocitySd_mps = change.velocitySd_mps;
        m_iceberg.velocitySpread_mps = change.velocitySpread_mps;
        m_iceberg.velocityTime_s = change.velocityTime_s;
    }

    /** Whether the sighting is later than the observation in the scenario. */
    [[nodiscard]] bool isNewer() const
    {
        return m_known == nullptr || m_report.age_s + kTimeRounding_s < m_known->observed_s;
    }

    /**
     * Sets the velocity error of an iceberg of the scenario to the value it has at the new
     * sighting.
     */
    void fadeKnownVelocity()
    {
        const Track then =
            initialTrack({.velocitySd_mps = m_known->velocitySd_mps,
                          .velocitySpread_mps = m_known->velocitySpread_mps,
                          .velocityTime_s = m_known->velocityTime_s,
                          .observed_s = std::max(0.0, m_known->observed_s - m_report.age_s)},
                         ObserverModel::Kalman);
        m_iceberg.velocitySd_mps = std::sqrt(then.velocity_m2ps2);
    }

    /**
     * Moves the iceberg from the last sighting to t = 0; the velocity relative to the current fades
     * meanwhile.
     */
    void moveToStart()
    {
        // The velocity of an iceberg of the scenario is already that of t = 0.
        const bool isPresent =
            m_known != nullptr && m_report.velocityFrom == VelocitySource::Nothing;
        const double time_s = isPresent ? 0 : m_iceberg.velocityTime_s;
        const double carried_s = carriedFor_s(time_s, m_report.age_s);
        const Point from_m = m_isFitted ? m_estimate.fit->position_m : m_last->fix.position_m;
        m_iceberg.position_m = toCentimetre(from_m + m_inputs.current_mps * m_report.age_s +
                                            m_iceberg.velocity_mps * carried_s);
        if (time_s > 0)
            m_iceberg.velocity_mps =
                (m_iceberg.velocity_mps * std::exp(-m_report.age_s / time_s) * kGivenParts)
                    .array()
                    .round() /
                kGivenParts;
        constexpr double kSamePlace_m = 1;
        const bool isOther =
            isNewer() || (m_iceberg.position_m - m_known->position_m).norm() > kSamePlace_m;
        if (isOther || m_last->sighting->sigma_m2)
            m_iceberg.sigma0_m2 = m_past[m_estimate.last].variance_m2;
        if (!m_isFitted || !isOther)
            return;
        // A scenario has no covariance of position and velocity, so its effect until t = 0 is added
        // to the variance.
        const DriftVariances& known = m_estimate.fit->variances;
        m_iceberg.sigma0_m2 = std::min(
            kLargestSigma_m2,
            std::round((known.position_m2 + 2 * known.mixed_m2ps * carried_s) * 100) / 100);
    }

    void noteDoubts()
    {
        const Point drift_mps = m_iceberg.velocity_mps + m_inputs.current_mps;
        if (m_report.velocityFrom != VelocitySource::Nothing &&
            drift_mps.norm() > kDoubtfulSpeed_mps)
            note(ImportNote::TooFast);
        if (isOnLand(m_last->sighting->place) ||
            isOnLand(m_inputs.frame.toGeographic(m_iceberg.position_m)))
            note(ImportNote::OnLand);
    }

    void setRest()
    {
        const Sighting& last = *m_last->sighting;
        m_iceberg.observed_s = std::min(m_report.age_s, kLargestTime_s);
        if (last.appearsIn_s)
            m_iceberg.appears_s =
                std::clamp(*last.appearsIn_s - m_report.age_s, 0.0, kLargestTime_s);
        // A sighting need not repeat name and size; the latest value is used.
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
        for (const std::size_t i : consistentFixes(fixes, m_inputs.options.track).indices) {
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
        double tolerance_m = m_inputs.options.tolerance_m;
        m_iceberg.track = thinned(track, tolerance_m);
        while (m_iceberg.track.time_s.size() > kMostTrackPoints)
            m_iceberg.track = thinned(track, tolerance_m = 2 * std::max(1.0, tolerance_m));
        note(ImportNote::TrackAttached);
    }

    static constexpr double kTimeRounding_s = 0.002;

    const SightedIceberg& m_sighted;
    const Iceberg* m_known;
    const IcebergInputs& m_inputs;
    Iceberg m_iceberg;
    ImportedIceberg m_report;
    std::vector<Fix> m_past; ///< fixes at or before t = 0
    std::vector<const PlacedSighting*> m_pastSightings;
    TrackEstimate m_estimate;
    const PlacedSighting* m_last = nullptr;
    bool m_clamped = false;
    bool m_isFitted = false; ///< whether position and velocity are those of `fitDrift`
};

} // namespace

bool onPlane(const Point& position_m)
{
    return position_m.allFinite() && position_m.cwiseAbs().maxCoeff() <= kLargestCoordinate_m;
}

Point toCentimetre(const Point& position_m)
{
    return (position_m * 100).array().round() / 100;
}

IcebergEntry entryOf(const SightedIceberg& sighted, const Iceberg* known,
                     const IcebergInputs& inputs)
{
    return Entry(sighted, known, inputs).take();
}

} // namespace berg
