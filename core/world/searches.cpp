#include "core/world/searches.h"

#include <algorithm>
#include <utility>

namespace berg {

std::size_t Searches::count() const
{
    const auto underWay = std::ranges::count_if(
        m_byUav, [](const std::optional<Search>& search) { return search.has_value(); });
    return m_givenUp.size() + static_cast<std::size_t>(underWay);
}

Search Searches::take(int uav)
{
    return std::move(*std::exchange(m_byUav[toIndex(uav)], std::nullopt));
}

void Searches::end(IcebergIndex iceberg)
{
    for (std::optional<Search>& search : m_byUav)
        if (search && search->iceberg == iceberg)
            search.reset();
    std::erase_if(m_givenUp, [iceberg](const Search& search) { return search.iceberg == iceberg; });
}

void Searches::grow(IcebergIndex iceberg, double added_m2)
{
    for (std::optional<Search>& search : m_byUav)
        if (search && search->iceberg == iceberg)
            search->path.grow(added_m2);
    for (Search& search : m_givenUp)
        if (search.iceberg == iceberg)
            search.path.grow(added_m2);
}

void Searches::miss(IcebergIndex iceberg, std::span<const FieldOfView> views,
                    const Point& estimate_m, double detection)
{
    for (std::optional<Search>& search : m_byUav)
        if (search && search->iceberg == iceberg)
            for (const FieldOfView& view : views)
                search->path.miss(view, estimate_m, detection);
}

void Searches::missOfPlan(IcebergIndex iceberg, std::span<const FieldOfView> views,
                          const Point& estimate_m, double detection)
{
    for (Search& search : m_givenUp)
        if (search.iceberg == iceberg)
            for (const FieldOfView& view : views)
                search.path.miss(view, estimate_m, detection);
}

const Search* Searches::ofIceberg(IcebergIndex iceberg) const
{
    for (const std::optional<Search>& search : m_byUav)
        if (search && search->iceberg == iceberg)
            return &*search;
    const auto left = std::ranges::find(m_givenUp, iceberg, &Search::iceberg);
    return left == m_givenUp.end() ? nullptr : &*left;
}

} // namespace berg
