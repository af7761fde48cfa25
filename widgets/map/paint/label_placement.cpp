#include "widgets/map/paint/label_placement.h"

#include "core/base/angles.h"
#include "widgets/map/land/clipping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace berg {
namespace {

// Directions in the order a reader expects them: right first, as on charts.
constexpr std::array<double, 12> kAngles_deg = {0,  180, 35, -35, 145, -145,
                                                90, -90, 65, -65, 115, -115};
constexpr std::array<double, 7> kGaps_px = {3, 9, 17, 28, 42, 62, 90};
constexpr double kLeaderGap_px = 9; // from this gap on a label needs a leader line
constexpr double kMargin_px = 2;    // free margin around each label
constexpr double kReach_px = 160;   // farther objects cannot be touched
constexpr int kSweeps = 4;

// Cost of a candidate: hard faults by area, then preferences in pixels.
constexpr double kFault = 1e4;
constexpr double kLineCost = 2.5; // per pixel of line under the label
constexpr double kGapCost = 1.0;
constexpr double kAngleCost = 0.5;
// Gain that justifies moving a label; a label that overlaps nothing does not move to avoid a line.
constexpr double kStayGain = 14;
constexpr double kFreeStayGain = 2000;

double overlapArea(const QRectF& a, const QRectF& b)
{
    const double width_px = std::min(a.right(), b.right()) - std::max(a.left(), b.left());
    const double height_px = std::min(a.bottom(), b.bottom()) - std::max(a.top(), b.top());
    return width_px > 0 && height_px > 0 ? width_px * height_px : 0;
}

/** Rectangle beside the anchor in a direction, with its near side `gap_px` from the disk. */
QRectF candidate(const LabelRequest& request, double angle_deg, double gap_px)
{
    const double angle_rad = radFromDeg(angle_deg);
    const double reach_px = request.anchor.radius_px + gap_px;
    const double right = std::cos(angle_rad);
    const double up = std::sin(angle_rad);
    // On the axes the middle of a side faces the anchor, elsewhere a corner does.
    const double side = std::clamp(1.6 * right, -1.0, 1.0);
    const double rise = std::clamp(1.2 * up, -1.0, 1.0);
    const QPointF centre(
        request.anchor.centre_px.x() + right * reach_px + side * request.size_px.width() / 2,
        request.anchor.centre_px.y() - up * reach_px - rise * request.size_px.height() / 2);
    return {centre - QPointF(request.size_px.width() / 2, request.size_px.height() / 2),
            request.size_px};
}

/** Obstacles near one label, and the cost of a place among them. */
class Neighbourhood
{
public:
    Neighbourhood(const LabelRequest& request, const LabelSurroundings& all) : m_area(all.area)
    {
        const QPointF centre = request.anchor.centre_px;
        const double reach_px = kReach_px + request.size_px.width() + request.anchor.radius_px;
        const QRectF near(centre - QPointF(reach_px, reach_px), QSizeF(2, 2) * reach_px);
        for (const QRectF& solid : all.solids)
            if (near.intersects(solid))
                m_solids.push_back(solid);
        for (const LabelDisk& disk : all.disks)
            if (overlaps(near, disk))
                m_disks.push_back(disk);
        for (const QLineF& line : all.lines)
            if (lengthInside(near, line) > 0)
                m_lines.push_back(line);
    }

    [[nodiscard]] double faults(const QRectF& rect) const
    {
        const QRectF padded = rect.adjusted(-kMargin_px, -kMargin_px, kMargin_px, kMargin_px);
        // Clipping a label is worse than covering something.
        double cost = 4 * (rect.width() * rect.height() - overlapArea(rect, m_area));
        for (const QRectF& solid : m_solids)
            cost += overlapArea(padded, solid);
        for (const LabelDisk& disk : m_disks)
            if (overlaps(rect, disk))
                cost += rect.height() * rect.height();
        return kFault * cost;
    }

