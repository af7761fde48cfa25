#pragma once

#include "core/coverage/flight_picture.h"
#include "core/tracking/view_window.h"
#include "core/vehicle/tangent_turn.h"

#include <limits>
#include <span>
#include <vector>

namespace berg {

/** A leg of a plan: turn onto the line that leaves the iceberg at this offset, fly it until seen.
 */
struct CoverageLeg
{
    int iceberg = 0;     ///< index into the tracks of the picture
    double offset_m = 0; ///< the iceberg is left of the line by so much
    bool operator==(const CoverageLeg&) const = default;
};

using CoveragePlan = std::vector<CoverageLeg>;

/** Up to when a plan is judged, and what is still to come is worth. */
struct CoverageHorizon
{
    double length_s = 0;
    double rest_s = 0; ///< each m2 of sigma at the end counts for so many seconds
    double flown_s = std::numeric_limits<double>::infinity(); ///< the UAV flies no longer
};

/** The predicted flight at the end of a leg. In the air's frame, which the wind does not move. */
struct CoverageState
{
    /** sigma of one iceberg at the time until which it is paid for in `cost`. */
    struct Account
    {
        double paid_s = 0;
        double sigma_m2 = 0;
        std::size_t next = 0; ///< the first view of other UAVs that is not accounted for
    };

    double time_s = 0; ///< since the picture
    Pose uav;
    double cost_m2s = 0; ///< integral of sigma, of each iceberg up to its `paid_s`
    std::vector<Account> accounts;
};

/** A predicted sighting. */
struct CoverageSighting
{
    int iceberg = 0;
    double time_s = 0; ///< since the picture
};

/** An iceberg is in view of a UAV; times since the picture. */
struct CoverageView
{
    int iceberg = 0;
    double enter_s = 0;
    double leave_s = 0;
};

/**
 * Predicts, in closed form, what flying a sequence of legs costs: each leg is a turn at the limit,
 * taken in arcs of a second and 12 degrees at most, and a straight line in one piece; every iceberg
 * that comes into view on the way counts, with the exact integral of its sigma between sightings.
 * The same flight as `Simulation` makes of a leg, but for the noise of the drift. Cost of a leg:
 * about 0.2 us and 10 ns for each iceberg. Immutable but for `setOthers`: one object serves several
 * threads.
 *
 * Of several UAVs each has a model. What a UAV sees depends on its own legs alone, so the others
 * are a list of times at which icebergs are in view of theirs; costs are then those of the fleet.
 */
class CoverageModel
{
public:
    /** Borrows nothing. Costs are of the sigmas times the weights of the picture. */
    CoverageModel(const FlightPicture& picture, const CoverageHorizon& horizon);

    [[nodiscard]] int icebergCount() const { return static_cast<int>(m_bergs.size()); }
    [[nodiscard]] double largestOffset_m() const { return m_window.largestOffset_m(); }
    [[nodiscard]] const CoverageHorizon& horizon() const { return m_horizon; }
    [[nodiscard]] bool atEnd(const CoverageState& state) const
    {
        return state.time_s >= m_flightEnd_s;
    }

    /** What other UAVs have in view meanwhile, in any order. Ends the use of all states. */
    void setOthers(std::vector<CoverageView> views);

    [[nodiscard]] CoverageState start() const;

    /**
     * Flies one leg until its iceberg is in view, but to the horizon or abeam of the iceberg at
     * most. False when no time passes, because it is in view already. `sightings` gets what is
     * seen after it was not, `views` all that is in view, piece by piece.
     */
    bool fly(CoverageState& state, const CoverageLeg& leg,
             std::vector<CoverageSighting>* sightings = nullptr,
             std::vector<CoverageView>* views = nullptr) const;

    /** Predicted cost if nothing else were seen until the horizon, what comes after it included. */
    [[nodiscard]] double total_m2s(const CoverageState& state) const;
    /** Integral of all sigma up to the state's time. */
    [[nodiscard]] double costSoFar_m2s(const CoverageState& state) const;
    [[nodiscard]] double sigma_m2(const CoverageState& state, int iceberg) const;
    [[nodiscard]] bool inView(const CoverageState& state, int iceberg) const;
    /** Between two icebergs at the time of the picture. */
    [[nodiscard]] double between_m(int a, int b) const
    {
        return (place_m(a, 0) - place_m(b, 0)).norm();
    }
    /** Air distance now. */
    [[nodiscard]] double distance_m(const CoverageState& state, int iceberg) const;

