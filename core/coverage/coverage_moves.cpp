#include "core/coverage/coverage_moves.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace berg {

namespace {

/**
 * Limits of a random number below `kAll` that choose the move; the moves of one place come first.
 */
constexpr std::uint64_t kOffset = 40;
constexpr std::uint64_t kInsert = kOffset + 16;
constexpr std::uint64_t kRemove = kInsert + 12;
constexpr std::uint64_t kReplace = kRemove + 8;
constexpr std::uint64_t kSwap = kReplace + 8;
constexpr std::uint64_t kMove = kSwap + 10;
constexpr std::uint64_t kAll = kMove + 10;
/** Additional moves of holds, if keeping icebergs in view pays. */
constexpr std::uint64_t kHolds = 12;
/** Longest stay of a leg and longest hold. */
constexpr double kLongestStay_s = 60;
constexpr double kShortestHold_s = 0.3;

/**
 * Places are drawn as this power of a uniform number, because the front is flown first and most
 * often.
 */
constexpr double kFrontPower = 1.3;
/**
 * New icebergs are drawn as this power of a uniform number, among those by distance from the one
 * before.
 */
constexpr double kNearPower = 1.5;
/** Moves of two places keep within this number of legs. */
constexpr std::size_t kWithin = 8;
/** Largest step of an offset, of the largest offset. */
constexpr double kOffsetStep = 0.6;

auto at(CoveragePlan& plan, std::size_t place)
{
    return plan.begin() + static_cast<std::ptrdiff_t>(place);
}

/**
 * Returns the iceberg of the last leg before the place that has one, or of the first such leg after
 * it.
 */
ModelPlace icebergBefore(const CoveragePlan& plan, std::size_t place)
{
    for (std::size_t k = place; k-- > 0;)
        if (!plan[k].isHold())
            return plan[k].iceberg;
    for (std::size_t k = place; k < plan.size(); ++k)
        if (!plan[k].isHold())
            return plan[k].iceberg;
    return {};
}

} // namespace

CoverageMoves::CoverageMoves(const CoverageModel& model, const Random& random,
                             const std::vector<bool>& allowed)
    : m_allowed(allowed)
    , m_neighbours(static_cast<std::size_t>(model.placeCount()))
    , m_edge_m(model.largestOffset_m())
    , m_paysForSamples(model.paysForSamples())
    , m_random(random)
{
    for (const ModelPlace i : model.places())
        m_places_m.push_back(model.place_m(i, 0));
}

const std::vector<ModelPlace>& CoverageMoves::neighbours(ModelPlace iceberg)
{
    const std::size_t i = toIndex(iceberg);
    std::vector<ModelPlace>& others = m_neighbours[i];
    if (!others.empty())
        return others;
    std::vector<std::pair<double, ModelPlace>> distances;
    for (std::size_t j = 0; j < m_places_m.size(); ++j)
        if (j != i && (m_allowed.empty() || m_allowed[j]))
            distances.emplace_back((m_places_m[i] - m_places_m[j]).norm(), ModelPlace::of(j));
    std::ranges::sort(distances);
    for (const auto& [distance_m, j] : distances)
        others.push_back(j);
    return others;
}

std::size_t CoverageMoves::change(CoveragePlan& plan)
{
    const std::uint64_t dice = m_random.below(m_paysForSamples ? kAll + kHolds : kAll);
    if (dice >= kAll)
        return changeHold(plan);
    return dice < kReplace ? changeOne(plan, dice) : changeTwo(plan, dice);
}

std::size_t CoverageMoves::changeOne(CoveragePlan& plan, std::uint64_t dice)
{
    const std::size_t place = drawn(plan.size(), kFrontPower);
    if (dice < kOffset)
        changeLine(plan[place]);
    else if (dice < kInsert)
        plan.insert(at(plan, place), anyLeg(plan, place));
    else if (dice < kRemove)
        plan.erase(at(plan, place));
    else
        plan[place] = anyLeg(plan, place);
    return place;
}