    [[nodiscard]] double crossings(const QRectF& rect) const
    {
        double cost = 0;
        for (const QLineF& line : m_lines)
            cost += kLineCost * lengthInside(rect, line);
        return cost;
    }

private:
    QRectF m_area;
    std::vector<QRectF> m_solids;
    std::vector<LabelDisk> m_disks;
    std::vector<QLineF> m_lines;
};

struct Candidate
{
    QRectF rect;
    bool needsLeader = false;
    double cost = 0; ///< without other labels
};

/** Distance between a disk and a rectangle. */
double gapBetween(const QRectF& rect, const LabelDisk& disk)
{
    const QPointF near(std::clamp(disk.centre_px.x(), rect.left(), rect.right()),
                       std::clamp(disk.centre_px.y(), rect.top(), rect.bottom()));
    return std::max(0.0, QLineF(near, disk.centre_px).length() - disk.radius_px);
}

Candidate stayingCandidate(const LabelRequest& request, const Neighbourhood& near)
{
    const QRectF rect = stayingRect(request);
    const double faults = near.faults(rect);
    const bool isFree = faults == 0 && !request.previous->needsLeader;
    const double cost = faults + near.crossings(rect) +
                        kGapCost * gapBetween(rect, request.anchor) -
                        (isFree ? kFreeStayGain : kStayGain);
    return {.rect = rect, .needsLeader = request.previous->needsLeader, .cost = cost};
}

std::vector<Candidate> candidatesOf(const LabelRequest& request,
                                    const LabelSurroundings& surroundings)
{
    const Neighbourhood near(request, surroundings);
    std::vector<Candidate> candidates;
    if (request.previous)
        candidates.push_back(stayingCandidate(request, near));
    for (const double gap_px : kGaps_px) {
        double preference = 0;
        for (const double angle_deg : kAngles_deg) {
            Candidate c{.rect = candidate(request, angle_deg, gap_px),
                        .needsLeader = gap_px >= kLeaderGap_px};
            c.cost = near.faults(c.rect) + kGapCost * gap_px + preference;
            if (c.cost < kFault) // faulty places are not shown, so lines are irrelevant
                c.cost += near.crossings(c.rect);
            candidates.push_back(c);
            preference += kAngleCost;
        }
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    return candidates;
}

} // namespace

QRectF stayingRect(const LabelRequest& request)
{
    const QRectF before = request.previous->rect;
    QRectF rect(before.topLeft(), request.size_px);
    if (before.center().x() < request.anchor.centre_px.x())
        rect.moveRight(before.right());
    return rect;
}

bool overlaps(const QRectF& rect, const LabelDisk& disk)
{
    const double dx =
        disk.centre_px.x() - std::clamp(disk.centre_px.x(), rect.left(), rect.right());
    const double dy =
        disk.centre_px.y() - std::clamp(disk.centre_px.y(), rect.top(), rect.bottom());
    return dx * dx + dy * dy <= disk.radius_px * disk.radius_px;
}

double lengthInside(const QRectF& rect, const QLineF& line)
{
    const std::optional<LineShares> inside = sharesInside(line, rect);
    return inside ? (inside->to - inside->from) * line.length() : 0;
}

std::vector<PlacedLabel> placeLabels(std::span<const LabelRequest> requests,
                                     const LabelSurroundings& surroundings)
{
    std::vector<std::vector<Candidate>> candidates;
    for (const LabelRequest& request : requests)
        candidates.push_back(candidatesOf(request, surroundings));

    std::vector<PlacedLabel> placed(requests.size());
    std::vector<double> ownCost(requests.size(),
                                0); // cost of the chosen place without other labels
    std::vector<bool> done(requests.size(), false);
    // Cost of a place with other labels; the sum may stop once it exceeds `limit`.
    const auto costOf = [&](std::size_t self, const Candidate& c, double limit) {
        const QRectF padded = c.rect.adjusted(-kMargin_px, -kMargin_px, kMargin_px, kMargin_px);
        double cost = c.cost;
        for (std::size_t other = 0; other < requests.size() && cost < limit; ++other)
            if (other != self && done[other])
                cost += kFault * overlapArea(padded, placed[other].rect);
        return cost;
    };
    // The first sweep is greedy; later ones let each label move where the others left room.
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        bool moved = false;
        for (std::size_t i = 0; i < requests.size(); ++i) {
            double best = std::numeric_limits<double>::infinity();
            PlacedLabel label;
            for (const Candidate& c : candidates[i]) {
                if (c.cost >= best)
                    break; // candidates are sorted by cost
                const double cost = costOf(i, c, best);
                if (cost < best) {
                    best = cost;
                    label = {.rect = c.rect, .needsLeader = c.needsLeader};
                    ownCost[i] = c.cost;
                }
            }
            moved = moved || label.rect != placed[i].rect;
            placed[i] = label;
            done[i] = true;
        }
        if (!moved)
            break;
    }
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const auto before = placed.begin() + static_cast<std::ptrdiff_t>(i);
        const bool clash = std::any_of(placed.begin(), before, [&](const PlacedLabel& other) {
            return other.rect.intersects(placed[i].rect);
        });
        if (ownCost[i] >= kFault || clash)
            placed[i] = {};
    }
    return placed;
}

} // namespace berg
