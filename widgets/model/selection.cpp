#include "widgets/model/selection.h"

#include "core/scenario/scenario.h"

#include <algorithm>

namespace berg {

bool Selection::contains(const std::string& id) const
{
    return std::find(m_ids.begin(), m_ids.end(), id) != m_ids.end();
}

void Selection::set(std::vector<std::string> ids)
{
    std::vector<std::string> distinct;
    for (std::string& id : ids)
        if (std::find(distinct.begin(), distinct.end(), id) == distinct.end())
            distinct.push_back(std::move(id));
    if (distinct == m_ids)
        return;
    m_ids = std::move(distinct);
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
    const auto hasId = [](const auto& objects, const std::string& id) {
        return std::any_of(objects.begin(), objects.end(),
                           [&](const auto& object) { return object.id == id; });
    };
    std::vector<std::string> kept;
    for (const std::string& id : m_ids)
        if (hasId(scenario.icebergs, id) || hasId(scenario.uavs, id))
            kept.push_back(id);
    set(std::move(kept));
}

} // namespace berg
