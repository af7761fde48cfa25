#include "core/coverage/coverage_model.h"

#include "core/coverage/view_axes.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace berg {

namespace {

/** Turns are divided into arcs on which a point moves almost straight through the view. */
constexpr double kLongestArc_s = 1;
constexpr double kLongestArc_rad = 0.21;

/**
 * Part of the view, about its middle, in which the place of a lost iceberg must lie to be searched.
 */
constexpr double kPlace = 0.25;

double largestQ_m2ps(const PredictionInput& input)
{
    double q_m2ps = 0;
    for (const Track& track : input.tracks)
        q_m2ps = std::max(q_m2ps, track.q_m2ps);
    return q_m2ps;
}

/** Returns the acceptance radius with the margin of a view, or nullopt if there is none. */
std::optional<ViewWindow> reachWindow(const PredictionInput& input)
{
    if (!input.reachRadius_m)
        return std::nullopt;
    return ViewWindow({.fov_m = Point::Constant(2 * *input.reachRadius_m), .shape = FovShape::Disk},
                      viewMargin_m(largestQ_m2ps(input)));
}

/**
 * Returns the point nearest to `p_m`, in axes of the view, that is just inside or outside of it.
 */
Point atEdge(const ViewWindow& window, Point p_m, bool inside)
{
    constexpr double kFromEdge_m = 1;
    const Point half_m = window.half_m() + Point::Constant(inside ? -kFromEdge_m : kFromEdge_m);
    if (window.shape() == FovShape::Disk) {
        const double far_m = p_m.norm();
        return far_m > 0 ? Point(p_m * (half_m.x() / far_m)) : Point(half_m.x(), 0);
    }
    if (inside)
        return p_m.cwiseMax(-half_m).cwiseMin(half_m);
    const Point clearance_m = half_m - p_m.cwiseAbs();
    const int axis = clearance_m.x() < clearance_m.y() ? 0 : 1;
    p_m[axis] = std::copysign(half_m[axis], p_m[axis]);
    return p_m;
}

/**
 * Returns the assumed position of an iceberg. This is its estimate, moved to the side of the view's
 * edge on which the iceberg is. An estimate in view that is not seen is wrong; one near the edge of
 * the sensor's view may be seen although it is outside the narrower view of the plan.
 */
Point likelyPlace_m(const ViewWindow& window, const Pose& uav, const Point& estimate_m, bool inView)
{
    const ViewAxes axes = axesOf(window, uav);
    const Point p_m = axes.coordinates(estimate_m);
    if (window.contains(p_m) == inView)
        return estimate_m;
    const Point likely_m = atEdge(window, p_m, inView);
    return axes.origin_m + rotated(likely_m, axes.x.x(), axes.x.y());
}

} // namespace

std::optional<ModelPlace> firstIceberg(const CoveragePlan& plan)
{
    const auto leg = std::ranges::find_if_not(plan, &CoverageLeg::isHold);
    return leg == plan.end() ? std::nullopt : std::optional(leg->iceberg);
}