    /** How a leg is flown: places over ground, `turn.length_m` as in `turnOntoLine`. */
    struct Course
    {
        TangentTurn turn;
        Point abeam_m; ///< where the line comes abeam of the iceberg
    };
    [[nodiscard]] Course course(const CoverageState& state, const CoverageLeg& leg) const;

private:
    struct Berg
    {
        Point place_m; ///< at the time of the picture
        Point velocity_mps;
        double q_m2ps = 0;
        double sigma_m2 = 0;
        // Unknown velocities, with measurements: sigma grows by (q + 2 mixed) t + variance t^2
        // until the iceberg is seen, and by q t + (what a sighting leaves of the variance) t^2
        // after.
        double mixed_m2ps = 0;
        double velocity_m2ps2 = 0;
        double velocityAfter_m2ps2 = 0;
    };
    class Flight;

    /** One of other UAVs; the last one of each iceberg never comes. */
    struct OtherView
    {
        double enter_s = std::numeric_limits<double>::infinity();
        double leave_s = std::numeric_limits<double>::infinity();
        double rest_m2s = 0; ///< from then on with nothing but the views after it
    };

    /** sigma after `unseen_s` of an account, and its integral until then. */
    struct Growth
    {
        double sigma_m2 = 0;
        double cost_m2s = 0;
    };
    [[nodiscard]] Growth growth(int iceberg, const CoverageState::Account& account,
                                double unseen_s) const
    {
        const Berg& berg = m_bergs[static_cast<std::size_t>(iceberg)];
        const bool isSeen = account.paid_s > 0;
        const double rate_m2ps = isSeen ? berg.q_m2ps : berg.q_m2ps + 2 * berg.mixed_m2ps;
        const double velocity_m2ps2 = isSeen ? berg.velocityAfter_m2ps2 : berg.velocity_m2ps2;
        const double grown_m2 = rate_m2ps * unseen_s;
        const double drifted_m2 = velocity_m2ps2 * unseen_s * unseen_s;
        return {.sigma_m2 = account.sigma_m2 + grown_m2 + drifted_m2,
                .cost_m2s = unseen_s * (account.sigma_m2 + grown_m2 / 2 + drifted_m2 / 3)};
    }

    /** From now to the end of an account that nothing but the others' views change. */
    [[nodiscard]] double restOf_m2s(int iceberg, const CoverageState::Account& account) const
    {
        const OtherView& next = m_others[account.next];
        const bool isLast = next.enter_s >= m_horizon.length_s;
        const Growth end =
            growth(iceberg, account, (isLast ? m_horizon.length_s : next.enter_s) - account.paid_s);
        return isLast ? end.cost_m2s + m_horizon.rest_s * end.sigma_m2
                      : end.cost_m2s + next.rest_m2s;
    }
    /** Takes the others' views that have begun by then into the account; what that costs. */
    double passOthers_m2s(int iceberg, CoverageState::Account& account, double time_s) const
    {
        double cost_m2s = 0;
        while (m_others[account.next].enter_s <= time_s) {
            const OtherView& view = m_others[account.next++];
            if (view.enter_s > account.paid_s)
                cost_m2s += growth(iceberg, account, view.enter_s - account.paid_s).cost_m2s;
            if (view.leave_s > account.paid_s) {
                account.paid_s = view.leave_s;
                account.sigma_m2 = 0;
            }
        }
        return cost_m2s;
    }
    void passOthers(CoverageState& state) const;

    [[nodiscard]] Point place_m(int iceberg, double time_s) const
    {
        const Berg& berg = m_bergs[static_cast<std::size_t>(iceberg)];
        return berg.place_m + berg.velocity_mps * time_s;
    }
    [[nodiscard]] TangentTurn turnOf(const CoverageState& state, const CoverageLeg& leg) const;

    ViewWindow m_window;
    CoverageHorizon m_horizon;
    double m_flightEnd_s;
    Pose m_uav;
    Point m_wind_mps;
    double m_speed_mps;
    double m_limit_radps;
    double m_radius_m;
    double m_arc_s;       ///< longest arc
    double m_cosineOfArc; ///< of its angle
    double m_sineOfArc;
    double m_fastest_mps = 0; ///< of the icebergs, through the air
    std::vector<Berg> m_bergs;
    std::vector<int> m_all;                  ///< their indices
    std::vector<OtherView> m_others;         ///< of one iceberg after the other, ascending
    std::vector<std::size_t> m_firstOfOther; ///< of each iceberg
    bool m_isAlone = true;                   ///< no other has anything in view
};

} // namespace berg
