#include "widgets/print/flight_brief.h"

#include "widgets/map/paint/map_painter.h"
#include "widgets/map/picture/route_colours.h"
#include "widgets/map/picture/scenario_picture.h"
#include "widgets/print/brief_layout.h"
#include "widgets/print/export_picture.h"
#include "widgets/print/operation_page.h"
#include "widgets/theme/painter_state.h"

#include <memory>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

// Paper sizes at 96 per inch.
constexpr QSize kA4_px{794, 1123};
constexpr QSize kLetter_px{816, 1056};

// Scales of the map, because its fonts and symbols are made for the screen.
constexpr double kMapScale = 0.78;
constexpr double kDenseMapScale = 0.67; // ids get the smallest permitted size
constexpr std::size_t kDense = 24;      // number of icebergs from which the map is dense

constexpr qsizetype kLongestLabel = 28;

constexpr int kTextFlags = Qt::TextSingleLine | Qt::TextDontClip;
constexpr QColor kMuted(0x4a, 0x4a, 0x4a);
constexpr QColor kFaint(0xc8, 0xc8, 0xc8);

/** Data that the page is painted from. */
struct Brief
{
    Theme theme = Theme::light();
    QLocale locale;
    MapPicture picture;
    BriefLayout layout;
    MapLayout map; ///< in map pixels, which are smaller than those of the page
    double mapScale = kMapScale;

    [[nodiscard]] MapStyle style() const { return {.theme = theme, .locale = locale}; }
};

QString labelOf(const QString& name)
{
    return name.size() <= kLongestLabel ? name : name.left(kLongestLabel - 1) + u'…';
}

/** Map of the export with wind, and names short enough for labels. */
MapPicture printedPicture(const ExportContent& content)
{
    MapPicture picture = exportPicture(content);
    for (MapIceberg& iceberg : picture.icebergs)
        iceberg.id = labelOf(iceberg.id);
    for (MapUav& uav : picture.uavs)
        uav.label = labelOf(uav.label);
    if (picture.asset)
        picture.asset->name = labelOf(picture.asset->name);
    picture.air = exportAir(content);
    return picture;
}

void paintMapOf(QPainter& painter, const Brief& brief)
{
    const PainterState saved(painter);
    const QRectF& rect = brief.layout.map;
    painter.setClipRect(rect);
    painter.translate(rect.topLeft());
    painter.scale(brief.mapScale, brief.mapScale);
    paintMap(painter, brief.picture, brief.style(), brief.map);
}

void paintRules(QPainter& painter, const BriefLayout& layout)
{
    for (const BriefRule& rule : layout.rules) {
        painter.setPen(rule.isStrong ? QPen(Qt::black, 1) : QPen(kFaint, 0.6));
        painter.drawLine(rule.line);
    }
}

void paintLines(QPainter& painter, const Brief& brief)
{
    paintRules(painter, brief.layout);
    painter.setPen(QPen(Qt::black, 0.8));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(brief.layout.map);
    for (const BriefSign& sign : brief.layout.signs) {
        painter.setBrush(routeColours(brief.picture, brief.theme, sign.uav).plan);
        painter.drawRect(sign.rect);
    }
}

void paintTexts(QPainter& painter, const BriefLayout& layout)
{
    painter.setLayoutDirection(Qt::LeftToRight);
    for (const BriefText& text : layout.texts) {
        painter.setFont(briefFont(text.type));
        painter.setPen(text.type.isMuted ? kMuted : QColor(Qt::black));
        const Qt::Alignment side = text.type.isRight ? Qt::AlignRight : Qt::AlignLeft;
        painter.drawText(text.rect, static_cast<int>(side | Qt::AlignVCenter) | kTextFlags,
                         text.text);
    }
}

} // namespace

QSize briefPage_px(const QLocale& locale)
{
    return locale.measurementSystem() == QLocale::ImperialUSSystem ? kLetter_px : kA4_px;
}

void paintLayout(QPainter& painter, const BriefLayout& layout)
{
    const PainterState saved(painter);
    paintRules(painter, layout);
    paintTexts(painter, layout);
}

PicturePage flightBrief(const ExportContent& content, const QLocale& locale)
{
    const QSize size_px = briefPage_px(locale);
    const BriefContent words = briefContent(content, locale);
    auto brief = std::make_shared<Brief>();
    brief->locale = locale;
    brief->picture = printedPicture(content);
    brief->layout = layOutBrief(words, QSizeF(size_px));
    brief->mapScale = brief->picture.icebergs.size() > kDense ? kDenseMapScale : kMapScale;
    brief->map = arrangeMap(brief->picture, brief->style(),
                            QRectF(QPointF(0, 0), brief->layout.map.size() / brief->mapScale));
    std::vector<std::function<void(QPainter&)>> more;
    if (content.operation)
        more.emplace_back([page = std::make_shared<const BriefLayout>(layOutOperation(
                               operationContent(content, locale), QSizeF(size_px)))](
                              QPainter& painter) { paintLayout(painter, *page); });
    return {.size_px = size_px,
            .title = FlightBrief::tr("Flight brief: %1").arg(words.title),
            .description = words.about,
            .paint =
                [shared = std::shared_ptr<const Brief>(std::move(brief))](QPainter& painter) {
                    const PainterState saved(painter);
                    paintMapOf(painter, *shared);
                    paintLines(painter, *shared);
                    paintTexts(painter, shared->layout);
                },
            .more = std::move(more)};
}

} // namespace berg
