#include "core/presets/generate.h"

#include "core/base/angles.h"
#include "core/checks/findings.h"
#include "core/checks/validate.h"
#include "core/presets/field_draws.h"
#include "core/presets/presets.h"
#include "core/scenario/text_checks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace berg {

namespace {

/** Failed draws in a row after which the area counts as full; takes milliseconds. */
constexpr int kMostMisses = 5000;
constexpr double kAnySpread_deg = 180;

void checkSpan(const char* lowField, const char* highField, const Span& span, const Limits& limits,
               Findings& faults)
{
    faults.inRange(span.low, limits, lowField);
    faults.inRange(span.high, limits, highField);
    if (span.low > span.high)
        faults.error(highField, IssueId::BelowOther, {FieldPath{lowField}});
}

void raise(Findings& faults)
{
    if (std::vector<Issue> issues = faults.take(); !issues.empty())
        throw Error(ErrorCode::InvalidInput, "generate", std::move(issues));
}

void checkArea(const FieldRequest& request, Findings& faults)
{
    const std::vector<Point>& area_m = request.area_m;
    const auto isFlat = [&area_m](int axis) {
        return std::ranges::all_of(
            area_m, [&](const Point& p_m) { return p_m[axis] == area_m.front()[axis]; });
    };
    const auto isPlace = [](const Point& p_m) {
        return p_m.allFinite() && p_m.cwiseAbs().maxCoeff() <= kLargestCoordinate_m;
    };
    if (area_m.size() < 3 || area_m.size() > kMostAreaCorners)
        faults.error("area_m", IssueId::AreaCorners,
                     {countOf(kMostAreaCorners), countOf(area_m.size())});
    else if (!std::all_of(area_m.begin(), area_m.end(), isPlace))
        faults.error("area_m", IssueId::CornersTooFar, {kLargestCoordinate_m});
    else if (isFlat(0) || isFlat(1))
        faults.error("area_m", IssueId::AreaTooThin, {countOf(0), request.icebergs});
    else if (!isSimplePolygon(area_m))
        faults.error("area_m", IssueId::AreaNotSimple);
}

void check(const Scenario& scenario, const FieldRequest& request)
{
    Findings faults(Findings::Kind::All);
    const double room =
        static_cast<double>(kMostIcebergs) - static_cast<double>(scenario.icebergs.size());
    if (room < 1)
        faults.error("icebergs", IssueId::NoRoom);
    else
        faults.inRange(request.icebergs, {.low = 1, .high = room}, "icebergs");
    checkArea(request, faults);
    checkSpan("speedMin_mps", "speedMax_mps", {request.speedMin_mps, request.speedMax_mps},
              limits::kSpeed_mps, faults);
    faults.inRange(request.towards_deg, {.low = -360, .high = 360}, "towards_deg");
    faults.inRange(request.spread_deg, {.low = 0, .high = kAnySpread_deg}, "spread_deg");
    checkSpan("sigmaMin_m2", "sigmaMax_m2", {request.sigmaMin_m2, request.sigmaMax_m2},
              limits::kSigma_m2, faults);
    faults.inRange(request.q_m2ps, limits::kGrowth_m2ps, "q_m2ps");
    if (request.seed < 0)
        faults.error("seed", IssueId::Negative);
    faults.inRange(request.spacing_m, limits::kLength_m, "spacing_m");
    raise(faults);
}

FieldDraws drawsOf(const FieldRequest& request)
{
    FieldDraws draws{.low_m = request.area_m.front(),
                     .high_m = request.area_m.front(),
                     .speed_mps = {request.speedMin_mps, request.speedMax_mps},
                     .direction_rad = {0, 2 * kPi},
                     .sigma_m2 = {request.sigmaMin_m2, request.sigmaMax_m2},
                     .q_m2ps = request.q_m2ps};
    for (const Point& corner_m : request.area_m) {
        draws.low_m = draws.low_m.cwiseMin(corner_m);
        draws.high_m = draws.high_m.cwiseMax(corner_m);
    }
    if (request.spread_deg < kAnySpread_deg) {
        const double middle_rad = radFromDeg(90 - request.towards_deg);
        const double spread_rad = radFromDeg(request.spread_deg);
        draws.direction_rad = {middle_rad - spread_rad, middle_rad + spread_rad};
    }
    return draws;
}

/**
 * Positions with a minimum distance, stored in cells of that size, so conflicts are within nine
 * cells.
 */
class SpacedPlaces
{
public:
    explicit SpacedPlaces(double spacing_m) : m_spacing_m(spacing_m) {}