CoverageModel::CoverageModel(const PredictionInput& input, const CoverageHorizon& horizon)
    : m_window(input.sensor, viewMargin_m(largestQ_m2ps(input)))
    , m_placeWindow(m_window.scaled(kPlace))
    , m_reachWindow(reachWindow(input))
    , m_reach_m(std::max(m_window.reach_m(), m_reachWindow ? m_reachWindow->reach_m() : 0))
    , m_paysForSamples(input.observer.model != ObserverModel::Simple)
    , m_horizon(horizon)
    , m_flightEnd_s(std::min(horizon.length_s, horizon.flown_s))
    , m_uav(poseOf(input.uav))
    , m_wind_mps(input.motion.wind_mps)
    , m_speed_mps(input.motion.airspeed_mps)
    , m_limit_radps(input.motion.limit_radps)
    , m_radius_m(input.motion.airspeed_mps / input.motion.limit_radps)
    , m_arc_s(std::min(kLongestArc_s, kLongestArc_rad / m_limit_radps))
    , m_cosineOfArc(std::cos(m_limit_radps * m_arc_s))
    , m_sineOfArc(std::sin(m_limit_radps * m_arc_s))
{
    for (std::size_t i = 0; i < input.tracks.size(); ++i) {
        const Track& track = input.tracks[i];
        const double weight = input.weights.empty() ? 1 : input.weights[i];
        // The velocity of now is kept, also if a forecast gives another current later: predictions
        // cover 800 s as a rule, and each plan starts anew. A current that changes by 0.1 m/s in an
        // hour moves an iceberg by 9 m in that time, far less than the field of view, while paths
        // over places that accelerate would have no closed form.
        m_bergs.push_back({.place_m = track.estimate_m(input.time_s),
                           .velocity_mps = track.velocity_mps - m_wind_mps,
                           .account = VisitCovariance(track, input.observer, weight)});
        Berg& berg = m_bergs.back();
        if (m_paysForSamples && track.status != TrackStatus::Tracked)
            berg.chance = input.chances.empty() ? kChanceOfLost : input.chances[i];
        berg.owner = ModelPlace::of(i);
        if (berg.chance < 1 && i < input.places.size() && !input.places[i].empty())
            continue;
        const ViewWindow window =
            track.inView ? windowOf(berg.owner, berg.account.start().position_m2) : m_window;
        berg.place_m = likelyPlace_m(window, m_uav, berg.place_m, track.inView);
        m_fastest_mps = std::max(m_fastest_mps, berg.velocity_mps.norm());
    }
    m_icebergs = m_bergs.size();
    m_offsets_m.resize(m_icebergs, Point::Zero());
    for (std::size_t i = 0; i < std::min(m_icebergs, input.places.size()); ++i) {
        if (!(m_bergs[i].chance < 1))
            continue;
        const Berg about = m_bergs[i];
        for (std::size_t k = 0; k < input.places[i].size(); ++k) {
            const SearchPlace& place = input.places[i][k];
            Berg& berg = k == 0 ? m_bergs[i] : m_bergs.emplace_back(about);
            m_offsets_m.resize(m_bergs.size());
            m_offsets_m[k == 0 ? i : m_bergs.size() - 1] = place.offset_m;
            berg.place_m = about.place_m + place.offset_m;
            berg.chance = place.chance;
            berg.bit = 1U << k;
            m_fastest_mps = std::max(m_fastest_mps, berg.velocity_mps.norm());
        }
    }
    if (input.wind.nextChange_s(0) < m_horizon.length_s)
        followWind(input.wind);
    setOthers({});
}

/**
 * Sums up the changes of the wind. They move all icebergs alike in the frame of the air, which is
 * exact at the ends of pieces of a leg.
 */
void CoverageModel::followWind(const WindAhead& wind)
{
    m_carried_m.emplace_back(Point::Zero());
    double fastest_mps = 0;
    for (double from_s = 0; from_s < m_horizon.length_s; from_s += kCarriedStep_s) {
        const Point change_mps = wind.at_mps(from_s + kCarriedStep_s / 2) - m_wind_mps;
        fastest_mps = std::max(fastest_mps, change_mps.norm());
        m_carried_m.emplace_back(m_carried_m.back() + kCarriedStep_s * change_mps);
    }
    m_fastest_mps += fastest_mps;
}

