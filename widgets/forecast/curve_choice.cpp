#include "widgets/forecast/curve_choice.h"

#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace berg {
namespace {

/** Translation context. */
struct CurveText
{
    Q_DECLARE_TR_FUNCTIONS(CurveText)
};

constexpr int kMostDecimals = 6;

std::optional<double> tauAt(const TauCurve& curve, int interval)
{
    if (interval < 0 || interval >= static_cast<int>(curve.intervals.size()))
        return std::nullopt;
    return shortTau(curve.intervals[static_cast<std::size_t>(interval)]);
}

/** Returns "0.83 to 1.21" with as many digits as distinguish both ends. */
QString tauRangeText(const CurveInterval& interval, const QLocale& locale)
{
    const double width = interval.tauTo - interval.tauFrom;
    const int decimals =
        std::clamp(1 - static_cast<int>(std::floor(std::log10(width))), 2, kMostDecimals);
    return CurveText::tr("%1 to %2")
        .arg(fixedText(interval.tauFrom, decimals, locale),
             fixedText(interval.tauTo, decimals, locale));
}

} // namespace

std::optional<int> presentInterval(const TauCurve& curve, double tau)
{
    if (curve.intervals.empty() || !(tau >= 0 && tau <= curve.intervals.back().tauTo))
        return std::nullopt;
    return intervalAt(curve, tau);
}

double shortTau(const CurveInterval& interval)
{
    const double middle = (interval.tauFrom + interval.tauTo) / 2;
    for (double scale = 10; scale < 1e12; scale *= 10) {
        const double candidate = std::round(middle * scale) / scale;
        if (candidate > interval.tauFrom && candidate < interval.tauTo)
            return candidate;
    }
    return middle;
}

std::optional<double> tauOfNextPlan(const TauCurve& curve, double tau)
{
    const std::optional<int> present = presentInterval(curve, tau);
    return present ? tauAt(curve, *present + 1) : std::nullopt;
}

std::optional<double> tauOfPreviousPlan(const TauCurve& curve, double tau)
{
    const int present =
        presentInterval(curve, tau).value_or(static_cast<int>(curve.intervals.size()));
    return tauAt(curve, present - 1);
}

QString intervalText(const CurveInterval& interval, const QLocale& locale)
{
    const QString text = interval.proven ? CurveText::tr("τ %1: whole order %2, proven optimal")
                                         : CurveText::tr("τ %1: whole order %2, not proven");
    return text.arg(tauRangeText(interval, locale), distanceText(interval.distance_m, locale));
}

} // namespace berg
