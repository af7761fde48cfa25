#include "core/coverage/coverage_model.h"
#include "core/coverage/view_axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

// This file finds what comes into view on a leg.

namespace berg {

/** One leg under way. */
class CoverageModel::Flight
{
public:
    Flight(const CoverageModel& model, CoverageState& state, ModelPlace target,
           std::vector<CoverageSighting>* sightings, std::vector<CoverageView>* views)
        : m_model(model), m_state(state), m_target(target), m_sightings(sightings), m_views(views)
    {
    }

    /**
     * Flies the turn. Returns true if the target comes into view, or the horizon is reached, before
     * its end.
     */
    bool turn(double turn_rad, const Pose& turned)
    {
        const double side = turn_rad < 0 ? -1 : 1;
        double left_s = std::abs(turn_rad) / m_model.m_limit_radps;
        if (left_s <= kShortest_s)
            return false;
        selectNear(m_state.uav.position_m + side * m_model.m_radius_m * m_state.uav.left(),
                   m_model.m_radius_m, left_s);
        locate();
        const double sine = side * m_model.m_sineOfArc;
        while (left_s > 0) {
            const bool last = left_s <= m_model.m_arc_s;
            const double dt_s = last ? left_s : m_model.m_arc_s;
            const Pose end =
                last
                    ? turned
                    : turnedTo(m_state.uav, rotated(m_state.uav.ahead, m_model.m_cosineOfArc, sine),
                               side, m_model.m_radius_m);
            if (piece(end, dt_s)) {
                const double angle_rad = side * m_model.m_limit_radps * (m_end_s - m_from_s);
                moveTo(
                    turnedTo(m_state.uav,
                             rotated(m_state.uav.ahead, std::cos(angle_rad), std::sin(angle_rad)),
                             side, m_model.m_radius_m));
                return true;
            }
            moveTo(end);
            left_s = last ? 0 : left_s - dt_s;
        }
        return false;
    }

    /**
     * Selects the icebergs that may come into view on straight lines of at most this total length.
     */
    void selectAhead(double length_m)
    {
        constexpr double kRounding_m = 1;
        const Pose& uav = m_state.uav;
        selectNear(uav.position_m + uav.ahead * (length_m / 2), length_m / 2 + kRounding_m,
                   length_m / m_model.m_speed_mps);
    }

    /** Flies straight on for `length_m`, or until the leg ends. */
    void straight(double length_m)
    {
        const double dt_s = length_m / m_model.m_speed_mps;
        Pose end = m_state.uav;
        end.position_m += end.ahead * length_m;
        locate();
        piece(end, dt_s);
        end.position_m =
            m_state.uav.position_m + end.ahead * (m_model.m_speed_mps * (m_end_s - m_from_s));
        moveTo(end);
    }

    /** Flies straight on for `length_m`, whatever comes into view, or to the horizon. */
    void stay(double length_m)
    {
        m_target = CoverageLeg::kNoPlace;
        straight(length_m);
    }

private:
    static constexpr ViewSpan kNever{.enter = 2, .leave = 2};

    /** An iceberg that may come into view. */
    struct Near
    {
        ModelPlace iceberg;
        Point from_m;  ///< Position at the beginning of a piece, in axes of the view.
        ViewSpan span; ///< Part of the piece in which the iceberg is in view.
        [[nodiscard]] bool isSeen() const { return span.enter <= 1; }
    };

    /**
     * Selects the icebergs that may come into view within `lasting_s` because they are within
     * `away_m` of `centre_m`; all others can be ignored.
     */
    void selectNear(const Point& centre_m, double away_m, double lasting_s)
    {
        const double reach_m = away_m + m_model.m_reach_m + m_model.m_fastest_mps * lasting_s;
        const double reach_m2 = reach_m * reach_m;
        const double now_s = m_state.time_s;
        std::size_t count = 0;
        m_many.clear();
        for (const ModelPlace i : m_model.places()) {
            const double away_m2 = (m_model.place_m(i, now_s) - centre_m).squaredNorm();
            m_few[count].iceberg = i;
            // The addition avoids a branch that the processor could not predict.
            count += away_m2 <= reach_m2 ? 1 : 0;
            if (count < m_few.size())
                continue;
            m_many.insert(m_many.end(), m_few.begin(), m_few.end());
            count = 0;
        }
        if (!m_many.empty())
            m_many.insert(m_many.end(), m_few.begin(),
                          m_few.begin() + static_cast<std::ptrdiff_t>(count));
        m_near = m_many.empty() ? std::span(m_few.data(), count) : std::span(m_many);
    }

    /** Finds the places of icebergs at the beginning of a piece. */
    void locate()
    {
        const ViewAxes axes = axesOf(m_model.m_window, m_state.uav);
        for (Near& near : m_near)
            near.from_m = axes.coordinates(m_model.place_m(near.iceberg, m_state.time_s));
    }

    void moveTo(const Pose& uav)
    {
        m_state.uav = uav;
        m_state.time_s = m_end_s;
    }

