#include "core/sim/simulation.h"

namespace berg {

Simulation::Simulation(const Scenario& scenario, std::span<const DriftNoise> noise)
    : m_fleet(scenario, noise), m_trigger(scenario.uavs.size(), scenario.planner.policy)
{
}

WorldState Simulation::state() const
{
    WorldState state{.step = step(),
                     .tracks = observer().tracks(),
                     .sigmaSum_m2 = observer().sigmaSum_m2(),
                     .zeta_m2s = m_zeta_m2s,
                     .unclustered = m_fleet.unclustered(),
                     .givenUp = observer().searches().givenUp(),
                     .closest_m = m_fleet.closest_m()};
    for (int k = 0; k < uavCount(); ++k)
        state.uavs.push_back(uav(k));
    return state;
}

UavState Simulation::uav(int uav) const
{
    UavState state = m_fleet.autopilot(uav).state();
    state.isAlone = m_trigger.isAlone(uav);
    state.search = observer().searches().of(uav);
    return state;
}

void Simulation::setTarget(int uav, std::optional<IcebergIndex> iceberg,
                           const std::optional<AimedLeg>& aim,
                           std::span<const IcebergIndex> members, bool keepsSearch)
{
    // Another UAV requested the plan; a UAV that keeps its target continues its leg.
    const bool mayContinueLeg = planReason(uav) == PlanReason::Fleet;
    m_trigger.answer(uav);
    m_fleet.setTarget(uav,
                      {.target = iceberg, .aim = aim, .members = {members.begin(), members.end()}},
                      mayContinueLeg, keepsSearch);
}

void Simulation::advanceStep(std::span<const std::optional<ExternalPose>> poses)
{
    require(planReason() == PlanReason::None, "advanceStep: a plan is needed first");
    require(!finished(), "advanceStep: the run is over");
    require(poses.empty() || poses.size() == static_cast<std::size_t>(uavCount()),
            "advanceStep: an entry for each UAV");
    m_fleet.advance(poses);
    m_zeta_m2s += observer().sigmaSum_m2() * world().dt_s();
    m_trigger.update(m_fleet);
}

void Simulation::setWind(const Point& wind_mps)
{
    m_fleet.setWind(wind_mps);
    requestPlan();
}

void Simulation::setAsset(const Asset& asset)
{
    m_fleet.setAsset(asset);
    requestPlan();
}

void Simulation::assign(IcebergIndex iceberg, std::optional<int> uav)
{
    require(iceberg >= 0 && iceberg < IcebergIndex::of(icebergCount()) &&
                (!uav || (*uav >= 0 && *uav < uavCount())),
            "assign: no such iceberg or UAV");
    m_fleet.observer().world().assign(iceberg, uav);
    requestPlan();
}

void Simulation::order(int uav, FlightOrder order)
{
    require(uav >= 0 && uav < uavCount(), "order: no such UAV");
    m_fleet.order(uav, order);
    requestPlan();
}

void Simulation::setHome(int uav, const Point& home_m)
{
    require(uav >= 0 && uav < uavCount(), "setHome: no such UAV");
    m_fleet.setHome(uav, home_m);
}

void Simulation::reportSighting(IcebergIndex iceberg, double age_s)
{
    m_fleet.observer().reportSighting(iceberg, age_s, m_fleet.report());
    requestPlan();
}

void Simulation::removeIceberg(IcebergIndex iceberg)
{
    m_fleet.observer().removeIceberg(iceberg);
    requestPlan();
}

void Simulation::addIceberg(const Iceberg& iceberg)
{
    m_fleet.observer().addIceberg(iceberg);
    m_trigger.needAll(PlanReason::Appeared, m_fleet);
}

} // namespace berg
