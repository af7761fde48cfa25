#pragma once

#include "core/coverage/covariance_account.h"
#include "core/coverage/flight_picture.h"
#include "core/tracking/view_window.h"
#include "core/vehicle/tangent_turn.h"

#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace berg {

/**
 * A leg of a plan: turn onto the line that leaves the iceberg at this offset, fly it until seen and
 * for `stay_s` more. Or a hold, for that long straight on or in a turn at the limit, to keep in
 * view what is in view.
 */
struct CoverageLeg
{
    int iceberg = 0;     ///< index into the tracks of the picture; -1: a hold
    double offset_m = 0; ///< the iceberg is left of the line by so much
    double stay_s = 0;
    int side = 0; ///< of a hold: 1 left, -1 right, 0 straight on
    [[nodiscard]] bool isHold() const { return iceberg < 0; }
    bool operator==(const CoverageLeg&) const = default;
};

[[nodiscard]] inline CoverageLeg holdOf(double stay_s, int side = 0)
{
    return {.iceberg = -1, .stay_s = stay_s, .side = side};
}

using CoveragePlan = std::vector<CoverageLeg>;

/** Of the first leg that is no hold; -1: there is none. */
[[nodiscard]] int firstIceberg(const CoveragePlan& plan);

/** A lost iceberg is found with this chance each time it is flown to where it is believed to be. */
inline constexpr double kChanceOfLost = 0.4;

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
    /** What is known of one iceberg at the time until which it is paid for in `cost`. */
    struct Account
    {
        double paid_s = 0;
        DriftVariances known;
        std::size_t next = 0; ///< the first view of other UAVs that is not accounted for
        /** Of one that is lost: until when it was looked for last. */
        double lookedFor_s = -std::numeric_limits<double>::infinity();
        unsigned viewed = 0; ///< places that have been in view, by bit
        double left = 1;     ///< chance that it is elsewhere
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
 * With measurements each iceberg has a view of its own, narrower by the deviation of its place, and
 * what a visit leaves of its sigma is `CovarianceAccount`'s to say. The same flight as `Simulation`
 * makes of a leg, but for the noise of the drift. Cost of a leg: about 0.2 us and 10 ns for each
 * iceberg. Immutable but for `setOthers`: one object serves several threads.
 *
 * Of several UAVs each has a model. What a UAV sees depends on its own legs alone, so the others
 * are a list of times at which icebergs are in view of theirs; costs are then those of the fleet.
 */
class CoverageModel
{
public:
    /** Borrows nothing. Costs are of the sigmas times the weights of the picture. */
    CoverageModel(const FlightPicture& picture, const CoverageHorizon& horizon);

    /** Of what legs can go to: icebergs, and then further places of those that are lost. A leg's
     * `iceberg` is an index into these. */
    [[nodiscard]] int placeCount() const { return static_cast<int>(m_bergs.size()); }
    /** Of a place of legs; of an iceberg itself. */
    [[nodiscard]] int icebergAt(int place) const { return berg(place).owner; }
    /** Whether it is one of those where a lost iceberg is searched for. */
    [[nodiscard]] bool isSearched(int place) const { return berg(place).bit != 0; }
    /** From the iceberg's estimate. */
    [[nodiscard]] const Point& offset_m(int place) const
    {
        return m_offsets_m[static_cast<std::size_t>(place)];
    }
    /** The nearest of an iceberg's places to where it would be with this offset. */
    [[nodiscard]] int placeNear(int iceberg, const Point& offset_m) const;
    /** That it is found there if it has not been before; 1 of what is not lost, or has no places.
     */
    [[nodiscard]] double chanceAt(const CoverageState& state, int place) const;
    /** Whether a look does not tell all, so that it may pay to keep icebergs in view. */
    [[nodiscard]] bool paysForLooks() const { return m_paysForLooks; }
    /** A line that passes an iceberg so far off reaches it. */
    [[nodiscard]] double largestOffset_m() const
    {
        return m_reachWindow
                   ? std::min(m_window.largestOffset_m(), m_reachWindow->largestOffset_m())
                   : m_window.largestOffset_m();
    }
    [[nodiscard]] const CoverageHorizon& horizon() const { return m_horizon; }
    [[nodiscard]] bool atEnd(const CoverageState& state) const
    {
        return state.time_s >= m_flightEnd_s;
    }

    /** What other UAVs have in view meanwhile, in any order. Ends the use of all states. */
    void setOthers(std::vector<CoverageView> views);

    [[nodiscard]] CoverageState start() const;

    /**
     * Flies one leg, to the horizon at most, and until its iceberg is in view, or within the reach
     * radius where there is one, or abeam before it stays. False when no time passes, because it is
     * in view already. `sightings` gets what is seen after it was not, `views` all that is in view,
     * piece by piece.
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
    /** Times closer than this are one. */
    static constexpr double kShortest_s = 1e-9;
    /** What is looked for again after so long out of view has another chance to be found. */
    static constexpr double kNewChance_s = 20;

    struct Berg
    {
        Point place_m; ///< at the time of the picture
        Point velocity_mps;
        CovarianceAccount account;
        double chance = 1; ///< of finding one that is lost
        int owner = 0;     ///< the iceberg
        unsigned bit = 0;  ///< of its places; 0: none are told
    };
    class Flight;

    /** One of other UAVs; the last one of each iceberg never comes. */
    struct OtherView
    {
        double enter_s = std::numeric_limits<double>::infinity();
        double leave_s = std::numeric_limits<double>::infinity();
        double rest_m2s = 0; ///< from then on with nothing but the views after it
        int place = 0;       ///< that is in view
    };

    [[nodiscard]] const Berg& berg(int iceberg) const
    {
        return m_bergs[static_cast<std::size_t>(iceberg)];
    }
    /** From what is paid for to then; none: it is paid for longer. */
    [[nodiscard]] CovarianceAccount::Growth
    growthUntil(int iceberg, const CoverageState::Account& account, double time_s) const
    {
        return berg(iceberg).account.growth(account.known, std::max(0.0, time_s - account.paid_s));
    }

    /** From now to the end of an account that nothing but the others' views change. */
    [[nodiscard]] double restOf_m2s(int iceberg, const CoverageState::Account& account) const;
    /** In view from then until then: what that costs, the time before it included. */
    double view_m2s(int iceberg, CoverageState::Account& account, double enter_s,
                    double leave_s) const;
    /** A place of a lost iceberg is in view; what that costs, the time before it included. The
     * second time it tells nothing. */
    double viewPlace_m2s(int place, CoverageState::Account& account, double time_s) const;
    /** Takes the others' views that have begun by then into the account; what that costs. */
    double passOthers_m2s(int iceberg, CoverageState::Account& account, double time_s) const
    {
        double cost_m2s = 0;
        while (m_others[account.next].enter_s <= time_s) {
            const OtherView& view = m_others[account.next++];
            cost_m2s += berg(view.place).bit == 0
                            ? view_m2s(iceberg, account, view.enter_s, view.leave_s)
                            : viewPlace_m2s(view.place, account, view.enter_s);
        }
        return cost_m2s;
    }
    void passOthers(CoverageState& state) const;

    [[nodiscard]] Point place_m(int iceberg, double time_s) const
    {
        return berg(iceberg).place_m + berg(iceberg).velocity_mps * time_s;
    }
    /** The view of one whose account comes to this sigma. */
    [[nodiscard]] ViewWindow windowOf(int iceberg, double sigma_m2) const
    {
        if (berg(iceberg).bit != 0)
            return m_placeWindow;
        return m_paysForLooks ? m_window.narrowed(berg(iceberg).account.deviation_m(sigma_m2))
                              : m_window;
    }
    /** What a leg to it ends in: within the radius, or in view where that tells enough. */
    [[nodiscard]] const ViewWindow* reachOf(int iceberg) const
    {
        return m_reachWindow && !(berg(iceberg).chance < 1) ? &*m_reachWindow : nullptr;
    }
    [[nodiscard]] const CoverageState::Account& accountOf(const CoverageState& state,
                                                          int iceberg) const
    {
        return state.accounts[static_cast<std::size_t>(berg(iceberg).owner)];
    }
    [[nodiscard]] TangentTurn turnOf(const CoverageState& state, const CoverageLeg& leg) const;
    [[nodiscard]] TangentTurn holdTurn(const CoverageState& state, const CoverageLeg& leg) const;

    ViewWindow m_window;                     ///< of an iceberg whose place is known
    ViewWindow m_placeWindow;                ///< a view in it covers the place of a lost one
    std::optional<ViewWindow> m_reachWindow; ///< nullopt: icebergs in view are reached
    double m_reach_m; ///< no iceberg farther away than this is in view or reached
    bool m_paysForLooks;
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
    double m_fastest_mps = 0;  ///< of the icebergs, through the air
    std::vector<Berg> m_bergs; ///< icebergs, then further places of those that are lost
    std::size_t m_icebergs = 0;
    std::vector<Point> m_offsets_m;          ///< of places, see `offset_m`
    std::vector<OtherView> m_others;         ///< of one iceberg after the other, ascending
    std::vector<std::size_t> m_firstOfOther; ///< of each iceberg
    bool m_isAlone = true;                   ///< no other has anything in view
};

} // namespace berg