    [[nodiscard]] bool isFree(const Point& p_m) const
    {
        if (m_spacing_m <= 0)
            return true;
        const Cell cell = cellOf(p_m);
        for (std::int64_t column = cell.first - 1; column <= cell.first + 1; ++column)
            for (std::int64_t row = cell.second - 1; row <= cell.second + 1; ++row)
                if (isTaken({column, row}, p_m))
                    return false;
        return true;
    }
    void add(const Point& p_m)
    {
        if (m_spacing_m > 0)
            m_places[cellOf(p_m)].push_back(p_m);
    }

private:
    using Cell = std::pair<std::int64_t, std::int64_t>;

    [[nodiscard]] Cell cellOf(const Point& p_m) const
    {
        return {static_cast<std::int64_t>(std::floor(p_m.x() / m_spacing_m)),
                static_cast<std::int64_t>(std::floor(p_m.y() / m_spacing_m))};
    }
    [[nodiscard]] bool isTaken(const Cell& cell, const Point& p_m) const
    {
        const auto it = m_places.find(cell);
        return it != m_places.end() &&
               std::any_of(it->second.begin(), it->second.end(), [&](const Point& other_m) {
                   return (other_m - p_m).norm() < m_spacing_m;
               });
    }

    double m_spacing_m;
    std::map<Cell, std::vector<Point>> m_places;
};

/** Returns ids "berg-K" with increasing K that are not in use. */
class FreshIds
{
public:
    explicit FreshIds(const Scenario& scenario) : m_next(scenario.icebergs.size() + 1)
    {
        for (const Uav& uav : scenario.uavs)
            m_taken.insert(uav.id);
        for (const Iceberg& iceberg : scenario.icebergs)
            m_taken.insert(iceberg.id);
    }
    [[nodiscard]] std::string take()
    {
        std::string id;
        do
            id = "berg-" + std::to_string(m_next++);
        while (m_taken.count(id) > 0);
        return id;
    }

private:
    std::set<std::string> m_taken;
    std::size_t m_next;
};

[[noreturn]] void refuse(std::size_t placed, const FieldRequest& request)
{
    Findings faults(Findings::Kind::All);
    const IssueArgument found = countOf(placed);
    if (request.spacing_m > 0)
        faults.error("spacing_m", IssueId::PlacesTooFew,
                     {found, request.icebergs, request.spacing_m});
    else
        faults.error("area_m", IssueId::AreaTooThin, {found, request.icebergs});
    throw Error(ErrorCode::InvalidInput, "generate", faults.take());
}

} // namespace

std::vector<Iceberg> generateIcebergs(const Scenario& scenario, const FieldRequest& request)
{
    check(scenario, request);
    const FieldDraws draws = drawsOf(request);
    Random random(static_cast<std::uint64_t>(request.seed), stableHash("field"));
    SpacedPlaces places(request.spacing_m);
    for (const Iceberg& iceberg : scenario.icebergs)
        places.add(iceberg.position_m);
    FreshIds ids(scenario);

    std::vector<Iceberg> icebergs;
    for (int misses = 0; icebergs.size() < static_cast<std::size_t>(request.icebergs); ++misses) {
        if (misses == kMostMisses)
            refuse(icebergs.size(), request);
        const Point position_m = drawPosition(draws, random);
        if (!places.isFree(position_m) || !insidePolygon(request.area_m, position_m))
            continue;
        places.add(position_m);
        icebergs.push_back(drawIceberg(draws, position_m, random));
        icebergs.back().id = ids.take();
        if (request.fittedDrift)
            driftAsFitted(icebergs.back());
        misses = 0;
    }
    return icebergs;
}

} // namespace berg
