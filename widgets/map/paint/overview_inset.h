#pragma once

#include "widgets/map/land/land_layer.h"

#include <QWidget>

#include <optional>
#include <vector>

namespace berg {

/**
 * A polar chart of a hemisphere: shows where a place is and what part a map shows, and picks places
 * with a click. Of any size; a navigable one is zoomed with the wheel and moved with the mouse too.
 * GUI thread.
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
    /** Corners, and points between them, of what a map shows; empty: no box. */
    void setExtent(std::vector<LatLon> outline);

    /** Where a place is in the widget. */
    [[nodiscard]] QPointF pixelOf(const LatLon& place) const;
    /** What is at a pixel; none: outside the chart. */
    [[nodiscard]] std::optional<LatLon> placeAt(const QPointF& at) const;
    /** Zooms by a factor > 0 about a pixel, not farther out than the whole chart. */
    void zoomBy(double factor, const QPointF& at);
    /** Waits until all the land last painted can be painted: for pictures. */
    void finishLand();

    [[nodiscard]] QSize sizeHint() const override { return {184, 184}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {80, 80}; }

signals:
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
    std::optional<QPointF> m_pressed; ///< none: no button, or it has become a move
    QPointF m_movedTo;
};

} // namespace berg
