#include "core/bound/patrol_prices.h"

#include "core/bound/revisit_cost.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace berg {

namespace {

/** Largest numbers of cells of time in a usual gap between two visits, and in the whole run. */
constexpr double kCellsPerGap = 30;
constexpr double kMostPriceCells = 600;
/** All sums are reduced by this share, which exceeds their rounding here and in the simulation. */
constexpr double kPriceRounding = 1e-9;

} // namespace

PatrolPrices::PatrolPrices(const Scenario& scenario, const TrueMotion& motion,
                           std::span<const int> icebergs, int slices, const std::stop_token& stop)
    : m_scenario(scenario), m_motion(motion), m_icebergs(icebergs.begin(), icebergs.end())
{
    for (std::size_t i = 0; i < m_icebergs.size(); ++i)
        m_growth_m2ps.push_back(iceberg(i).q_m2ps);
    const auto edge = [&](int slice) {
        return static_cast<int>(std::int64_t{motion.blocks()} * slice / slices);
    };
    for (int s = 0; s < slices && !stop.stop_requested(); ++s)
        addSlice({.from = edge(s), .to = edge(s + 1)}, stop);
    if (stop.stop_requested())
        return;
    priceVisits();
    for (std::size_t s = 0; s + 1 < m_slices.size() && !stop.stop_requested(); ++s)
        addLoss(s, lossAfter_m2s(s, stop));
    m_lossAtStart_m2s = lossAtStart_m2s();
    cut();
}

void PatrolPrices::addSlice(EdgeRange range, const std::stop_token& stop)
{
    Slice& slice = m_slices.emplace_back(Slice{.range = range});
    const LegTimes legs(m_scenario, m_motion, m_icebergs, range, stop);
    if (stop.stop_requested())
        return;
    slice.zones = visitZones(legs, m_growth_m2ps, stop);
    const double root = slice.zones.rootSum / static_cast<double>(m_scenario.uavs.size());
    slice.mu_m2 = root * root;
}

void PatrolPrices::priceVisits()
{
    // A visit that costs more than a whole slice pays would cause losses at the edges.
    std::vector<double> paid_m2s;
    for (const Slice& slice : m_slices)
        if (slice.mu_m2 > 0)
            paid_m2s.push_back(slice.mu_m2 * length_s(slice));
    double most_m2s = std::numeric_limits<double>::infinity();
    if (m_slices.size() > 2 && !paid_m2s.empty()) {
        const auto low = paid_m2s.begin() + static_cast<std::ptrdiff_t>(paid_m2s.size() / 10);
        std::nth_element(paid_m2s.begin(), low, paid_m2s.end());
        most_m2s = *low;
    }
    for (Slice& slice : m_slices) {
        for (const double radius_s : slice.zones.radius_s)
            slice.groupVisit_m2s.push_back(std::min(most_m2s, 2 * slice.mu_m2 * radius_s));
        slice.mostVisit_m2s = *std::ranges::max_element(slice.groupVisit_m2s);
        for (std::size_t i = 0; i < m_icebergs.size(); ++i) {
            const auto group = static_cast<std::size_t>(slice.zones.groupOf[i]);
            slice.share.push_back(m_growth_m2ps[i] / slice.zones.growth_m2ps[group]);
            slice.visit_m2s.push_back(slice.share.back() * slice.groupVisit_m2s[group]);
        }
    }
}

double PatrolPrices::lossAfter_m2s(std::size_t s, const std::stop_token& stop) const
{
    const Slice& before = m_slices[s];
    const Slice& after = m_slices[s + 1];
    const LegTimes legs(m_scenario, m_motion, m_icebergs,
                        {.from = before.range.from, .to = after.range.to}, stop);
    const std::vector<double> legs_s = groupLegs_s(legs, before.zones, after.zones);
    const double mu_m2 = std::min(before.mu_m2, after.mu_m2);
    const auto columns = static_cast<std::size_t>(after.zones.groups());
    // Each pair of groups has R of the icebergs that they share, or nullopt if they share none.
    std::vector<std::optional<double>> shared_m2s(legs_s.size());
    for (std::size_t i = 0; i < m_icebergs.size(); ++i) {
        std::optional<double>& shared =
            shared_m2s[static_cast<std::size_t>(before.zones.groupOf[i]) * columns +
                       static_cast<std::size_t>(after.zones.groupOf[i])];
        shared = shared.value_or(0) + after.visit_m2s[i];
    }
    double loss_m2s = 0;
    for (std::size_t k = 0; k < legs_s.size(); ++k) {
        const double from_m2s = before.groupVisit_m2s[k / columns];
        const double to_m2s = after.groupVisit_m2s[k % columns];
        loss_m2s = std::max(loss_m2s, shared_m2s[k] ? (from_m2s + to_m2s) / 2 - *shared_m2s[k]
                                                    : (from_m2s + to_m2s) / 2 - mu_m2 * legs_s[k]);
    }
    return loss_m2s;
}

void PatrolPrices::addLoss(std::size_t s, double nextTo_m2s)
{
    // A leg to the next slice may come from an earlier slice, or from the start.
    double loss_m2s = nextTo_m2s;
    const double next_m2s = m_slices[s + 1].mostVisit_m2s / 2;
    double paid_m2s = m_slices[s].mu_m2 * length_s(m_slices[s]);
    for (std::size_t from = s; from-- > 0;) {
        paid_m2s += m_lossAfter_m2s[from];
        loss_m2s = std::max(loss_m2s, m_slices[from].mostVisit_m2s / 2 + next_m2s - paid_m2s);
        paid_m2s += m_slices[from].mu_m2 * length_s(m_slices[from]);
    }
    m_lossAfter_m2s.push_back(std::max(loss_m2s, next_m2s - paid_m2s));
}

