#pragma once

#include "core/coverage/patrol_tails.h"
#include "core/coverage/prediction_input.h"
#include "core/coverage/visit_covariance.h"
#include "core/tracking/view_window.h"
#include "core/vehicle/tangent_turn.h"

#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace berg {

/**
 * A leg of a plan. The UAV turns onto the line that passes the iceberg at this offset and flies it
 * until the iceberg is seen and for `stay_s` more. A leg may also be a hold: the UAV flies straight
 * on or turns at the limit for `stay_s`, to keep icebergs in view.
 */
struct CoverageLeg
{
    /** Place number of a hold, which has none; the search copies too many legs for an optional. */
    static constexpr ModelPlace kNoPlace{-1};

    ModelPlace iceberg;  ///< See `placeCount`; `kNoPlace` for a hold.
    double offset_m = 0; ///< Distance of the iceberg to the left of the line.
    double stay_s = 0;
    int side = 0; ///< Direction of a hold: 1 left, -1 right, 0 straight on.
    /** Returns whether the leg is a hold, which has no iceberg. */
    [[nodiscard]] bool isHold() const { return iceberg == kNoPlace; }
    bool operator==(const CoverageLeg&) const = default;
};

/** Returns a hold of this duration; `side` is 1 (left), -1 (right) or 0 (straight on). */
[[nodiscard]] inline CoverageLeg holdOf(double stay_s, int side = 0)
{
    return {.iceberg = CoverageLeg::kNoPlace, .stay_s = stay_s, .side = side};
}

using CoveragePlan = std::vector<CoverageLeg>;

/** Returns the place of the first leg other than a hold, or nullopt if all legs are holds. */
[[nodiscard]] std::optional<ModelPlace> firstIceberg(const CoveragePlan& plan);

/** Probability that a lost iceberg is found each time the UAV flies to its estimate. */
inline constexpr double kChanceOfLost = 0.4;

/** Time to which plans are predicted, and the value of sigma at its end. */
struct CoverageHorizon
{
    double length_s = 0;
    double rest_s = 0; ///< Weight of sigma at the end, as seconds for which it lasts on.
    double flown_s = std::numeric_limits<double>::infinity(); ///< End of the UAV's flight.
};

/** The predicted state at the end of a leg, in the air's frame, which the wind does not move. */
struct CoverageState
{
    /** Variances of one iceberg at `paid_s`, up to which its sigma is part of the cost. */
    struct Account
    {
        double paid_s = 0;
        DriftVariances known;
        std::size_t next = 0; ///< First view of other UAVs that is not accounted for yet.
        /** End of the last search for a lost iceberg. */
        double searched_s = -std::numeric_limits<double>::infinity();
        unsigned viewed = 0; ///< Set of the places that have been in view, as bits.
        double left = 1;     ///< Probability that the iceberg is elsewhere.
    };

    double time_s = 0; ///< Time since the start of the prediction.
    Pose uav;
    double cost_m2s = 0; ///< Integral of the sigma of each iceberg up to its `paid_s`.
    std::vector<Account> accounts;
};

/** A predicted sighting. */
struct CoverageSighting
{
    ModelPlace iceberg;
    double time_s = 0; ///< Time since the start of the prediction.
};

/** Interval in which an iceberg is in view of a UAV, in seconds since the start of the
 * prediction. */
struct CoverageView
{
    ModelPlace iceberg;
    double enter_s = 0;
    double leave_s = 0;
};

/**
 * Predicts the cost of a sequence of legs in closed form. Each leg is a turn at the limit, in arcs
 * of at most a second and 12 degrees, and a straight line in one piece. Every iceberg that comes
 * into view during the leg counts, with the exact integral of its sigma between sightings. With
 * measurements each iceberg has a view of its own, narrower by the deviation of its place, and
 * `VisitCovariance` predicts its sigma after a visit. The predicted flight is the one that
 * `Simulation` makes of a leg, except for the noise of the drift. The calculation of a leg takes
 * about 0.2 us and 10 ns for each iceberg. Only `setOthers` and `setTail` change the object, so
 * several threads may share it.
 *
 * Each of several UAVs has a model of its own. The sightings of a UAV depend on its own legs alone,
 * so the others are a list of times at which icebergs are in view of theirs; costs are then those
 * of the fleet.
 */