void CoverageModel::setOthers(std::vector<CoverageView> views)
{
    m_isAlone = views.empty();
    std::sort(views.begin(), views.end(), [this](const CoverageView& a, const CoverageView& b) {
        return std::tuple(icebergAt(a.iceberg), a.enter_s, a.iceberg) <
               std::tuple(icebergAt(b.iceberg), b.enter_s, b.iceberg);
    });
    m_others.clear();
    m_firstOfOther.clear();
    auto view = views.begin();
    for (const ModelPlace i : ModelPlaceRange(m_icebergs)) {
        m_firstOfOther.push_back(m_others.size());
        for (; view != views.end() && icebergAt(view->iceberg) == i; ++view)
            if (m_others.size() > m_firstOfOther.back() && m_others.back().place == view->iceberg &&
                view->enter_s <= m_others.back().leave_s + kShortest_s)
                m_others.back().leave_s = std::max(m_others.back().leave_s, view->leave_s);
            else if (view->enter_s < m_horizon.length_s && view->leave_s > kShortest_s)
                m_others.push_back(
                    {.enter_s = view->enter_s, .leave_s = view->leave_s, .place = view->iceberg});
        m_others.push_back({});
        // Sigma is 0 after a view with the simple observer, so the rest does not depend on earlier
        // views.
        for (std::size_t k = m_others.size() - 1; !m_paysForSamples && k-- > m_firstOfOther.back();)
            m_others[k].rest_m2s = restOf_m2s(i, {.paid_s = m_others[k].leave_s, .next = k + 1});
    }
}

double CoverageModel::viewPlace_m2s(ModelPlace place, CoverageState::Account& account,
                                    double time_s) const
{
    const Berg& berg = this->berg(place);
    if ((account.viewed & berg.bit) != 0)
        return 0;
    double cost_m2s = 0;
    if (time_s > account.paid_s) {
        cost_m2s = berg.account.grow(account.known, time_s - account.paid_s);
        account.paid_s = time_s;
    }
    berg.account.searchLost(account.known, std::min(1.0, berg.chance / account.left));
    account.left = std::max(1e-3, account.left - berg.chance);
    account.viewed |= berg.bit;
    return cost_m2s;
}

ModelPlace CoverageModel::placeNear(ModelPlace iceberg, const Point& offset_m) const
{
    ModelPlace nearest = iceberg;
    for (const ModelPlace place : places())
        if (icebergAt(place) == iceberg &&
            (this->offset_m(place) - offset_m).norm() < (this->offset_m(nearest) - offset_m).norm())
            nearest = place;
    return nearest;
}

double CoverageModel::chanceAt(const CoverageState& state, ModelPlace place) const
{
    const Berg& berg = this->berg(place);
    return berg.bit == 0 ? 1 : berg.chance / accountOf(state, place).left;
}

double CoverageModel::restOf_m2s(ModelPlace iceberg, const CoverageState::Account& account) const
{
    const OtherView& next = m_others[account.next];
    const bool isLast = next.enter_s >= m_horizon.length_s;
    const VisitCovariance::Growth end = berg(iceberg).account.growth(
        account.known, (isLast ? m_horizon.length_s : next.enter_s) - account.paid_s);
    if (isLast)
        return end.cost_m2s + m_horizon.rest_s * end.sigma_m2;
    if (!m_paysForSamples)
        return end.cost_m2s + next.rest_m2s;
    CoverageState::Account after = account;
    double cost_m2s = 0;
    while (m_others[after.next].enter_s < m_horizon.length_s)
        cost_m2s += passOthers_m2s(iceberg, after, m_others[after.next].enter_s);
    return cost_m2s + restOf_m2s(iceberg, after);
}

double CoverageModel::view_m2s(ModelPlace iceberg, CoverageState::Account& account, double enter_s,
                               double leave_s) const
{
    const Berg& berg = this->berg(iceberg);
    const bool isLost = berg.chance < 1;
    if (isLost && enter_s <= account.searched_s + kNewChance_s) {
        account.searched_s = std::max(account.searched_s, leave_s);
        return 0;
    }
    double cost_m2s = 0;
    if (enter_s > account.paid_s) {
        cost_m2s += berg.account.grow(account.known, enter_s - account.paid_s);
        account.paid_s = enter_s;
    }
    if (isLost) {
        berg.account.searchLost(account.known, berg.chance);
        account.searched_s = leave_s;
    } else if (leave_s >= account.paid_s) {
        cost_m2s += berg.account.sample(account.known, leave_s - account.paid_s);
        account.paid_s = leave_s;
    }
    return cost_m2s;
}

