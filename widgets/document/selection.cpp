#include "widgets/document/selection.h"

#include "core/scenario/scenario.h"

#include <algorithm>
#include <string_view>
#include <unordered_set>
#include <utility>

namespace berg {

namespace {

constexpr std::string_view kNoFlyKey = "\xFF"
                                       "no-fly ";

} // namespace

std::string noFlyKey(std::size_t place)
{
    return std::string(kNoFlyKey) + std::to_string(place);
}

std::optional<std::size_t> noFlyPlace(const std::string& key)
{
    if (!key.starts_with(kNoFlyKey))
        return std::nullopt;
    return std::stoul(key.substr(kNoFlyKey.size()));
}

bool isOutlineKey(const std::string& key)
{
    return key == kAreaKey || noFlyPlace(key);
}

bool Selection::contains(const std::string& id) const
{
    return std::find(m_ids.begin(), m_ids.end(), id) != m_ids.end();
}

void Selection::set(std::vector<std::string> ids)
{
    std::unordered_set<std::string> known;
    std::erase_if(ids, [&known](const std::string& id) { return !known.insert(id).second; });
    if (ids == m_ids)
        return;
    m_ids = std::move(ids);
    emit changed();
}

void Selection::toggle(const std::string& id)
{
    if (std::erase(m_ids, id) == 0)
        m_ids.push_back(id);
    emit changed();
}

void Selection::clear()
{
    set({});
}

void Selection::keepExisting(const Scenario& scenario)
{
    const std::size_t areas = scenario.noFly.size();
    const std::size_t before = std::exchange(m_noFlyAreas, areas);
    const bool isAnotherList = before != 0 && areas != before;
    if (m_ids.empty())
        return;
    std::unordered_set<std::string_view> known;
    for (const Iceberg& iceberg : scenario.icebergs)
        known.insert(iceberg.id);
    for (const Uav& uav : scenario.uavs)
        known.insert(uav.id);
    const auto isThere = [&](const std::string& id) {
        if (id == kAssetKey)
            return scenario.asset.has_value();
        if (id == kAreaKey)
            return !scenario.area_m.empty();
        if (const std::optional<std::size_t> place = noFlyPlace(id))
            return !isAnotherList && *place < areas;
        return known.contains(id);
    };
    std::vector<std::string> remaining;
    std::copy_if(m_ids.begin(), m_ids.end(), std::back_inserter(remaining), isThere);
    set(std::move(remaining));
}

} // namespace berg
