#include "core/bound/chain_costs.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace berg {

namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();
/** This exceeds the rounding of a chain of 16 additions in `float`. */
constexpr double kRoundingShare = 1e-5;

class ChainTable
{
public:
    ChainTable(const ViewCells& cells, const StageCost& price)
        : m_cells(cells)
        , m_price(price)
        , m_perRegion(static_cast<std::size_t>(cells.perRegion()))
        , m_perSet(static_cast<std::size_t>(cells.regions()) * m_perRegion)
        , m_cost((std::size_t{1} << cells.regions()) * m_perSet, kNever)
    {
    }

    void begin(std::span<const float> fromStart_s)
    {
        for (int j = 0; j < m_cells.regions(); ++j) {
            float* row = costs(std::uint32_t{1} << j, j);
            for (std::size_t c = 0; c < m_perRegion; ++c)
                row[c] = fromStart_s.empty()
                             ? 0.0F
                             : static_cast<float>(m_price.always) *
                                   fromStart_s[static_cast<std::size_t>(j) * m_perRegion + c];
        }
    }

    /** Extends the paths that end with this set by one region. Returns the least cost of the set.
     */
    double extend(std::uint32_t set)
    {
        float least = kNever;
        const float perSecond = perSecondAfter(set);
        for (int j = 0; j < m_cells.regions(); ++j) {
            if ((set >> j & 1U) == 0)
                continue;
            for (std::size_t c = 0; c < m_perRegion; ++c) {
                const float cost = costs(set, j)[c];
                least = std::min(least, cost);
                if (cost < kNever)
                    leave(set, j, c, perSecond);
            }
        }
        return least < kNever ? static_cast<double>(least) * (1 - kRoundingShare)
                              : std::numeric_limits<double>::infinity();
    }

    [[nodiscard]] std::int64_t workOf(std::uint32_t set) const
    {
        const int seen = std::popcount(set);
        return static_cast<std::int64_t>(seen) * (m_cells.regions() - seen) *
               static_cast<std::int64_t>(m_perRegion * m_perRegion);
    }

private:
    float* costs(std::uint32_t set, int last)
    {
        return &m_cost[set * m_perSet + static_cast<std::size_t>(last) * m_perRegion];
    }

    [[nodiscard]] float perSecondAfter(std::uint32_t set) const
    {
        double sum = m_price.always;
        for (int i = 0; i < m_cells.regions(); ++i)
            if ((set >> i & 1U) != 0)
                sum += m_price.perSeen[static_cast<std::size_t>(i)];
        return static_cast<float>(sum);
    }

    void leave(std::uint32_t set, int j, std::size_t c, float perSecond)
    {
        const float cost = costs(set, j)[c];
        const int cell = static_cast<int>(c);
        for (int k = 0; k < m_cells.regions(); ++k) {
            const std::uint32_t bit = std::uint32_t{1} << k;
            if ((set & bit) != 0)
                continue;
            if ((m_cells.touching(j, cell) & bit) != 0) {
                float& same = costs(set | bit, j)[c]; // The cell shows region k as well.
                same = std::min(same, cost);
            }
            const float* legs_s = m_cells.legs_s(j, cell, k);
            float* next = costs(set | bit, k);
            for (std::size_t x = 0; x < m_perRegion; ++x) {
                const float arrived = cost + perSecond * legs_s[x];
                next[x] = arrived < next[x] ? arrived : next[x];
            }
        }
    }

    const ViewCells& m_cells;
    const StageCost& m_price;
    std::size_t m_perRegion;
    std::size_t m_perSet;
    /** The index runs over sets, then the region last touched, then its cells. */
    std::vector<float> m_cost;
};

} // namespace

std::vector<double> chainCosts(const ViewCells& cells, const StageCost& price,
                               std::span<const float> fromStart_s, WorkMeter& meter)
{
    ChainTable table(cells, price);
    table.begin(fromStart_s);
    const std::uint32_t sets = std::uint32_t{1} << cells.regions();
    std::vector<double> least(sets, 0.0);
    for (std::uint32_t set = 1; set < sets; ++set) {
        if (!meter.spend(table.workOf(set)))
            return {};
        least[set] = table.extend(set);
    }
    return least;
}

std::int64_t chainWork(int regions, int perRegion)
{
    // The loops visit (seen x unseen) pairs of regions in every set, and all pairs of their cells.
    const std::int64_t pairs = regions < 2 ? 0 : regions * (regions - 1LL) << (regions - 2);
    return pairs * perRegion * perRegion;
}

} // namespace berg
