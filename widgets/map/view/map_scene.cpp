#include "widgets/map/view/map_scene.h"

#include "widgets/document/selection.h"
#include "widgets/map/paint/map_marks.h"
#include "widgets/map/picture/scenario_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <unordered_set>
#include <utility>

namespace berg {
namespace {

constexpr double kUavReach_px = 17; // a little more than half the UAV's symbol
constexpr double kAssetReach_px = 14;
constexpr double kOutlineReach_px = 5;
constexpr double kSmallestReach_px = 13; // smallest hit radius of a symbol
constexpr double kReachMargin_px = 2;
constexpr double kUnderName_px = 1e6; // symbols have priority over names

/** Number of labels that can be placed anew in every frame, in a few milliseconds. */
constexpr std::size_t kLabelsPerFrame = 60;

/** Limit of labels times icebergs in sight for an occasional longer frame. */
constexpr std::size_t kLabelPairs = 10000;

bool isOnOutline(const QPolygonF& outline, const QPointF& at)
{
    for (qsizetype i = 0; i < outline.size(); ++i) {
        const QPointF from = outline[i];
        const QPointF edge = outline[(i + 1) % outline.size()] - from;
        const double length2 = QPointF::dotProduct(edge, edge);
        const double share =
            length2 > 0 ? std::clamp(QPointF::dotProduct(at - from, edge) / length2, 0.0, 1.0) : 0;
        if (QLineF(at, from + edge * share).length() <= kOutlineReach_px)
            return true;
    }
    return false;
}

} // namespace

MapScene::MapScene() : m_theme(Theme::light()), m_land(std::make_unique<LandLayer>())
{
    QObject::connect(m_land.get(), &LandLayer::updated, m_land.get(),
                     [this] { m_isGroundOld = true; });
}

void MapScene::setPicture(MapPicture picture)
{
    if (!(picture.origin == m_picture.origin)) {
        m_graticule.reset();
        m_isGroundOld = true;
    }
    picture.live = std::move(m_picture.live);
    m_picture = std::move(picture);
    m_layout.reset();
}

void MapScene::setTheme(const Theme& theme)
{
    m_theme = theme;
    m_sprites.clear();
    m_isGroundOld = true;
    m_layout.reset();
}

void MapScene::setLocale(const QLocale& locale)
{
    m_locale = locale;
    m_sprites.clear();
    m_layout.reset();
}

void MapScene::setRect(const QRectF& rect)
{
    m_rect = rect;
    m_graticule.reset();
    m_isGroundOld = true;
    m_layout.reset();
}

void MapScene::setView(const MapViewTransform& view)
{
    m_view = view;
    m_graticule.reset();
    m_isGroundOld = true;
    m_layout.reset();
}

void MapScene::fit()
{
    m_continuity = {};
    m_pendingLabels = m_picture.icebergs.size();
    const MapLayout fitted = arrangeMap(m_picture, style(), m_rect, std::nullopt,
                                        {.turn = LabelTurn{}}); // no labels are placed
    m_continuity.crowding = fitted.density.crowding();
    setView(fitted.view);
}

void MapScene::setInset(const QSizeF& inset_px)
{
    m_inset_px = inset_px;
    m_layout.reset();
}

void MapScene::setDriftTime(std::optional<double> driftTime_s)
{
    m_driftTime_s = driftTime_s;
    m_layout.reset();
}

void MapScene::beginPreview()
{
    if (!m_beforePreview) // else another preview follows the first one
        m_beforePreview = m_continuity;
}

void MapScene::endPreview()
{
    if (m_beforePreview)
        m_continuity = *std::exchange(m_beforePreview, std::nullopt);
    m_layout.reset();
}

const MapLayout& MapScene::layout()
{
    if (m_layout)
        return *m_layout;
    const auto inSight = std::count_if(
        m_picture.icebergs.begin(), m_picture.icebergs.end(), [&](const MapIceberg& iceberg) {
            return m_rect.contains(m_view.toPixel(iceberg.position_m));
        });
    m_continuity.driftTime_s = m_driftTime_s;
    m_continuity.turn = nextTurn(static_cast<std::size_t>(inSight));
    m_layout = arrangeMap(m_picture, style(), m_rect, m_view, m_continuity);
    m_continuity = continuityOf(m_picture, *m_layout);
    return *m_layout;
}

/** Labels that may move in this frame; if there are many, a part of them in turn. */
std::optional<LabelTurn> MapScene::nextTurn(std::size_t inSight)
{
    const std::size_t count = m_picture.icebergs.size();
    const bool hasTime = std::exchange(m_hasTime, false);
    if (inSight <= kLabelsPerFrame ||
        m_continuity.crowding.isDense) { // a dense field has few labels
        m_pendingLabels = 0;
        return std::nullopt;
    }
    if (!hasTime) {
        m_pendingLabels = count;
        return LabelTurn{};
    }
    if (m_turnFrom >= count)
        m_turnFrom = 0;
    const std::size_t part = std::max<std::size_t>(1, kLabelPairs / inSight);
    const LabelTurn turn{.first = m_turnFrom, .count = std::min(part, count - m_turnFrom)};
    m_turnFrom += turn.count;
    m_pendingLabels -= std::min(m_pendingLabels, turn.count);
    return turn;
}

void MapScene::settle()
{
    m_hasTime = true;
    m_layout.reset();
}

std::string MapScene::objectAt(const QPointF& at)
{
    const std::vector<std::string> objects = objectsAt(at);
    return objects.empty() ? std::string() : objects.front();
}

std::vector<std::string> MapScene::objectsAt(const QPointF& at)
{
    const MapLayout& map = layout();
    if (panelPartAt(at) || map.inset.contains(at))
        return {};
    std::vector<std::pair<double, std::string>> found;
    const auto offer = [&](const std::string& key, double distance_px) {
        found.emplace_back(distance_px, key);
    };
    for (std::size_t i = 0; i < m_picture.uavs.size(); ++i) {
        const MapUav& uav = m_picture.uavs[i];
        const QLineF path(at, map.view.toPixel(uav.position_m));
        if (!uav.key)
            continue;
        if (path.length() <= kUavReach_px)
            offer(*uav.key, path.length());
        else if (map.uavLabels[i].contains(at))
            offer(*uav.key, kUnderName_px);
    }
    if (m_picture.asset) {
        const QLineF path(at, map.view.toPixel(m_picture.asset->position_m));
        if (path.length() <= kAssetReach_px)
            offer(kAssetKey, path.length());
    }
    for (std::size_t i = 0; i < m_picture.icebergs.size(); ++i) {
        const LabelDisk& disk = map.icebergs[i];
        const QLineF path(at, disk.centre_px);
        const double reach_px = std::max(disk.radius_px + kReachMargin_px, kSmallestReach_px);
        if (path.length() <= reach_px)
            offer(keyOf(m_picture.icebergs[i]), path.length());
        else if (found.empty() && map.labels[i].rect.contains(at))
            offer(keyOf(m_picture.icebergs[i]), kUnderName_px);
    }
    std::ranges::stable_sort(found, {}, &std::pair<double, std::string>::first);
    std::vector<std::string> keys;
    for (auto& [distance_px, key] : found)
        keys.push_back(std::move(key));
    if (std::optional<std::string> outline = outlineAt(at))
        keys.push_back(*std::move(outline));
    return keys;
}

QPolygonF MapScene::outlineOf(const std::string& key) const
{
    const std::optional<std::size_t> place = noFlyPlace(key);
    if (key != kAreaKey && !(place && *place < m_picture.closed.size()))
        return {};
    return m_view.toPixels(place ? m_picture.closed[*place].corners_m : m_picture.area_m);
}

std::optional<std::string> MapScene::outlineAt(const QPointF& at) const
{
    for (std::size_t i = 0; i < m_picture.closed.size(); ++i)
        if (!m_picture.closed[i].isRing && isOnOutline(outlineOf(noFlyKey(i)), at))
            return noFlyKey(i);
    if (isOnOutline(outlineOf(kAreaKey), at))
        return kAreaKey;
    return std::nullopt;
}

std::vector<std::string> MapScene::objectsIn(const QRectF& rect)
{
    const MapLayout& map = layout();
    std::vector<std::string> keys;
    for (std::size_t i = 0; i < m_picture.icebergs.size(); ++i)
        if (rect.contains(map.icebergs[i].centre_px))
            keys.push_back(keyOf(m_picture.icebergs[i]));
    for (const MapUav& uav : m_picture.uavs)
        if (uav.key && rect.contains(map.view.toPixel(uav.position_m)))
            keys.push_back(*uav.key);
    if (m_picture.asset && rect.contains(map.view.toPixel(m_picture.asset->position_m)))
        keys.emplace_back(kAssetKey);
    return keys;
}

/** Symbol of a UAV or the asset. */
std::optional<LabelDisk> MapScene::singleSymbolOf(const std::string& key)
{
    const MapLayout& map = layout();
    for (const MapUav& uav : m_picture.uavs)
        if (uav.key == key)
            return LabelDisk{.centre_px = map.view.toPixel(uav.position_m),
                             .radius_px = kUavReach_px};
    if (key == kAssetKey && m_picture.asset)
        return LabelDisk{.centre_px = map.view.toPixel(m_picture.asset->position_m),
                         .radius_px = kAssetReach_px};
    return std::nullopt;
}

std::optional<LabelDisk> MapScene::symbolOf(const std::string& key)
{
    const std::vector<LabelDisk> symbols = symbolsOf({key});
    return symbols.empty() ? std::nullopt : std::optional(symbols.front());
}

/** Symbols of the objects, in no particular order. */
std::vector<LabelDisk> MapScene::symbolsOf(const std::vector<std::string>& keys)
{
    std::vector<LabelDisk> symbols;
    for (const std::string& key : keys)
        if (const std::optional<LabelDisk> symbol = singleSymbolOf(key))
            symbols.push_back(*symbol);
    const MapLayout& map = layout();
    const std::unordered_set<std::string_view> wanted(keys.begin(), keys.end());
    for (std::size_t i = 0; i < m_picture.icebergs.size(); ++i)
        if (wanted.contains(keyOf(m_picture.icebergs[i])))
            symbols.push_back(map.icebergs[i]);
    return symbols;
}

void MapScene::paintSelection(QPainter& painter, const std::vector<std::string>& keys)
{
    constexpr double kSteps = 4; // sizes of cached marks per pixel
    constexpr double kBeside_px = 10;
    for (const LabelDisk& symbol : symbolsOf(keys)) {
        const double radius_px = std::round(symbol.radius_px * kSteps) / kSteps;
        const double reach_px = radius_px + kBeside_px;
        m_sprites.paint(painter, QLatin1String("selected ") + QString::number(radius_px),
                        QRectF(-reach_px, -reach_px, 2 * reach_px, 2 * reach_px), symbol.centre_px,
                        [&](QPainter& own) {
                            paintSelectionMark(own, {.centre_px = {}, .radius_px = radius_px},
                                               m_theme);
                        });
    }
}

bool MapScene::isOverlay(const QPointF& at)
{
    const std::vector<QRectF> overlays = layout().overlays();
    return std::any_of(overlays.begin(), overlays.end(),
                       [&](const QRectF& overlay) { return overlay.contains(at); }) &&
           objectAt(at).empty();
}

std::optional<MapPanelPart> MapScene::panelPartAt(const QPointF& at)
{
    const MapLayout& map = layout();
    for (const MapPanel which : kFoldingPanels) {
        const QRectF& panel = map.panel(which);
        if (map.icons[static_cast<std::size_t>(which)].contains(at))
            return MapPanelPart{.panel = which};
        if (!panel.isNull() && foldButtonOf(panel).contains(at))
            return MapPanelPart{.panel = which};
        if (!panel.isNull() && panelGripOf(panel).contains(at))
            return MapPanelPart{.panel = which, .isGrip = true};
    }
    return std::nullopt;
}

std::optional<MapPanel> MapScene::panelAt(const QPointF& at)
{
    const MapLayout& map = layout();
    for (std::size_t i = kMapPanels; i-- > 0;) // the last panel is on top
        if (const auto which = static_cast<MapPanel>(i);
            map.icons[i].contains(at) || map.panel(which).contains(at))
            return which;
    return std::nullopt;
}

void MapScene::setCover(double cover_px)
{
    m_cover_px = cover_px;
    m_layout.reset();
}

void MapScene::setPanels(const MapPanelStates& panels)
{
    m_panels = panels;
    m_layout.reset();
}

void MapScene::setLayers(const MapLayers& layers)
{
    m_layers = layers;
    m_isGroundOld = true;
    m_layout.reset();
}

QPointF MapScene::panelOffset_px(MapPanel panel)
{
    return layout().moved_px[static_cast<std::size_t>(panel)];
}

void MapScene::movePanel(MapPanel panel, const QPointF& offset_px)
{
    QPointF& moved_px = m_panels[static_cast<std::size_t>(panel)].moved_px;
    moved_px = offset_px;
    m_layout.reset();
    moved_px = panelOffset_px(panel); // the layout limits it to the map
}

bool MapScene::setPointer(const std::optional<QPointF>& at)
{
    const std::vector<QRectF> overlays = layout().overlays();
    const auto below = [&](const std::optional<QPointF>& pointer) {
        return std::ranges::find_if(
            overlays, [&](const QRectF& overlay) { return pointer && overlay.contains(*pointer); });
    };
    const bool isOther = below(at) != below(m_pointer);
    m_pointer = at;
    return isOther;
}

void MapScene::paintGround(QPainter& painter, const MapFrame& frame)
{
    const double ratio = painter.device()->devicePixelRatioF();
    const QSizeF exact = m_rect.size() * ratio;
    const QSize size(static_cast<int>(std::ceil(exact.width())),
                     static_cast<int>(std::ceil(exact.height())));
    if (m_ground.size() != size || m_ground.devicePixelRatioF() != ratio) {
        m_ground = QPixmap(size);
        m_ground.setDevicePixelRatio(ratio);
        m_ground.fill(m_theme.sea); // an opaque pixmap is copied without blending
        m_isGroundOld = true;
    }
    if (std::exchange(m_isGroundOld, false)) {
        QPainter own(&m_ground);
        own.translate(-m_rect.topLeft());
        paintMapGround(own, frame);
    }
    painter.drawPixmap(m_rect.topLeft(), m_ground);
}

void MapScene::paint(QPainter& painter, const std::function<void()>& marks)
{
    const MapLayout& map = layout();
    if (!m_graticule)
        m_graticule = graticuleOf(LocalFrame(m_picture.origin), m_view, m_rect);
    const MapStyle mapStyle = style();
    const MapFrame frame{.picture = m_picture,
                         .style = mapStyle,
                         .layout = map,
                         .graticule = *m_graticule,
                         .sprites = &m_sprites,
                         .land = m_land.get(),
                         .swept = &m_swept,
                         .pointer = m_pointer};
    paintGround(painter, frame);
    paintMapContent(painter, frame);
    marks();
    paintMapLabels(painter, frame);
    paintMapOverlays(painter, frame);
}

} // namespace berg