class CoverageModel
{
public:
    /**
     * Copies what it needs of the input. Costs are those of the sigmas multiplied by the
     * input's weights.
     */
    CoverageModel(const PredictionInput& input, const CoverageHorizon& horizon);

    /** Returns the number of places that legs can go to: icebergs, then further places of those
     * that are lost. `CoverageLeg::iceberg` is an index into these. */
    [[nodiscard]] int placeCount() const { return static_cast<int>(m_bergs.size()); }
    /** Returns all places. */
    [[nodiscard]] ModelPlaceRange places() const { return ModelPlaceRange(m_bergs.size()); }
    /** Returns the iceberg of a place, which is an iceberg itself in most cases. */
    [[nodiscard]] ModelPlace icebergAt(ModelPlace place) const { return berg(place).owner; }
    /** Returns whether a lost iceberg is searched for at this place. */
    [[nodiscard]] bool isSearched(ModelPlace place) const { return berg(place).bit != 0; }
    /** Returns the offset of a place from its iceberg's estimate. */
    [[nodiscard]] const Point& offset_m(ModelPlace place) const
    {
        return m_offsets_m[toIndex(place)];
    }
    /** Returns the place of the iceberg that is nearest to this offset from its estimate. */
    [[nodiscard]] ModelPlace placeNear(ModelPlace iceberg, const Point& offset_m) const;
    /** Returns the probability that the iceberg is found at the place if it has not been found
     * before; 1 if it is not lost, or has no places. */
    [[nodiscard]] double chanceAt(const CoverageState& state, ModelPlace place) const;
    /** Returns whether sigma stays above 0 in view, so that keeping icebergs in view may pay. */
    [[nodiscard]] bool paysForSamples() const { return m_paysForSamples; }
    /** Returns the largest lateral distance at which a line still reaches its iceberg. */
    [[nodiscard]] double largestOffset_m() const
    {
        return m_reachWindow
                   ? std::min(m_window.largestOffset_m(), m_reachWindow->largestOffset_m())
                   : m_window.largestOffset_m();
    }
    /** Returns the horizon of the predictions. */
    [[nodiscard]] const CoverageHorizon& horizon() const { return m_horizon; }
    /** Returns whether the state has reached the end of the predicted flight. */
    [[nodiscard]] bool atEnd(const CoverageState& state) const
    {
        return state.time_s >= m_flightEnd_s;
    }

    /**
     * Sets the views of the other UAVs, in any order. States from before the call are then invalid.
     */
    void setOthers(std::vector<CoverageView> views);

    /**
     * Sets the patrol that follows the legs of a plan; the horizon must be the length of the
     * patrol. From then on `total_m2s` is the cost of legs and patrol to the horizon.
     */
    void setTail(PatrolTail tail) { m_tail = std::move(tail); }
    /** Returns nullopt if plans end with their legs. */
    [[nodiscard]] const std::optional<PatrolTail>& tail() const { return m_tail; }

    /** Returns the state at the start of the prediction. */
    [[nodiscard]] CoverageState start() const;

    /**
     * Advances the state by one leg. The leg ends at the horizon or when its iceberg is in view,
     * within the acceptance radius if there is one, or abeam if the leg stays afterwards. Returns
     * false if no time passes because the iceberg is in view already. Appends to `sightings` each
     * iceberg that comes into view, and to `views` all intervals in view, piece by piece; either
     * may be null.
     */
    bool fly(CoverageState& state, const CoverageLeg& leg,
             std::vector<CoverageSighting>* sightings = nullptr,
             std::vector<CoverageView>* views = nullptr) const;

