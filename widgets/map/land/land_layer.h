#pragma once

#include "widgets/map/land/backdrop.h"
#include "widgets/map/land/land_drawing.h"
#include "widgets/model/latest_task.h"

#include <QImage>
#include <QObject>
#include <QTimer>

#include <array>

namespace berg {

/** Land and sea as a map shows them. */
struct LandRequest
{
    MapPlane plane = LocalFrame({});
    MapViewTransform view;
    QRectF rect;
    double ratio = 1; ///< device pixels for each unit of `rect`
    LandLook look;
    BackdropPointer backdrop = {}; ///< above the land; null: none
    double backdropOpacity = 1;
    BackdropLook backdropLook = {};
    bool operator==(const LandRequest&) const = default;
};

/** Draws all of it here and now. */
void paintGroundOf(QPainter& painter, const LandRequest& request);

/**
 * Land and sea below a map that moves: drawn on a thread of its own into an image a little larger
 * than the map. Until the image of a new view is there, the last one is shown, moved and scaled; a
 * view that the last one covers is drawn when it has come to rest. GUI thread.
 */
class LandLayer : public QObject
{
    Q_OBJECT

public:
    explicit LandLayer(QObject* parent = nullptr);

    /** Paints what is known of it now; `updated` follows when that is not all. */
    void paint(QPainter& painter, const LandRequest& wanted);
    /** Waits for the image of what was painted last. */
    void finish();

signals:
    /** Painting it again shows more. */
    void updated();

private:
    struct Shown
    {
        LandRequest request;
        QRectF rect; ///< of the image, in the view of the request
        QImage image;
    };
    void want(const LandRequest& wanted);
    void ask();
    void take();
    [[nodiscard]] bool isOfSameLand(const LandRequest& wanted) const;
    /** Where the image is now. */
    [[nodiscard]] QRectF placeIn(const MapViewTransform& view) const;
    // On the thread of the layer:
    void drawNewest();
    [[nodiscard]] Shown drawn(const LandRequest& request);
    void paintBackdrop(QPainter& painter, const LandRequest& request, const QRectF& rect);

    LandRequest m_wanted;
    std::optional<Shown> m_shown;
    QTimer m_rest; ///< runs out when the view has come to rest
    Mailbox<LandRequest> m_requests;
    Mailbox<Shown> m_results;

    std::array<std::optional<LandDrawing>, 2> m_drawings; ///< by detail, of `m_plane`
    MapPlane m_plane = LocalFrame({});
    std::optional<BackdropDrawing> m_backdrop;

    WorkThread m_thread; ///< last: it ends, with the image under way, before the rest
};

} // namespace berg
