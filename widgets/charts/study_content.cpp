#include "widgets/charts/study_content.h"

#include "widgets/charts/figure_painter.h"
#include "widgets/words/policy_words.h"

#include <QPainter>

#include <algorithm>

namespace berg {
namespace {

ZetaPoint pointOf(const StudySummary& summary, std::size_t setting, const QLocale& locale)
{
    const SettingSummary& of = summary.settings[setting];
    return {.setting = setting,
            .of = of.setting,
            .name = settingText(of.setting, locale),
            .zeta_m2s = of.zeta_m2s};
}

DifferenceRow rowOf(const StudySummary& summary, std::size_t setting, const QLocale& locale)
{
    const PairedDifference& of = summary.differences[setting];
    return {.setting = setting,
            .of = of.setting,
            .name = settingText(of.setting, locale),
            .relative = of.relative,
            .isReference = setting == summary.reference};
}

/** Thins `all` evenly to at most `most` rows; rows accepted by `isNeeded` always remain. */
template <class IsNeeded>
std::vector<DifferenceRow> thinned(const std::vector<DifferenceRow>& all, std::size_t most,
                                   const IsNeeded& isNeeded)
{
    const auto always = static_cast<std::size_t>(std::count_if(all.begin(), all.end(), isNeeded));
    std::size_t step = 1;
    while ((all.size() + step - 1) / step + always > std::max(most, always + 1) &&
           step < all.size())
        ++step;
    std::vector<DifferenceRow> out;
    for (std::size_t k = 0; k < all.size(); ++k)
        if (k % step == 0 || isNeeded(all[k]))
            out.push_back(all[k]);
    return out;
}

} // namespace

QPixmap policyMark(PolicyKind policy, const Theme& theme, int size_px)
{
    constexpr int kScale = 2; // device pixels
    QPixmap pixmap(kScale * size_px, kScale * size_px);
    pixmap.setDevicePixelRatio(kScale);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    paintMark(painter, {size_px / 2.0, size_px / 2.0}, policyMark(policy, {}, size_px / 3.0),
              theme);
    return pixmap;
}

ZetaContent zetaContent(const StudySummary& summary, const QLocale& locale)
{
    ZetaContent content;
    if (summary.cases.empty())
        return content;
    for (std::size_t s = 0; s < summary.settings.size(); ++s) {
        const SettingSummary& of = summary.settings[s];
        (of.setting.tau ? content.curve : content.policies).push_back(pointOf(summary, s, locale));
        const auto isLowerThan = [&](std::size_t other) {
            return of.zeta_m2s.mean < summary.settings[other].zeta_m2s.mean;
        };
        if (isLowerThan(content.lowest))
            content.lowest = s;
        if (of.setting.tau && (!content.lowestTau || isLowerThan(*content.lowestTau)))
            content.lowestTau = s;
    }
    std::stable_sort(content.curve.begin(), content.curve.end(),
                     [](const ZetaPoint& a, const ZetaPoint& b) { return *a.of.tau < *b.of.tau; });
    std::stable_sort(
        content.policies.begin(), content.policies.end(),
        [](const ZetaPoint& a, const ZetaPoint& b) { return a.zeta_m2s.mean < b.zeta_m2s.mean; });
    if (summary.bestTau &&
        summary.cases.size() > 1) // for a single case it is the lowest point of the curve
        content.bestTau_m2s = summary.bestTau->zeta_m2s.mean;
    return content;
}

std::vector<DifferenceRow> differenceRows(const StudySummary& summary, std::size_t most,
                                          const QLocale& locale)
{
    std::vector<DifferenceRow> rows;
    std::vector<DifferenceRow> taus;
    if (summary.cases.empty())
        return rows;
    for (std::size_t s = 0; s < summary.differences.size(); ++s)
        (summary.differences[s].setting.tau ? taus : rows).push_back(rowOf(summary, s, locale));
    const auto isLower = [](const DifferenceRow& a, const DifferenceRow& b) {
        return a.relative.mean < b.relative.mean;
    };
    std::stable_sort(rows.begin(), rows.end(), isLower);
    std::stable_sort(taus.begin(), taus.end(), [](const DifferenceRow& a, const DifferenceRow& b) {
        return *a.of.tau < *b.of.tau;
    });
    if (taus.empty())
        return rows;
    const std::size_t lowest = std::min_element(taus.begin(), taus.end(), isLower)->setting;
    const std::vector<DifferenceRow> shown =
        thinned(taus, most > rows.size() ? most - rows.size() : 0,
                [lowest](const auto& row) { return row.isReference || row.setting == lowest; });
    rows.insert(rows.end(), shown.begin(), shown.end());
    return rows;
}

} // namespace berg