    /**
     * Returns the predicted cost in m2 s if nothing else is seen until the horizon, with the value
     * of sigma there or, with a tail, with its patrol.
     */
    [[nodiscard]] double total_m2s(const CoverageState& state) const;
    /** Returns the integral of all sigma up to the state's time, in m2 s. */
    [[nodiscard]] double costSoFar_m2s(const CoverageState& state) const;
    /** Returns the weighted sigma of an iceberg in the state. */
    [[nodiscard]] double sigma_m2(const CoverageState& state, ModelPlace iceberg) const;
    /**
     * Returns whether a place is in the planned view of the UAV in the state, or is a place of a
     * lost iceberg that has been in view before.
     */
    [[nodiscard]] bool inView(const CoverageState& state, ModelPlace iceberg) const;
    /** Returns a place in the air's frame at a time. */
    [[nodiscard]] Point place_m(ModelPlace iceberg, double time_s) const
    {
        const Point steady_m = berg(iceberg).place_m + berg(iceberg).velocity_mps * time_s;
        return m_carried_m.empty() ? steady_m : Point(steady_m - carried_m(time_s));
    }
    /** Returns the distance from the UAV to a place at the time of the state. */
    [[nodiscard]] double distance_m(const CoverageState& state, ModelPlace iceberg) const;

    /**
     * Turn and line of a leg, as positions over ground with `turn.length_m` as in `turnOntoLine`.
     */
    struct Course
    {
        TangentTurn turn;
        Point abeam_m; ///< Point at which the line comes abeam of the iceberg.
    };
    /**
     * Returns the turn and line of a leg that begins in the state. A hold has a line of at least
     * one second.
     */
    [[nodiscard]] Course course(const CoverageState& state, const CoverageLeg& leg) const;

private:
    /** Times that are closer than this count as equal. */
    static constexpr double kShortest_s = 1e-9;
    static constexpr double kCarriedStep_s = 30;
    /** A lost iceberg that was out of view for this long has another chance to be found. */
    static constexpr double kNewChance_s = 20;

    struct Berg
    {
        Point place_m; ///< Position at the start of the prediction.
        Point velocity_mps;
        VisitCovariance account;
        double chance = 1; ///< Probability of finding a lost iceberg.
        ModelPlace owner;  ///< Iceberg to which the place belongs.
        unsigned bit = 0;  ///< Bit of the place; 0 if the iceberg has no list of places.
    };
    class Flight;

    /** A view of another UAV; the last one of each iceberg never comes. */
    struct OtherView
    {
        double enter_s = std::numeric_limits<double>::infinity();
        double leave_s = std::numeric_limits<double>::infinity();
        double rest_m2s = 0; ///< Cost from the end of the view on, with only the views after it.
        ModelPlace place;    ///< Place that is in view.
    };

    [[nodiscard]] const Berg& berg(ModelPlace iceberg) const { return m_bergs[toIndex(iceberg)]; }
    /** Returns the growth since `paid_s`; none if that is later than `time_s`. */
    [[nodiscard]] VisitCovariance::Growth
    growthUntil(ModelPlace iceberg, const CoverageState::Account& account, double time_s) const
    {
        return berg(iceberg).account.growth(account.known, std::max(0.0, time_s - account.paid_s));
    }

    [[nodiscard]] double totalWithTail_m2s(const CoverageState& state) const;
    /** Returns the cost to the horizon if only the others see the iceberg. */
    [[nodiscard]] double restOf_m2s(ModelPlace iceberg,
                                    const CoverageState::Account& account) const;
    /** Updates the account by a view. Returns the cost of the view and of the time before it. */
    double view_m2s(ModelPlace iceberg, CoverageState::Account& account, double enter_s,
                    double leave_s) const;
    /**
     * Updates the account by a view of a place of a lost iceberg. Returns the cost of the time
     * before it. A second view of the place changes nothing.
     */
    double viewPlace_m2s(ModelPlace place, CoverageState::Account& account, double time_s) const;
    /** Updates the account by the others' views that have begun by then. Returns their cost. */
    double passOthers_m2s(ModelPlace iceberg, CoverageState::Account& account, double time_s) const
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

