#pragma once

#include "widgets/map/land/land_layer.h"

#include <QWidget>

#include <optional>
#include <vector>

namespace berg {

/**
 * Polar chart of a hemisphere that shows a place and the extent of a map, and picks places by
 * click. A navigable chart can also be zoomed by wheel and moved by mouse. GUI thread.
 */
class OverviewInset : public QWidget
{
    Q_OBJECT

public:
    explicit OverviewInset(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void setNavigable(bool navigable);

    [[nodiscard]] Pole pole() const { return m_frame.pole(); }
    /** Marks a place and shows its hemisphere. */
    void setPlace(const LatLon& place);
    /**
     * Sets the outline of the map's extent as a polygon; an empty or very small one draws no box.
     */
    void setExtent(std::vector<LatLon> outline);

    /** Returns the position of a place in the widget. */
    [[nodiscard]] QPointF pixelOf(const LatLon& place) const;
    /** Returns the place at a pixel; nullopt outside the chart. */
    [[nodiscard]] std::optional<LatLon> placeAt(const QPointF& at) const;
    /** Zooms by a factor > 0 about a pixel, at most out to the whole chart. */
    void zoomBy(double factor, const QPointF& at);
    /** Waits for the land that was painted last: for image export. */
    void finishLand();

    [[nodiscard]] QSize sizeHint() const override { return {184, 184}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {80, 80}; }

signals:
    /** The user clicked this place. */
    void placePicked(const berg::LatLon& place);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    [[nodiscard]] QRectF chartRect() const;
    [[nodiscard]] double wholeScale_pxpm() const;
    void setPole(Pole pole);
    void showWhole();
    void setView(const MapViewTransform& view);
    void updateTexts();
    void paintGraticule(QPainter& painter) const;
    void paintMarks(QPainter& painter) const;
    void paintCoordinates(QPainter& painter) const;

    Theme m_theme = Theme::light();
    PolarFrame m_frame;
    MapViewTransform m_view;
    LandLayer m_land;
    bool m_isNavigable = false;
    std::optional<LatLon> m_place;
    std::vector<LatLon> m_extent;
    std::optional<QPointF> m_cursor;
    std::optional<QPointF> m_pressed; ///< reset on release and once the mouse has moved
    QPointF m_movedTo;
};

} // namespace berg
