#include "widgets/map/view/map_view.h"

#include "widgets/document/scenario_edits.h"
#include "widgets/map/paint/map_marks.h"
#include "widgets/map/picture/scenario_picture.h"
#include "widgets/theme/accessible_roles.h"

#include <QEvent>
#include <QPainter>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kSettle_ms = 50;

} // namespace

MapView::MapView(ScenarioDocument& document, Selection& selection, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_selection(selection)
    , m_camera(m_scene, m_selection)
    , m_panels(m_scene, m_camera, *this)
    , m_edits({m_document, m_selection, m_scene, *this})
    , m_tools({m_document, m_selection, m_scene, *this})
{
    setObjectName(u"mapView"_s);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    grabGesture(Qt::PinchGesture);
    m_scene.setLocale(locale());
    m_settleTimer.setSingleShot(true);
    m_settleTimer.setInterval(kSettle_ms);
    connect(&m_settleTimer, &QTimer::timeout, this, [this] {
        m_scene.settle();
        update();
    });
    connect(&m_scene.land(), &LandLayer::updated, this, qOverload<>(&QWidget::update));
    connect(&m_document, &ScenarioDocument::replaced, this, &MapView::scenarioReplaced);
    connect(&m_document, &ScenarioDocument::scenarioChanged, this, &MapView::scenarioChanged);
    connect(&m_selection, &Selection::changed, this, &MapView::selectionChanged);
    connect(&m_camera, &MapCamera::moved, this, [this] {
        updateHover();
        update();
    });
    updateTexts();
}

void MapView::setPicture(MapPicture picture)
{
    m_picture = std::move(picture);
    refreshPicture();
    if (m_fitsNextPicture)
        m_camera.fit();
    m_fitsNextPicture = false;
}

void MapView::setTheme(const Theme& theme)
{
    m_scene.setTheme(theme);
    update();
}

void MapView::setLocked(bool locked)
{
    if (m_isLocked == locked)
        return;
    m_tools.tool().cancel();
    m_isLocked = locked;
    if (locked && isEditing(m_tools.kind()))
        m_tools.setKind(MapToolKind::Select);
    refreshPicture();
    m_tools.refresh();
}

void MapView::setMayIntervene(bool may)
{
    if (m_mayIntervene == may)
        return;
    if (m_isLocked)
        m_tools.tool().cancel();
    m_mayIntervene = may;
    m_tools.refresh();
}

void MapView::setDraft(std::function<void(MapPicture&)> draft)
{
    if (!draft && !m_draft)
        return;
    m_draft = std::move(draft);
    refreshPicture();
}

void MapView::setLayers(const MapLayers& layers)
{
    if (layers == m_scene.layers())
        return;
    m_scene.setLayers(layers);
    update();
}

void MapView::finishLand()
{
    m_scene.land().finish();
}

void MapView::setHighlight(const std::string& id)
{
    if (m_highlighted == id)
        return;
    m_highlighted = id;
    update();
}

void MapView::setPreview(const Scenario* scenario)
{
    m_preview = scenario != nullptr ? std::optional(*scenario) : std::nullopt;
    if (m_preview)
        m_scene.beginPreview();
    else
        m_scene.endPreview();
    refreshPicture();
}

void MapView::refreshPicture()
{
    MapPicture shown = m_preview && !m_isLocked ? withScenario(m_picture, *m_preview) : m_picture;
    if (m_isLocked && m_draft)
        m_draft(shown);
    const bool isOtherCount = shown.icebergs.size() != m_scene.picture().icebergs.size();
    const bool isElsewhere = !(shown.origin == m_scene.picture().origin);
    m_scene.setPicture(std::move(shown));
    m_camera.keepUavInSight();
    if (isElsewhere)
        emit m_camera.moved();
    if (isOtherCount)
        updateTexts();
    updateHover();
    update();
}

void MapView::scenarioReplaced()
{
    m_tools.tool().documentReplaced(); // cancelling would restore the old scenario
    m_fitsNextPicture = true;
}

void MapView::scenarioChanged()
{
    m_selection.keepExisting(m_document.scenario());
    m_tools.tool().documentChanged();
}

void MapView::selectionChanged()
{
    m_tools.endNudges(); // a new selection starts a new undo step
    m_camera.keepUavInSight();
    update();
}

void MapView::updateHover()
{
    if (m_tools.tool().isBusy() || m_panFrom)
        return;
    if (m_scene.setPointer(m_cursor))
        update();
    m_tools.setHovered(m_cursor ? m_scene.objectAt(*m_cursor) : std::string());
}

void MapView::updateTexts()
{
    setAccessibleRole(*this, QAccessible::Canvas);
    setAccessibleName(tr("Map"));
    setAccessibleDescription(
        tr("%n icebergs and the UAVs on the sea. Arrow keys move the map or the selection, plus "
           "and minus zoom, F fits. The iceberg table lists the icebergs.",
           nullptr, static_cast<int>(m_scene.picture().icebergs.size())));
}

void MapView::paintMarks(QPainter& painter)
{
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme& theme = m_scene.theme();
    const auto hover = [&](const std::string& id) {
        if (id.empty() || m_selection.contains(id))
            return;
        if (isOutlineKey(id))
            paintAreaMark(painter, m_scene.outlineOf(id), false, theme);
        if (const std::optional<LabelDisk> symbol = m_scene.symbolOf(id))
            paintHoverMark(painter, *symbol, theme);
    };
    hover(m_tools.hovered());
    if (m_highlighted != m_tools.hovered())
        hover(m_highlighted);
    for (const std::string& id : m_selection.ids())
        if (isOutlineKey(id))
            paintAreaMark(painter, m_scene.outlineOf(id), true, theme);
    for (const Iceberg& iceberg : m_document.scenario().icebergs) {
        if (iceberg.track.empty() || m_picture.hidesTruth || !m_selection.contains(iceberg.id))
            continue;
        QPolygonF path;
        for (const Point& position_m : iceberg.track.position_m)
            path << toScreen(position_m);
        paintRecordedTrack(painter, path, theme);
    }
    m_scene.paintSelection(painter, m_selection.ids());
}

void MapView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    m_scene.paint(painter, [&] { paintMarks(painter); });
    painter.setRenderHint(QPainter::Antialiasing);
    m_tools.tool().paint(painter);
    if (m_hasKeyboardFocus)
        paintFocusFrame(painter, rect(), m_scene.theme());
    if (m_scene.isUnsettled() && !m_settleTimer.isActive())
        m_settleTimer.start();
}

void MapView::resizeEvent(QResizeEvent*)
{
    m_camera.resize(QRectF(rect()));
    m_panels.placeInset();
}

void MapView::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange) {
        m_scene.setLocale(locale());
        updateTexts();
        m_tools.refresh();
    }
    QWidget::changeEvent(event);
}

} // namespace berg
