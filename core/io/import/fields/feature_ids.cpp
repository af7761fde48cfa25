#include "core/io/import/fields/feature_ids.h"

#include "core/io/import/fields/import_fields.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace berg {

void FeatureIds::add(const SightingTable& table, std::size_t first, const std::string& featureId,
                     bool isProperty)
{
    const std::string id = cleanText(featureId, kLongestId);
    m_isAny = m_isAny || !id.empty();
    m_ids.resize(first);
    m_isProperty.resize(first);
    m_isProperty.resize(table.sightings.size(), isProperty);
    while (m_ids.size() < table.sightings.size()) {
        m_budget.take(sizeof(std::string) + id.size());
        m_ids.push_back(id);
    }
}

void FeatureIds::finish(SightingTable& table)
{
    const bool isMapped = std::ranges::any_of(table.sightings, [](const Sighting& sighting) {
        return !sighting.ids.empty() && sighting.ids.front().rank == 0;
    });
    if (!m_isAny || isMapped)
        return;
    m_ids.resize(table.sightings.size());
    m_isProperty.resize(table.sightings.size(), true);
    const Sighting* const clash = clashing(table);
    if (clash != nullptr)
        table.noted.add(
            {.line = clash->line, .fault = IssueId::FeatureIdsTaken, .detail = clash->id});
    if (clash == nullptr && !arePropertiesNumbers(table))
        return;
    for (std::size_t row = 0; row < m_ids.size(); ++row)
        if (!m_ids[row].empty()) {
            table.sightings[row].id = m_ids[row];
            table.sightings[row].ids = {{.rank = 0, .text = m_ids[row]}}; // before all others
        }
}

std::string FeatureIds::propertyOf(const SightingTable& table, std::size_t row) const
{
    return m_isProperty[row] ? table.sightings[row].id : std::string();
}

const Sighting* FeatureIds::clashing(const SightingTable& table) const
{
    struct Seen
    {
        std::size_t row = 0;
        bool isTimeless = false;
        std::map<UtcTime, std::size_t> rows;
    };
    std::map<std::string, Seen> properties;
    const auto areTwo = [&](std::size_t a, std::size_t b) {
        return m_ids[a] != m_ids[b] && !m_ids[a].empty() && !m_ids[b].empty() &&
               !(table.sightings[a].place == table.sightings[b].place);
    };
    for (std::size_t row = 0; row < m_ids.size(); ++row) {
        const Sighting& sighting = table.sightings[row];
        const std::string property = propertyOf(table, row);
        if (property.empty())
            continue;
        const auto [it, isNew] = properties.try_emplace(
            property, Seen{.row = row, .isTimeless = !sighting.time, .rows = {}});
        Seen& seen = it->second;
        if (!isNew && (seen.isTimeless || !sighting.time) && areTwo(seen.row, row))
            return &sighting;
        if (sighting.time)
            if (const auto known = seen.rows.try_emplace(*sighting.time, row);
                !known.second && areTwo(known.first->second, row))
                return &sighting;
    }
    for (std::size_t row = 0; row < m_ids.size(); ++row) {
        const auto known = properties.find(m_ids[row]);
        if (propertyOf(table, row).empty() && !m_ids[row].empty() && known != properties.end() &&
            m_ids[known->second.row] != m_ids[row])
            return &table.sightings[known->second.row];
    }
    return nullptr;
}

bool FeatureIds::arePropertiesNumbers(const SightingTable& table) const
{
    std::map<std::string, std::size_t> linesOfIds;
    std::set<std::pair<std::string, std::size_t>> properties; // with the features that have them
    bool isRepeated = false;
    for (std::size_t row = 0; row < m_ids.size(); ++row) {
        const Sighting& sighting = table.sightings[row];
        const std::string property = propertyOf(table, row);
        if (property.empty() || m_ids[row].empty() || !sighting.time)
            return false;
        const auto [known, isNew] = linesOfIds.try_emplace(m_ids[row], sighting.line);
        isRepeated = isRepeated || (!isNew && known->second != sighting.line);
        const auto next = properties.lower_bound({property, 0});
        if (next != properties.end() && next->first == property && next->second != sighting.line)
            return false;
        properties.emplace(property, sighting.line);
    }
    return isRepeated;
}

} // namespace berg