    /** Returns the view that surely holds an iceberg with this sigma. */
    [[nodiscard]] ViewWindow windowOf(ModelPlace iceberg, double sigma_m2) const
    {
        if (berg(iceberg).bit != 0)
            return m_placeWindow;
        return m_paysForSamples ? m_window.narrowed(berg(iceberg).account.deviation_m(sigma_m2))
                                : m_window;
    }
    /** Returns the window in which a leg to the iceberg ends; null if its view ends the leg. */
    [[nodiscard]] const ViewWindow* reachOf(ModelPlace iceberg) const
    {
        return m_reachWindow && !(berg(iceberg).chance < 1) ? &*m_reachWindow : nullptr;
    }
    [[nodiscard]] const CoverageState::Account& accountOf(const CoverageState& state,
                                                          ModelPlace iceberg) const
    {
        return state.accounts[toIndex(berg(iceberg).owner)];
    }
    void followWind(const WindAhead& wind);
    /** Returns how much farther than the wind of the start the changing wind carries the air. */
    [[nodiscard]] Point carried_m(double time_s) const
    {
        const double steps = std::max(0.0, time_s) / kCarriedStep_s;
        const auto before = std::min(static_cast<std::size_t>(steps), m_carried_m.size() - 2);
        const double share = steps - static_cast<double>(before);
        return m_carried_m[before] + share * (m_carried_m[before + 1] - m_carried_m[before]);
    }
    /** Returns how far the air is carried by a time. */
    [[nodiscard]] Point windPath_m(double time_s) const
    {
        const Point steady_m = m_wind_mps * time_s;
        return m_carried_m.empty() ? steady_m : Point(steady_m + carried_m(time_s));
    }
    [[nodiscard]] TangentTurn turnOf(const CoverageState& state, const CoverageLeg& leg) const;
    [[nodiscard]] TangentTurn holdTurn(const CoverageState& state, const CoverageLeg& leg) const;

    ViewWindow m_window; ///< View for an iceberg whose position is known.
    /** View in which the place of a lost iceberg must lie to be searched. */
    ViewWindow m_placeWindow;
    /** Window of the acceptance radius; nullopt if icebergs in view are reached. */
    std::optional<ViewWindow> m_reachWindow;
    double m_reach_m; ///< An iceberg farther away than this is neither in view nor reached.
    bool m_paysForSamples;
    CoverageHorizon m_horizon;
    double m_flightEnd_s;
    Pose m_uav;
    Point m_wind_mps; ///< at the start
    /** `carried_m` every `kCarriedStep_s` from the start on; empty if the wind is constant. */
    std::vector<Point> m_carried_m;
    double m_speed_mps;
    double m_limit_radps;
    double m_radius_m;
    double m_arc_s;       ///< Duration of the longest arc.
    double m_cosineOfArc; ///< Cosine of the angle of the longest arc.
    double m_sineOfArc;
    double m_fastest_mps = 0;  ///< Highest speed of the icebergs through the air.
    std::vector<Berg> m_bergs; ///< Icebergs, then further places of lost icebergs.
    std::size_t m_icebergs = 0;
    std::vector<Point> m_offsets_m;  ///< Offsets of the places, see `offset_m`.
    std::vector<OtherView> m_others; ///< Views of one iceberg after the other, ascending in time.
    std::vector<std::size_t> m_firstOfOther; ///< First entry of `m_others` of each iceberg.
    bool m_isAlone = true;                   ///< No other UAV has anything in view.
    std::optional<PatrolTail> m_tail;
};

} // namespace berg
