#include "widgets/map/land/land_layer.h"

#include "widgets/model/work_failure.h"
#include "widgets/theme/painter_state.h"

#include <QPainter>

#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kMargin_px = 160; // of the image round the map
constexpr int kRest_ms = 120;

} // namespace

void paintGroundOf(QPainter& painter, const LandRequest& request)
{
    paintLand(painter, request.plane, request.view, request.rect, request.look);
    if (request.backdrop == nullptr || request.backdropOpacity <= 0)
        return;
    const PainterState saved(painter);
    painter.setOpacity(request.backdropOpacity);
    BackdropDrawing(request.backdrop, request.plane)
        .paint(painter, request.view, request.rect, request.backdropLook);
}

LandLayer::LandLayer(QObject* parent) : QObject(parent), m_thread(u"land"_s)
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRest_ms);
    connect(&m_rest, &QTimer::timeout, this, &LandLayer::ask);
}

void LandLayer::paint(QPainter& painter, const LandRequest& wanted)
{
    want(wanted);
    const PainterState saved(painter);
    painter.setClipRect(wanted.rect, Qt::IntersectClip);
    const QRectF place = isOfSameLand(wanted) ? placeIn(wanted.view) : QRectF();
    if (!place.contains(wanted.rect))
        painter.fillRect(wanted.rect, wanted.look.sea);
    if (!place.isNull())
        painter.drawImage(place, m_shown->image);
}

void LandLayer::finish()
{
    if (m_shown && m_shown->request == m_wanted)
        return;
    ask();
    m_thread.waitForPosted();
    take();
}

void LandLayer::want(const LandRequest& wanted)
{
    if (m_wanted == wanted)
        return;
    m_wanted = wanted;
    const bool isCovered = isOfSameLand(wanted) &&
                           m_shown->request.view.scale_pxpm() == wanted.view.scale_pxpm() &&
                           placeIn(wanted.view).contains(wanted.rect);
    if (isCovered)
        m_rest.start();
    else
        ask();
}

void LandLayer::ask()
{
    m_rest.stop();
    if (m_requests.put(m_wanted))
        m_thread.post([this] { drawNewest(); });
}

bool LandLayer::isOfSameLand(const LandRequest& wanted) const
{
    return m_shown && m_shown->request.plane == wanted.plane &&
           m_shown->request.look == wanted.look && m_shown->request.ratio == wanted.ratio;
}

QRectF LandLayer::placeIn(const MapViewTransform& view) const
{
    const MapViewTransform& before = m_shown->request.view;
    return {view.toPixel(before.toWorld(m_shown->rect.topLeft())),
            m_shown->rect.size() * (view.scale_pxpm() / before.scale_pxpm())};
}

void LandLayer::take()
{
    std::optional<Shown> result = m_results.take();
    if (!result)
        return;
    m_shown = std::move(result);
    emit updated();
}

void LandLayer::drawNewest()
{
    const std::optional<LandRequest> request = m_requests.take();
    if (request && m_results.put(drawn(*request)))
        QMetaObject::invokeMethod(this, &LandLayer::take, Qt::QueuedConnection);
}

LandLayer::Shown LandLayer::drawn(const LandRequest& request)
{
    if (!(request.plane == m_plane)) {
        m_plane = request.plane;
        for (std::optional<LandDrawing>& drawing : m_drawings)
            drawing.reset();
    }
    const QRectF rect =
        request.rect.adjusted(-kMargin_px, -kMargin_px, kMargin_px, kMargin_px).toAlignedRect();
    Shown shown{.request = request, .rect = rect, .image = {}};
    shown.image = QImage((rect.size() * request.ratio).toSize(), QImage::Format_RGB32);
    shown.image.setDevicePixelRatio(request.ratio);
    shown.image.fill(request.look.sea);
    QPainter painter(&shown.image);
    painter.translate(-rect.topLeft());
    const auto failure = failureOf([&] {
        const LandDetail detail = landDetailFor(request.view.scale_pxpm());
        std::optional<LandDrawing>& drawing = m_drawings[static_cast<std::size_t>(detail)];
        if (!drawing)
            drawing.emplace(landData(detail), m_plane);
        drawing->paint(painter, request.view, rect, request.look);
        paintBackdrop(painter, request, rect);
    });
    if (failure)
        painter.fillRect(rect, request.look.sea); // a map without land can still be worked with
    return shown;
}

void LandLayer::paintBackdrop(QPainter& painter, const LandRequest& request, const QRectF& rect)
{
    if (request.backdrop == nullptr || request.backdropOpacity <= 0) {
        m_backdrop.reset();
        return;
    }
    if (!m_backdrop || !m_backdrop->isOf(request.backdrop, request.plane))
        m_backdrop.emplace(request.backdrop, request.plane);
    painter.setOpacity(request.backdropOpacity);
    m_backdrop->paint(painter, request.view, rect, request.backdropLook);
    painter.setOpacity(1);
}

} // namespace berg
