#pragma once

#include "widgets/map/land/backdrop.h"
#include "widgets/map/land/land_drawing.h"
#include "widgets/tasks/latest_task.h"

#include <QImage>
#include <QObject>
#include <QTimer>

#include <array>

namespace berg {

/** Parameters of an image of land and sea. */
struct LandRequest
{
    MapPlane plane = LocalFrame({});
    MapViewTransform view;
    QRectF rect;
    double ratio = 1; ///< device pixels per unit of `rect`
    LandStyle style;
    BackdropPointer backdrop = {}; ///< drawn above the land; null if there is none
    double backdropOpacity = 1;
    BackdropPointer ice = {}; ///< ice chart, drawn below the backdrop; null if there is none
    double iceOpacity = 1;
    BackdropStyle backdropStyle = {};
    bool operator==(const LandRequest&) const = default;
};

/** Paints land, sea and backdrop at once. */
void paintGroundOf(QPainter& painter, const LandRequest& request);

/**
 * Land and sea below a moving map, drawn on a worker thread into an image a little larger than the
 * map. Until the image of a new view is ready, the last one is shown, moved and scaled. A view that
 * the last image covers is drawn once the map has come to rest. GUI thread.
 */
class LandLayer : public QObject
{
    Q_OBJECT

public:
    explicit LandLayer(QObject* parent = nullptr);

    /** Paints the best image available; `updated` follows if that is not the final one. */
    void paint(QPainter& painter, const LandRequest& request);
    /** Waits for the image of the last request painted, so that the next `paint` shows it. */
    void finish();

signals:
    /** Emitted when a better image is ready, so that the map should be painted again. */
    void updated();

private:
    struct ShownLand
    {
        LandRequest request;
        QRectF rect; ///< area of the image in the view of the request
        QImage image;
    };
    void setRequest(const LandRequest& request);
    void startDrawing();
    void acceptImage();
    [[nodiscard]] bool showsSameLand(const LandRequest& request) const;
    /** Returns the area of the shown image in `view`. */
    [[nodiscard]] QRectF placeIn(const MapViewTransform& view) const;
    // On the thread of the layer:
    void drawNewest();
    [[nodiscard]] ShownLand drawn(const LandRequest& request);
    void paintBackdrops(QPainter& painter, const LandRequest& request, const QRectF& rect);

    LandRequest m_request;
    std::optional<ShownLand> m_shown;
    QTimer m_rest; ///< fires when the view has come to rest
    Mailbox<LandRequest> m_requests;
    Mailbox<ShownLand> m_results;

    std::array<std::optional<LandDrawing>, 2> m_drawings; ///< by level of detail, in `m_plane`
    MapPlane m_plane = LocalFrame({});
    std::optional<BackdropDrawing> m_ice;
    std::optional<BackdropDrawing> m_backdrop;

    WorkThread m_thread; ///< last member: it ends, with the image in progress, before the others
};

} // namespace berg
