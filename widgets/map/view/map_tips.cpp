#include "widgets/map/view/map_tips.h"

#include "widgets/flight/asset_approach.h"
#include "widgets/map/paint/wind_panel.h"
#include "widgets/map/picture/ice_picture.h"
#include "widgets/map/picture/scenario_picture.h"
#include "widgets/map/view/map_scene.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>

namespace berg {
namespace {

struct MapTipText
{
    Q_DECLARE_TR_FUNCTIONS(MapTipText)
};

QString icebergTip(const MapIceberg& iceberg, const TimesAhead& times, const QLocale& locale)
{
    const double speed_mps = iceberg.velocity_mps.norm();
    const QString drift =
        speed_mps > 0 ? MapTipText::tr("drifting %1 towards %2")
                            .arg(speedText(speed_mps, locale), bearingText(iceberg.velocity_mps))
                      : MapTipText::tr("not drifting");
    QString text = MapTipText::tr("%1: %2, %3", "name, uncertainty, drift")
                       .arg(iceberg.id, uncertaintyText(iceberg.sigma_m2, locale), drift);
    if (iceberg.ringEntry_s)
        text += u'\n' + ringEntryText(iceberg.id, *iceberg.ringEntry_s, locale, times);
    return text;
}

QString iceTip(const MapIceChart& chart, const Point& place_m, const QLocale& locale)
{
    const IceArea* const area = iceAreaAt(chart, place_m);
    if (area == nullptr)
        return {};
    QString text = area->concentration_tenths
                       ? MapTipText::tr("Ice concentration %1 tenths")
                             .arg(locale.toString(*area->concentration_tenths, 'g', 3))
                       : MapTipText::tr("Ice concentration unknown");
    if (area->isFast)
        text += MapTipText::tr(", fast ice");
    if (!area->label.empty())
        text += MapTipText::tr("\nOn the chart: %1").arg(QString::fromStdString(area->label));
    return text + u'\n' + QString::fromStdString(chart.chart.source);
}

} // namespace

QString mapToolTip(MapScene& scene, const QPointF& at)
{
    const MapPicture& picture = scene.picture();
    if (scene.layout().wind.contains(at))
        return windToolTip(picture.air, scene.locale());
    const TimesAhead& times = picture.times;
    if (times.clock.start && scene.layout().title.contains(at))
        return times.clock.details(times.now_s);
    const auto iceberg = std::ranges::find(picture.icebergs, scene.objectAt(at), keyOf);
    if (iceberg != picture.icebergs.end())
        return icebergTip(*iceberg, times, scene.locale());
    return picture.iceChart != nullptr && scene.layers().shows(MapLayer::IceChart)
               ? iceTip(*picture.iceChart, scene.layout().view.toWorld(at), scene.locale())
               : QString();
}

} // namespace berg