std::size_t CoverageMoves::changeTwo(CoveragePlan& plan, std::uint64_t dice)
{
    const std::size_t a = drawn(plan.size(), kFrontPower);
    const std::size_t b = placeNear(a, plan.size());
    const auto [first, last] = std::minmax(a, b);
    if (dice < kSwap) {
        std::swap(plan[a], plan[b]);
    } else if (dice < kMove) {
        const CoverageLeg leg = plan[a];
        plan.erase(at(plan, a));
        plan.insert(at(plan, b), leg);
    } else {
        std::reverse(at(plan, first), at(plan, last) + 1);
        // In the reverse direction an iceberg lies on the other side of its line.
        for (std::size_t i = first; i <= last; ++i) {
            plan[i].offset_m = -plan[i].offset_m;
            plan[i].side = -plan[i].side;
        }
    }
    return first;
}

/** Adds a hold, or changes the next one from a random place on. */
std::size_t CoverageMoves::changeHold(CoveragePlan& plan)
{
    const std::size_t place = drawn(plan.size(), kFrontPower);
    const auto hold = std::find_if(at(plan, place), plan.end(),
                                   [](const CoverageLeg& leg) { return leg.isHold(); });
    if (m_random.below(2) == 0 || hold == plan.end()) {
        plan.insert(at(plan, place), anyHold());
        return place;
    }
    const auto changed = static_cast<std::size_t>(hold - plan.begin());
    if (m_random.below(4) == 0)
        plan.erase(hold);
    else
        vary(*hold);
    return changed;
}

/**
 * Changes the offset of a leg or the duration of its stay; for a hold, its duration or its kind.
 */
void CoverageMoves::changeLine(CoverageLeg& leg)
{
    if (leg.isHold())
        vary(leg);
    else if (!m_paysForSamples || m_random.below(2) == 0)
        leg.offset_m = nearOffset_m(leg.offset_m);
    else if (m_random.below(6) == 0)
        leg.stay_s = 0;
    else {
        const double step = m_random.uniform() - m_random.uniform();
        leg.stay_s = std::clamp(leg.stay_s * std::exp(step) + 4 * step, 0.0, kLongestStay_s);
    }
}

void CoverageMoves::vary(CoverageLeg& hold)
{
    if (m_random.below(5) == 0) {
        hold.side = static_cast<int>(m_random.below(3)) - 1;
        return;
    }
    const double step = m_random.uniform() - m_random.uniform();
    hold.stay_s =
        std::clamp(hold.stay_s * std::exp(1.2 * step) + 2 * step, kShortestHold_s, kLongestStay_s);
}

CoverageLeg CoverageMoves::anyHold()
{
    constexpr int kSides[] = {1, -1, 0, 0, 0};
    const int side = kSides[m_random.below(std::size(kSides))];
    const double share = m_random.uniform() * m_random.uniform();
    return holdOf(1 + share * (kLongestStay_s / 2 - 1), side);
}

std::size_t CoverageMoves::drawn(std::size_t count, double power)
{
    const double share = std::pow(m_random.uniform(), power);
    return std::min(count - 1, static_cast<std::size_t>(share * static_cast<double>(count)));
}

std::size_t CoverageMoves::placeNear(std::size_t place, std::size_t count)
{
    const std::size_t first = place - std::min(place, kWithin);
    const std::size_t last = std::min(count - 1, place + kWithin);
    return first + m_random.below(last - first + 1);
}

CoverageLeg CoverageMoves::anyLeg(const CoveragePlan& plan, std::size_t place)
{
    const ModelPlace before = icebergBefore(plan, place);
    const std::vector<ModelPlace>& others = neighbours(before);
    const ModelPlace iceberg = others.empty() ? before : others[drawn(others.size(), kNearPower)];
    CoverageLeg leg{.iceberg = iceberg, .offset_m = anyOffset_m()};
    if (m_paysForSamples && m_random.below(3) != 0) {
        const double share = m_random.uniform() * m_random.uniform();
        leg.stay_s = share * kLongestStay_s / 3;
    }
    return leg;
}

/**
 * Good lines often pass through the middle or the edges of the view, so these are drawn more often.
 */
double CoverageMoves::anyOffset_m()
{
    switch (m_random.below(4)) {
    case 0:
        return 0;
    case 1:
        return m_edge_m;
    case 2:
        return -m_edge_m;
    default:
        return m_random.uniform(-m_edge_m, m_edge_m);
    }
}

double CoverageMoves::nearOffset_m(double offset_m)
{
    if (m_random.below(3) == 0)
        return anyOffset_m();
    const double step_m = kOffsetStep * m_edge_m * (m_random.uniform() - m_random.uniform());
    return std::clamp(offset_m + step_m, -m_edge_m, m_edge_m);
}

} // namespace berg
