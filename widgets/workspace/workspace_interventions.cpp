#include "widgets/document/scenario_edits.h"
#include "widgets/workspace/workspace.h"

#include <algorithm>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {

void Workspace::setTau(double tau)
{
    if (!inFlight()) {
        setPlanner(
            tr("Change trade-off"), [tau](PlannerSettings& planner) { planner.tau = tau; },
            u"tau"_s);
        return;
    }
    if (refuseIntervention())
        return;
    m_tauWanted = tau;
    if (!m_tauPause.isActive())
        flyTau();
}

void Workspace::flyTau()
{
    if (!m_tauWanted || !inFlight())
        return;
    m_runner.intervene({.tau = *std::exchange(m_tauWanted, std::nullopt)});
    m_tauPause.start();
}

void Workspace::setPolicy(PolicyKind policy)
{
    if (!inFlight())
        setPlanner(tr("Change policy"),
                   [policy](PlannerSettings& planner) { planner.policy = policy; });
    else if (!refuseIntervention())
        m_runner.intervene({.policy = policy});
}

void Workspace::reportSeen(const std::vector<std::string>& ids)
{
    std::vector<Intervention> sightings;
    for (const std::string& id : icebergsInFlight(ids))
        sightings.push_back({.seen = id});
    report(sightings);
}

void Workspace::report(const std::vector<Intervention>& sightings)
{
    if (!inFlight() || refuseIntervention())
        return;
    for (const Intervention& sighting : sightings)
        m_runner.intervene(sighting);
}

int Workspace::remove(const std::vector<std::string>& ids)
{
    if (!inFlight() || refuseIntervention())
        return 0;
    const MissionSnapshot& now = m_record.now;
    int count = 0;
    for (const std::string& id : icebergsInFlight(ids))
        if (now.active.at(toIndex(*indexOfId(now.icebergs, id)))) {
            m_runner.intervene({.removed = id});
            ++count;
        }
    return count;
}

void Workspace::assign(const std::vector<std::string>& icebergs, const std::string& uav)
{
    if (!inFlight()) {
        m_document.edit(tr("Assign iceberg"), [&](Scenario& scenario) {
            for (const std::string& id : icebergs)
                if (Iceberg* iceberg = findById(scenario.icebergs, id))
                    iceberg->uav = uav;
        });
        return;
    }
    if (refuseIntervention())
        return;
    for (const std::string& id : icebergsInFlight(icebergs))
        m_runner.intervene({.assigned = Assignment{.iceberg = id, .uav = uav}});
}

void Workspace::order(const std::vector<std::string>& ids, FlightOrder order)
{
    if (!inFlight() || refuseIntervention())
        return;
    for (const std::string& id : ids)
        if (std::ranges::find(m_record.scenario.uavs, id, &Uav::id) != m_record.scenario.uavs.end())
            m_runner.intervene({.commanded = UavCommand{.uav = id, .order = order}});
}

void Workspace::setWind(const Point& wind_mps)
{
    if (!inFlight())
        m_document.edit(tr("Change wind"), [&](Scenario& s) { s.wind_mps = wind_mps; });
    else if (!refuseIntervention())
        m_runner.intervene({.wind_mps = wind_mps});
}

void Workspace::moveAsset(const Point& position_m)
{
    if (!m_record.now.asset || !inFlight() || refuseIntervention())
        return;
    Asset asset = *m_record.now.asset;
    // The asset's position refers to time 0; it has moved since.
    asset.position_m = position_m - asset.velocity_mps * m_record.now.time_s;
    m_runner.intervene({.asset = asset});
}

void Workspace::setAssetMotion(const Point& position_m, const Point& velocity_mps)
{
    if (!inFlight()) {
        m_document.follow(u"asset"_s, [position_m, velocity_mps](Scenario& scenario) {
            if (!scenario.asset)
                return;
            scenario.asset->position_m = position_m;
            scenario.asset->velocity_mps = velocity_mps;
        });
        return;
    }
    if (!m_record.now.asset || !mayIntervene())
        return; // it comes again
    Asset asset = *m_record.now.asset;
    asset.velocity_mps = velocity_mps;
    asset.position_m = position_m - velocity_mps * m_record.now.time_s;
    m_runner.intervene({.asset = asset});
}

void Workspace::setHomes(const std::vector<Point>& homes_m)
{
    if (!inFlight()) {
        m_document.follow(u"homes"_s, [homes_m](Scenario& scenario) {
            for (std::size_t i = 0; i < std::min(homes_m.size(), scenario.uavs.size()); ++i) {
                scenario.uavs[i].position_m = homes_m[i];
                scenario.uavs[i].home_m.reset(); // it is the start
            }
        });
        return;
    }
    if (!mayIntervene())
        return; // it comes again
    const std::vector<Uav>& uavs = m_record.scenario.uavs;
    for (std::size_t i = 0; i < std::min(homes_m.size(), uavs.size()); ++i)
        m_runner.intervene({.home = HomeMove{.uav = uavs[i].id, .place_m = homes_m[i]}});
}

void Workspace::stopAssetMotion()
{
    m_document.stopFollowing(u"asset"_s);
}

void Workspace::stopHomeMotion()
{
    m_document.stopFollowing(u"homes"_s);
}

void Workspace::addIceberg(Iceberg iceberg)
{
    if (!inFlight() || refuseIntervention())
        return;
    iceberg.id = freshIdInFlight();
    m_placed.push_back(iceberg.id);
    m_runner.intervene({.appears = std::move(iceberg)});
}

/** Returns an id that neither the flight nor an iceberg being added has. */
std::string Workspace::freshIdInFlight() const
{
    Scenario flown = m_record.scenario;
    flown.icebergs = m_record.now.icebergs;
    for (const std::string& id : m_placed)
        if (findById(flown.icebergs, id) == nullptr)
            flown.icebergs.push_back({.id = id});
    return freshIcebergId(flown);
}

} // namespace berg