void CoverageModel::passOthers(CoverageState& state) const
{
    for (std::size_t i = 0; i < m_icebergs; ++i)
        state.cost_m2s += passOthers_m2s(ModelPlace::of(i), state.accounts[i], state.time_s);
}

CoverageState CoverageModel::start() const
{
    CoverageState state{.uav = m_uav};
    for (std::size_t i = 0; i < m_icebergs; ++i)
        state.accounts.push_back(
            {.paid_s = 0, .known = m_bergs[i].account.start(), .next = m_firstOfOther[i]});
    if (!m_isAlone)
        passOthers(state);
    return state;
}

/** The delay of the patrol is that of its second visit, reached from the end of the legs. */
double CoverageModel::totalWithTail_m2s(const CoverageState& state) const
{
    const double shift_s = m_tail->shift_s(state.uav, state.time_s);
    double cost_m2s = state.cost_m2s + m_tail->rest_m2s +
                      shift_s * (m_tail->slope_m2 + shift_s * m_tail->bend_m2ps);
    for (std::size_t i = 0; i < m_icebergs; ++i) {
        const double next_s =
            std::clamp(std::min(m_tail->nextOwn_s[i] + shift_s, m_tail->nextOther_s[i]),
                       std::min(state.time_s, m_horizon.length_s), m_horizon.length_s);
        const auto iceberg = ModelPlace::of(i);
        if (m_isAlone) {
            cost_m2s += growthUntil(iceberg, state.accounts[i], next_s).cost_m2s;
            continue;
        }
        CoverageState::Account account = state.accounts[i];
        cost_m2s += passOthers_m2s(iceberg, account, next_s);
        cost_m2s += growthUntil(iceberg, account, next_s).cost_m2s;
    }
    // Legs after which the UAV cannot come home in time are worse than all others.
    return cost_m2s * (1 + std::max(0.0, m_tail->late_s(state.uav, state.time_s)));
}

double CoverageModel::total_m2s(const CoverageState& state) const
{
    if (m_tail)
        return totalWithTail_m2s(state);
    double cost_m2s = state.cost_m2s;
    for (std::size_t i = 0; i < m_icebergs; ++i)
        cost_m2s += restOf_m2s(ModelPlace::of(i), state.accounts[i]);
    return cost_m2s;
}

double CoverageModel::costSoFar_m2s(const CoverageState& state) const
{
    double cost_m2s = state.cost_m2s;
    for (std::size_t i = 0; i < m_icebergs; ++i) {
        const CoverageState::Account& account = state.accounts[i];
        cost_m2s += growthUntil(ModelPlace::of(i), account, state.time_s).cost_m2s;
    }
    return cost_m2s;
}

double CoverageModel::sigma_m2(const CoverageState& state, ModelPlace iceberg) const
{
    return growthUntil(iceberg, accountOf(state, iceberg), state.time_s).sigma_m2;
}

bool CoverageModel::inView(const CoverageState& state, ModelPlace iceberg) const
{
    if ((accountOf(state, iceberg).viewed & berg(iceberg).bit) != 0)
        return true; // Another view of the place changes nothing.
    const Point place_m =
        axesOf(m_window, state.uav).coordinates(this->place_m(iceberg, state.time_s));
    return m_window.contains(place_m) &&
           (!m_paysForSamples || windowOf(iceberg, sigma_m2(state, iceberg)).contains(place_m));
}

double CoverageModel::distance_m(const CoverageState& state, ModelPlace iceberg) const
{
    return (place_m(iceberg, state.time_s) - state.uav.position_m).norm();
}

} // namespace berg
