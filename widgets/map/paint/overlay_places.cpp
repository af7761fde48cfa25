#include "widgets/map/paint/overlay_places.h"

#include "widgets/map/paint/wind_panel.h"

#include <algorithm>
#include <utility>

namespace berg {
namespace {

// Overlays larger than these shares of the map's width and height are left out.
constexpr double kWidestShare = 0.45;
constexpr double kTallestShare = 0.62;
constexpr double kLargestShare = 0.16; // share of the area
constexpr double kLargestCalmShare = 0.05;
constexpr double kTitleShare = 0.6; // share of the width for title and subtitle
constexpr double kFolded_px = 26;
constexpr double kPanelPart_px = 17;

bool fits(const QSizeF& size, const QRectF& rect)
{
    return !size.isEmpty() && size.width() <= kWidestShare * rect.width() &&
           size.height() <= kTallestShare * rect.height() &&
           size.width() * size.height() <= kLargestShare * rect.width() * rect.height();
}

template <class Layout>
auto& panelOf(Layout& layout, MapPanel which)
{
    switch (which) {
    case MapPanel::Legend:
        return layout.legend;
    case MapPanel::ScaleBar:
        return layout.scaleBar;
    case MapPanel::North:
        return layout.north;
    case MapPanel::Wind:
        return layout.wind;
    case MapPanel::Title:
        break;
    }
    return layout.title;
}

/** Area for overlays. */
QRectF innerOf(const MapLayout& layout, const MapStyle& style)
{
    return layout.rect.adjusted(kOverlayGap_px, style.cover_px + kOverlayGap_px, -kOverlayGap_px,
                                -kOverlayGap_px);
}

/** Applies the user's choices: hides a panel, folds it to an icon, or moves it inside the map. */
void rearrange(MapLayout& layout, const MapStyle& style)
{
    const QRectF inner = innerOf(layout, style);
    for (std::size_t i = 0; i < kMapPanels; ++i) {
        const MapPanelState& state = style.panels[i];
        QRectF& rect = panelOf(layout, static_cast<MapPanel>(i));
        layout.moved_px[i] = {};
        if (rect.isNull() || state == MapPanelState{})
            continue;
        QRectF wanted = rect;
        if (state.isFolded) {
            const bool isRight = rect.center().x() > inner.center().x();
            const bool isLow = rect.center().y() > inner.center().y();
            wanted.setSize({kFolded_px, kFolded_px});
            wanted.moveTo(isRight ? rect.right() - kFolded_px : rect.left(),
                          isLow ? rect.bottom() - kFolded_px : rect.top());
        }
        const QPointF own = wanted.topLeft();
        wanted.translate(state.moved_px);
        wanted.moveLeft(
            std::max(inner.left(), std::min(wanted.left(), inner.right() - wanted.width())));
        wanted.moveTop(
            std::max(inner.top(), std::min(wanted.top(), inner.bottom() - wanted.height())));
        layout.moved_px[i] = wanted.topLeft() - own;
        rect = state.isHidden || state.isFolded ? QRectF() : wanted;
        if (state.isFolded && !state.isHidden)
            layout.icons[i] = wanted;
    }
}

bool isClear(const MapLayout& layout, const QRectF& rect)
{
    constexpr double kAway_px = kOverlayGap_px - 1; // tolerates rounding of sums of the margin
    return std::ranges::none_of(layout.overlays(), [&rect](const QRectF& other) {
        return other.adjusted(-kAway_px, -kAway_px, kAway_px, kAway_px).intersects(rect);
    });
}

/** Places the wind panel beside the north arrow. */
void placeWind(MapLayout& layout, const MapPicture& picture, const MapStyle& style)
{
    const QSizeF size = windPanelSize(picture.air, style);
    if (layout.north.isNull() || !fits(size, layout.rect))
        return;
    const bool isCalm = picture.air.wind_mps.isZero(0) && picture.air.current_mps.isZero(0);
    if (isCalm && size.width() * size.height() >
                      kLargestCalmShare * layout.rect.width() * layout.rect.height())
        return;
    const QRectF rect(
        QPointF(layout.north.left() - kOverlayGap_px - size.width(), layout.north.top()), size);
    if (isClear(layout, rect))
        layout.wind = rect;
}

/** Free corner on the right, or place beside other panels; null if there is none. */
QRectF freePlace(const MapLayout& layout, const QRectF& inner, const QSizeF& size)
{
    const double right = inner.right() - size.width();
    const double bottom = inner.bottom() - size.height();
    const double belowNorth = std::max(layout.north.bottom(), inner.top()) + kOverlayGap_px;
    const double aboveBar = layout.scaleBar.top() - kOverlayGap_px - size.height();
    const double besideBar = layout.scaleBar.left() - kOverlayGap_px - size.width();
    const double besideTitle = layout.title.right() + kOverlayGap_px;
    for (const QPointF& corner : {QPointF(right, bottom), QPointF(right, aboveBar),
                                  QPointF(besideBar, bottom), QPointF(right, belowNorth),
                                  QPointF(besideTitle, bottom), QPointF(besideTitle, inner.top())})
        if (const QRectF rect(corner, size);
            inner.adjusted(-1, -1, 1, 1).contains(rect) && isClear(layout, rect))
            return rect;
    return {};
}

/** Opens the legend at the bottom, beside the title if there is room; hides panels it covers. */
void openLegend(MapLayout& layout, const QRectF& inner, const QSizeF& size)
{
    QRectF rect(QPointF(inner.left(), inner.bottom() - size.height()), size);
    const double besideTitle = layout.title.right() + kOverlayGap_px;
    if (rect.intersects(layout.title) && besideTitle + size.width() <= inner.right())
        rect.moveLeft(besideTitle);
    if (!inner.adjusted(-1, -1, 1, 1).contains(rect))
        return;
    for (QRectF* other :
         {&layout.title, &layout.scaleBar, &layout.north, &layout.wind, &layout.inset})
        if (other->intersects(rect))
            *other = {};
    layout.legend = rect;
}

/** Width limit of the title: leaves room for the panels at the top, but most of a narrow map. */
double widestTitle_px(const MapLayout& layout, const MapPicture& picture, const MapStyle& style)
{
    const double others_px = northArrowSize().width() + windPanelSize(picture.air, style).width();
    return std::max(kTitleShare * layout.rect.width(),
                    layout.rect.width() - others_px - 4 * kOverlayGap_px);
}

bool coversIceberg(const MapLayout& layout, const QRectF& panel)
{
    constexpr double kSeen_px = 10; // visible radius required
    return std::ranges::any_of(layout.icebergs, [&](const LabelDisk& iceberg) {
        return overlaps(layout.rect, iceberg) &&
               overlaps(panel, {.centre_px = iceberg.centre_px, .radius_px = kSeen_px});
    });
}

/** Shrinks a panel towards the sides of the map that it is near. */
QRectF shrunk(const QRectF& panel, const QSizeF& size, const QRectF& map)
{
    QRectF rect(panel.topLeft(), size);
    if (panel.center().x() > map.center().x())
        rect.moveRight(panel.right());
    if (panel.center().y() > map.center().y())
        rect.moveBottom(panel.bottom());
    return rect;
}

void uncoverByTitle(MapLayout& layout, const MapPicture& picture, const MapStyle& style)
{
    if (layout.title.isNull() || picture.readouts.empty() || !coversIceberg(layout, layout.title))
        return;
    const QSizeF size = titleSize(
        picture, style, {.widest_px = widestTitle_px(layout, picture, style), .isCompact = true});
    const QRectF compact = shrunk(layout.title, size, layout.rect);
    if (coversIceberg(layout, compact))
        return;
    layout.title = compact;
    layout.isTitleCompact = true;
}

void uncoverByLegend(MapLayout& layout, const MapPicture& picture, const MapStyle& style)
{
    constexpr auto kLegend = static_cast<std::size_t>(MapPanel::Legend);
    const MapPanelState& state = style.panels[kLegend];
    if (layout.legend.isNull() || state.isOpened || !coversIceberg(layout, layout.legend))
        return;
    const QSizeF size = legendSize(picture, style, layout.symbols, true);
    QRectF compact = shrunk(layout.legend, size, layout.rect);
    const QRectF covered = std::exchange(layout.legend, {});
    if (coversIceberg(layout, compact) && !style.isLive)
        compact = freePlace(layout, innerOf(layout, style), size);
    if (!compact.isNull() && !coversIceberg(layout, compact)) {
        layout.legend = compact;
        layout.isLegendCompact = true;
    } else if (style.isLive) {
        layout.icons[kLegend] = shrunk(covered, {kFolded_px, kFolded_px}, layout.rect);
    } else {
        layout.legend = covered;
    }
}

} // namespace

void uncoverIcebergs(MapLayout& layout, const MapPicture& picture, const MapStyle& style)
{
    layout.isTitleCompact = false;
    if (layout.density.isCrowded)
        return;
    uncoverByTitle(layout, picture, style);
    uncoverByLegend(layout, picture, style);
}

void placeOverlays(MapLayout& layout, const MapPicture& picture, const MapStyle& style)
{
    layout.title = layout.legend = layout.scaleBar = layout.north = layout.wind = layout.inset = {};
    layout.icons = {};
    const QRectF inner = innerOf(layout, style);
    const QSizeF title = titleSize(picture, style,
                                   {.widest_px = widestTitle_px(layout, picture, style),
                                    .widestText_px = kTitleShare * layout.rect.width()});
    if (!title.isEmpty() && title.width() >= 120 && title.height() <= 0.4 * layout.rect.height())
        layout.title = QRectF(inner.topLeft(), title);
    layout.isLegendCompact = layout.rect.height() < kLowMap_px;
    QSizeF legend = legendSize(picture, style, layout.symbols, layout.isLegendCompact);
    if (style.isLive && !layout.isLegendCompact && !fits(legend, layout.rect)) {
        layout.isLegendCompact = true; // it grows in flight: better compact than hidden
        legend = legendSize(picture, style, layout.symbols, true);
        layout.leastLegend_px = {};
    }
    if (!legend.isEmpty())
        legend = legend.expandedTo(layout.leastLegend_px);
    const QRectF usual(QPointF(inner.left(), inner.bottom() - legend.height()), legend);
    if (fits(legend, layout.rect) && isClear(layout, usual))
        layout.legend = usual;
    const QSizeF bar = scaleBarSize(layout.view, style);
    if (fits(bar, layout.rect))
        layout.scaleBar = QRectF(inner.bottomRight() - QPointF(bar.width(), bar.height()), bar);
    const QSizeF north = northArrowSize();
    if (fits(north, layout.rect))
        layout.north = QRectF(inner.topRight() - QPointF(north.width(), 0), north);
    placeWind(layout, picture, style);
    const double ceiling = std::max(layout.north.bottom(), layout.wind.bottom());
    const QRectF inset(QPointF(inner.right() - style.inset_px.width(), ceiling + kOverlayGap_px),
                       style.inset_px);
    const double floor = layout.scaleBar.isNull() ? inner.bottom() : layout.scaleBar.top();
    if (fits(style.inset_px, layout.rect) && inset.bottom() + kOverlayGap_px <= floor)
        layout.inset = inset;
    if (layout.legend.isNull() && fits(legend, layout.rect))
        layout.legend = freePlace(layout, inner, legend);
    constexpr auto kLegend = static_cast<std::size_t>(MapPanel::Legend);
    if (layout.legend.isNull() && !legend.isEmpty() && style.panels[kLegend].isOpened)
        openLegend(layout, inner, legend);
    rearrange(layout, style);
    const QRectF icon(inner.left(), inner.bottom() - kFolded_px, kFolded_px, kFolded_px);
    if (style.isLive && !legend.isEmpty() && layout.legend.isNull() &&
        !style.panels[kLegend].isHidden && layout.icons[kLegend].isNull() && isClear(layout, icon))
        layout.icons[kLegend] = icon; // the menu says it is shown, but there is no room
}

std::vector<QRectF> MapLayout::overlays() const
{
    std::vector<QRectF> shown;
    for (const QRectF& overlay : {title, legend, scaleBar, north, wind, inset})
        if (!overlay.isNull())
            shown.push_back(overlay);
    for (const QRectF& icon : icons)
        if (!icon.isNull())
            shown.push_back(icon);
    return shown;
}

const QRectF& MapLayout::panel(MapPanel which) const
{
    return panelOf(*this, which);
}

QRectF foldButtonOf(const QRectF& panel)
{
    return {panel.right() - kPanelPart_px - 3, panel.top() + 3, kPanelPart_px, kPanelPart_px};
}

QRectF panelGripOf(const QRectF& panel)
{
    return foldButtonOf(panel).translated(-kPanelPart_px - 2, 0);
}

} // namespace berg
