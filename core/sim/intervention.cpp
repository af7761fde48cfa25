#include "core/sim/intervention.h"

#include "core/scenario/text_checks.h"

#include <algorithm>
#include <array>

namespace berg {

namespace {

/** Returns which members have a value, as an array for comparison. */
auto partsOf(const Intervention& i)
{
    return std::array{i.tau.has_value(),     i.policy.has_value(),   i.wind_mps.has_value(),
                      i.asset.has_value(),   i.appears.has_value(),  i.seen.has_value(),
                      i.removed.has_value(), i.assigned.has_value(), i.commanded.has_value(),
                      i.home.has_value()};
}

} // namespace

std::optional<int> indexOfId(const std::vector<Uav>& uavs, const std::string& id)
{
    const auto it = std::ranges::find(uavs, id, &Uav::id);
    return it == uavs.end() ? std::nullopt : std::optional(static_cast<int>(it - uavs.begin()));
}

std::optional<IcebergIndex> indexOfId(const std::vector<Iceberg>& icebergs, const std::string& id)
{
    const auto it = std::ranges::find(icebergs, id, &Iceberg::id);
    return it == icebergs.end() ? std::nullopt
                                : std::optional(IcebergIndex::of(it - icebergs.begin()));
}

std::optional<LastChange> lastChangeOf(std::span<const Intervention> interventions)
{
    if (interventions.empty())
        return std::nullopt;
    const Intervention& last = interventions.back();
    std::size_t before = interventions.size() - 1;
    while (before > 0 && interventions[before - 1].time_s == last.time_s &&
           partsOf(interventions[before - 1]) == partsOf(last))
        --before;
    return LastChange{.first = interventions[before], .before = before};
}

PlannerSettings withChanges(PlannerSettings settings, const Intervention& intervention)
{
    settings.tau = intervention.tau.value_or(settings.tau);
    settings.policy = intervention.policy.value_or(settings.policy);
    return settings;
}

std::vector<Issue> unknownNames(const Intervention& intervention, const std::vector<Uav>& uavs,
                                const NameableIcebergs& icebergs)
{
    std::vector<Issue> faults;
    const auto require = [&](bool isKnown, const char* field, IssueId id, const std::string& name) {
        if (!isKnown)
            faults.push_back({Severity::Error, field, {id, {printable(name)}}});
    };
    const auto requireIceberg = [&](bool isKnown, const char* field, const std::string& id) {
        require(isKnown, field, IssueId::NoSuchIceberg, id);
    };
    const auto requireUav = [&](const char* field, const std::string& id) {
        require(indexOfId(uavs, id).has_value(), field, IssueId::UnknownUav, id);
    };
    if (const auto& id = intervention.seen)
        requireIceberg(icebergs.isMonitored(*id), "seen", *id);
    if (const auto& id = intervention.removed)
        requireIceberg(icebergs.isRemovable(*id), "removed", *id);
    if (const auto& commanded = intervention.commanded)
        requireUav("commanded.uav", commanded->uav);
    if (const auto& home = intervention.home)
        requireUav("home.uav", home->uav);
    if (const auto& assigned = intervention.assigned) {
        requireIceberg(icebergs.isMonitored(assigned->iceberg), "assigned.iceberg",
                       assigned->iceberg);
        if (!assigned->uav.empty())
            requireUav("assigned.uav", assigned->uav);
    }
    return faults;
}

void apply(const Intervention& intervention, Simulation& world,
           const std::vector<Iceberg>& icebergs, const std::vector<Uav>& uavs)
{
    if (intervention.policy)
        world.setPolicy(*intervention.policy);
    if (intervention.tau || intervention.policy)
        world.requestPlan();
    if (intervention.wind_mps)
        world.setWind(*intervention.wind_mps);
    if (intervention.asset)
        world.setAsset(*intervention.asset);
    if (intervention.appears)
        world.addIceberg(*intervention.appears);
    if (intervention.seen)
        world.reportSighting(*indexOfId(icebergs, *intervention.seen), intervention.seenAge_s);
    if (intervention.removed)
        world.removeIceberg(*indexOfId(icebergs, *intervention.removed));
    if (intervention.assigned)
        world.assign(*indexOfId(icebergs, intervention.assigned->iceberg),
                     indexOfId(uavs, intervention.assigned->uav));
    if (intervention.commanded)
        world.order(*indexOfId(uavs, intervention.commanded->uav), intervention.commanded->order);
    if (intervention.home)
        world.setHome(*indexOfId(uavs, intervention.home->uav), intervention.home->place_m);
}

} // namespace berg