    /**
     * Finds the sightings of the selected icebergs on a short arc or a straight line from the state
     * to `end`. Returns true if the leg ends on it. `m_end_s` is then the end of the piece or of
     * the leg.
     */
    bool piece(const Pose& end, double dt_s)
    {
        const ViewAxes after = axesOf(m_model.m_window, end);
        m_from_s = m_state.time_s;
        const double to_s = m_from_s + dt_s;
        m_end_s = std::min(to_s, m_model.m_flightEnd_s);
        bool ends = m_end_s < to_s;
        for (Near& near : m_near) {
            const Point to_m = after.coordinates(m_model.place_m(near.iceberg, to_s));
            near.span = crossing(near, to_m, dt_s).value_or(kNever);
            const ViewSpan reached = near.iceberg == m_target ? reachedBy(near, to_m) : kNever;
            near.from_m = to_m;
            if (reached.enter <= 1) {
                const double enter_s = m_from_s + reached.enter * dt_s;
                ends = ends || enter_s <= m_end_s;
                m_end_s = std::min(m_end_s, enter_s);
            }
        }
        for (const Near& near : m_near) {
            const double enter_s = m_from_s + near.span.enter * dt_s;
            if (near.isSeen() && enter_s <= m_end_s)
                see(near.iceberg, enter_s, std::min(m_from_s + near.span.leave * dt_s, m_end_s));
        }
        return ends;
    }

    /** Returns the part of a piece in which the target is reached. */
    [[nodiscard]] ViewSpan reachedBy(const Near& near, const Point& to_m) const
    {
        const ViewWindow* reach = m_model.reachOf(near.iceberg);
        return reach != nullptr ? reach->crossing(near.from_m, to_m).value_or(kNever) : near.span;
    }

    [[nodiscard]] std::optional<ViewSpan> crossing(const Near& near, const Point& to_m,
                                                   double dt_s) const
    {
        const ViewWindow& window = m_model.m_window;
        const std::optional<ViewSpan> span = window.crossing(near.from_m, to_m);
        if (!span || !m_model.m_paysForSamples)
            return span;
        const Berg& berg = m_model.berg(near.iceberg);
        const double sigma_m2 =
            m_model
                .growthUntil(near.iceberg, m_model.accountOf(m_state, near.iceberg),
                             m_from_s + span->enter * dt_s)
                .sigma_m2;
        if (berg.bit == 0 &&
            berg.account.deviatesLess(sigma_m2, window.inside_m(near.from_m, to_m)))
            return span;
        return m_model.windowOf(near.iceberg, sigma_m2).crossing(near.from_m, to_m);
    }

    void see(ModelPlace iceberg, double enter_s, double until_s)
    {
        if (m_views)
            m_views->push_back({.iceberg = iceberg, .enter_s = enter_s, .leave_s = until_s});
        const ModelPlace owner = m_model.icebergAt(iceberg);
        CoverageState::Account& account = m_state.accounts[toIndex(owner)];
        const unsigned bit = m_model.berg(iceberg).bit;
        m_state.cost_m2s += m_model.passOthers_m2s(owner, account, enter_s);
        if (bit != 0) {
            m_state.cost_m2s += m_model.viewPlace_m2s(iceberg, account, enter_s);
            return;
        }
        const bool isNew = m_model.berg(iceberg).chance < 1
                               ? enter_s > account.searched_s + kNewChance_s
                               : enter_s - account.paid_s > kShortest_s;
        if (isNew && m_sightings)
            m_sightings->push_back({iceberg, enter_s});
        m_state.cost_m2s +=
            m_model.view_m2s(iceberg, account, isNew ? enter_s : account.paid_s, until_s);
    }

    const CoverageModel& m_model;
    CoverageState& m_state;
    ModelPlace m_target; ///< Place that ends the leg, or `CoverageLeg::kNoPlace`.
    std::vector<CoverageSighting>* m_sightings;
    std::vector<CoverageView>* m_views;
    double m_from_s = 0;
    double m_end_s = 0;
    std::span<Near> m_near;
    std::array<Near, 16> m_few;
    std::vector<Near> m_many; ///< All selected icebergs if there is no room for them in `m_few`.
};

bool CoverageModel::fly(CoverageState& state, const CoverageLeg& leg,
                        std::vector<CoverageSighting>* sightings,
                        std::vector<CoverageView>* views) const
{
    if (atEnd(state) || (!leg.isHold() && inView(state, leg.iceberg)))
        return false;
    const double from_s = state.time_s;
    const TangentTurn turn = leg.isHold() ? holdTurn(state, leg) : turnOf(state, leg);
    Flight flight(*this, state, leg.iceberg, sightings, views);
    const double stay_m = leg.isHold() ? 0 : m_speed_mps * leg.stay_s;
    const bool isLine =
        !flight.turn(turn.turn_rad, turn.end) && (!leg.isHold() || turn.length_m > 0);
    if (isLine || stay_m > 0)
        flight.selectAhead((isLine ? turn.length_m : 0) + stay_m);
    if (isLine)
        flight.straight(turn.length_m);
    if (stay_m > 0 && !atEnd(state))
        flight.stay(stay_m);
    if (!m_isAlone)
        passOthers(state);
    return state.time_s - from_s > kShortest_s;
}

} // namespace berg
