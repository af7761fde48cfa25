#include "widgets/map/land/land_layer.h"

#include "widgets/tasks/work_failure.h"
#include "widgets/theme/painter_state.h"

#include <QPainter>

#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kMargin_px = 160; // extra width of the image around the map
constexpr int kRest_ms = 120;

} // namespace

void paintGroundOf(QPainter& painter, const LandRequest& request)
{
    paintLand(painter, request.plane, request.view, request.rect, request.style);
    const auto paint = [&](const BackdropPointer& shapes, double opacity) {
        if (shapes == nullptr || opacity <= 0)
            return;
        const PainterState saved(painter);
        painter.setOpacity(opacity);
        BackdropDrawing(shapes, request.plane)
            .paint(painter, request.view, request.rect, request.backdropStyle);
    };
    paint(request.ice, request.iceOpacity);
    paint(request.backdrop, request.backdropOpacity);
}

LandLayer::LandLayer(QObject* parent) : QObject(parent), m_thread(u"land"_s)
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRest_ms);
    connect(&m_rest, &QTimer::timeout, this, &LandLayer::startDrawing);
}

void LandLayer::paint(QPainter& painter, const LandRequest& request)
{
    setRequest(request);
    const PainterState saved(painter);
    painter.setClipRect(request.rect, Qt::IntersectClip);
    const QRectF place = showsSameLand(request) ? placeIn(request.view) : QRectF();
    if (!place.contains(request.rect))
        painter.fillRect(request.rect, request.style.sea);
    if (!place.isNull())
        painter.drawImage(place, m_shown->image);
}

void LandLayer::finish()
{
    if (m_shown && m_shown->request == m_request)
        return;
    startDrawing();
    m_thread.waitForPosted();
    acceptImage();
}

void LandLayer::setRequest(const LandRequest& request)
{
    if (m_request == request)
        return;
    m_request = request;
    const bool isCovered = showsSameLand(request) &&
                           m_shown->request.view.scale_pxpm() == request.view.scale_pxpm() &&
                           placeIn(request.view).contains(request.rect);
    if (isCovered)
        m_rest.start();
    else
        startDrawing();
}

void LandLayer::startDrawing()
{
    m_rest.stop();
    if (m_requests.put(m_request))
        m_thread.post([this] { drawNewest(); });
}

bool LandLayer::showsSameLand(const LandRequest& request) const
{
    return m_shown && m_shown->request.plane == request.plane &&
           m_shown->request.style == request.style && m_shown->request.ratio == request.ratio;
}

QRectF LandLayer::placeIn(const MapViewTransform& view) const
{
    const MapViewTransform& before = m_shown->request.view;
    return {view.toPixel(before.toWorld(m_shown->rect.topLeft())),
            m_shown->rect.size() * (view.scale_pxpm() / before.scale_pxpm())};
}

void LandLayer::acceptImage()
{
    std::optional<ShownLand> result = m_results.take();
    if (!result)
        return;
    m_shown = std::move(result);
    emit updated();
}

void LandLayer::drawNewest()
{
    const std::optional<LandRequest> request = m_requests.take();
    if (request && m_results.put(drawn(*request)))
        QMetaObject::invokeMethod(this, &LandLayer::acceptImage, Qt::QueuedConnection);
}

LandLayer::ShownLand LandLayer::drawn(const LandRequest& request)
{
    if (!(request.plane == m_plane)) {
        m_plane = request.plane;
        for (std::optional<LandDrawing>& drawing : m_drawings)
            drawing.reset();
    }
    const QRectF rect =
        request.rect.adjusted(-kMargin_px, -kMargin_px, kMargin_px, kMargin_px).toAlignedRect();
    ShownLand shown{.request = request, .rect = rect, .image = {}};
    shown.image = QImage((rect.size() * request.ratio).toSize(), QImage::Format_RGB32);
    shown.image.setDevicePixelRatio(request.ratio);
    shown.image.fill(request.style.sea);
    QPainter painter(&shown.image);
    painter.translate(-rect.topLeft());
    const auto failure = failureOf([&] {
        const LandDetail detail = landDetailFor(request.view.scale_pxpm());
        std::optional<LandDrawing>& drawing = m_drawings[static_cast<std::size_t>(detail)];
        if (!drawing)
            drawing.emplace(landData(detail), m_plane);
        drawing->paint(painter, request.view, rect, request.style);
        paintBackdrops(painter, request, rect);
    });
    if (failure)
        painter.fillRect(rect, request.style.sea); // the map remains usable without land
    return shown;
}

void LandLayer::paintBackdrops(QPainter& painter, const LandRequest& request, const QRectF& rect)
{
    const auto paint = [&](std::optional<BackdropDrawing>& drawing, const BackdropPointer& shapes,
                           double opacity) {
        if (shapes == nullptr || opacity <= 0) {
            drawing.reset();
            return;
        }
        if (!drawing || !drawing->isOf(shapes, request.plane))
            drawing.emplace(shapes, request.plane);
        painter.setOpacity(opacity);
        drawing->paint(painter, request.view, rect, request.backdropStyle);
        painter.setOpacity(1);
    };
    paint(m_ice, request.ice, request.iceOpacity);
    paint(m_backdrop, request.backdrop, request.backdropOpacity);
}

} // namespace berg