double PatrolPrices::lossAtStart_m2s() const
{
    const Slice& first = m_slices.front();
    double sum_m2s = 0;
    for (const Uav& uav : m_scenario.uavs) {
        double loss_m2s = 0;
        for (std::size_t i = 0; i < m_icebergs.size(); ++i) {
            const double visit_m2s =
                first.groupVisit_m2s[static_cast<std::size_t>(first.zones.groupOf[i])];
            loss_m2s = std::max(
                loss_m2s, visit_m2s / 2 - first.mu_m2 * firstLeg_s(m_scenario, m_motion, uav,
                                                                   m_icebergs[i], first.range.to));
        }
        sum_m2s += loss_m2s;
    }
    return sum_m2s;
}

void PatrolPrices::cut()
{
    double gap_s = 0; // The usual gap is the mean over all icebergs and slices.
    for (const Slice& slice : m_slices)
        for (std::size_t i = 0; i < m_icebergs.size(); ++i)
            gap_s += std::sqrt(2 * slice.visit_m2s[i] / m_growth_m2ps[i]) /
                     static_cast<double>(m_icebergs.size() * m_slices.size());
    const double end_s = m_motion.edge_s(m_motion.blocks());
    const double cell_s = std::max(gap_s / kCellsPerGap, end_s / kMostPriceCells);
    m_edges_s = {0};
    for (std::size_t s = 0; s < m_slices.size(); ++s) {
        const double from_s = m_edges_s.back();
        const double to_s = m_motion.edge_s(m_slices[s].range.to);
        const int cells = std::max(1, static_cast<int>(std::ceil((to_s - from_s) / cell_s)));
        for (int k = 1; k <= cells; ++k) {
            m_edges_s.push_back(k == cells ? to_s : from_s + (to_s - from_s) * k / cells);
            m_sliceOf.push_back(s);
        }
    }
}

std::vector<double> PatrolPrices::costs_m2s(double scale) const
{
    std::vector<double> sum_m2s(m_edges_s.size(), 0.0);
    std::vector<double> visit_m2s(m_sliceOf.size());
    std::vector<double> stay_m2ps(m_sliceOf.size());
    for (std::size_t i = 0; i < m_icebergs.size(); ++i) {
        for (std::size_t cell = 0; cell < m_sliceOf.size(); ++cell) {
            const Slice& slice = m_slices[m_sliceOf[cell]];
            visit_m2s[cell] = scale * slice.visit_m2s[i];
            stay_m2ps[cell] = scale * slice.share[i] * slice.mu_m2;
        }
        SigmaGrowth growth{.q_m2ps = m_growth_m2ps[i]};
        if (iceberg(i).appears_s > 0) {
            const double from_s = iceberg(i).appears_s + m_scenario.dt_s;
            const auto begin = std::ranges::lower_bound(m_edges_s, from_s);
            if (begin == m_edges_s.end())
                continue;
            growth.startCell = static_cast<int>(begin - m_edges_s.begin());
            growth.mayBeInView = true;
        } else {
            growth.atStart_m2 = initialSigma_m2(iceberg(i));
        }
        const std::vector<double> costs_m2s = revisitCosts_m2s(
            {.edges_s = m_edges_s, .visit_m2s = visit_m2s, .stay_m2ps = stay_m2ps}, growth);
        const double first_m2s = growth.atStart_m2 * m_scenario.dt_s;
        for (std::size_t k = 0; k < costs_m2s.size(); ++k)
            sum_m2s[k] += std::max(0.0, costs_m2s[k] - first_m2s -
                                            m_growth_m2ps[i] * m_scenario.dt_s * m_edges_s[k] / 2);
    }
    return sum_m2s;
}

double PatrolPrices::length_s(const Slice& slice) const
{
    return m_motion.edge_s(slice.range.to) - m_motion.edge_s(slice.range.from);
}

FrequencyBound PatrolPrices::bound(double scale) const
{
    FrequencyBound bound{.times_s = m_edges_s, .zeta_m2s = costs_m2s(scale)};
    const auto uavs = static_cast<double>(m_scenario.uavs.size());
    double paid_m2s = scale * m_lossAtStart_m2s;
    double known_m2s = 0;
    for (std::size_t k = 0; k < m_edges_s.size(); ++k) {
        const std::size_t s = k == 0 ? 0 : m_sliceOf[k - 1];
        if (k > 0) {
            paid_m2s += scale * uavs * m_slices[s].mu_m2 * (m_edges_s[k] - m_edges_s[k - 1]);
            if (k > 1 && s != m_sliceOf[k - 2])
                paid_m2s += scale * uavs * m_lossAfter_m2s[s - 1];
        }
        const double last_m2s =
            std::max(m_slices[s].mostVisit_m2s, s == 0 ? 0 : m_slices[s - 1].mostVisit_m2s);
        const double all_m2s = paid_m2s + scale * uavs * last_m2s / 2;
        known_m2s = std::max(known_m2s, bound.zeta_m2s[k] - all_m2s -
                                            kPriceRounding * (bound.zeta_m2s[k] + all_m2s));
        bound.zeta_m2s[k] = known_m2s;
    }
    return bound;
}

} // namespace berg
