#pragma once

#include "widgets/charts/time_figure.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/theme/theme.h"

#include <QChartView>
#include <QLocale>
#include <QPixmap>
#include <QTimer>

#include <optional>
#include <vector>

class QAbstractSeries;
class QAreaSeries;
class QLineSeries;
class QValueAxis;

namespace berg {

/** Value of one line at the instant read. */
struct ReadoutFlag
{
    QRectF rect{};
    QPointF at; ///< point on the line
    QString text;
    QColor colour; ///< colour of the line
    QString name{};
    QString value{};
    QString unit{};        ///< unit of the value
    QString key{};         ///< key of the line
    bool isStrong = false; ///< emphasised, or nearest to the pointer
    bool isDashed = false; ///< whether the line is dashed
};

/** Values of all lines at one instant. */
struct ChartReadout
{
    std::optional<double> hover_px; ///< abscissa of the hover line; nullopt at the cursor
    QRectF timeRect;
    QString time; ///< empty without pointer and cursor: the newest values
    std::vector<ReadoutFlag> flags;
};

/**
 * Chart over time in the style of the program: no frame, light grid, times as mm:ss, units above
 * the axes, labels at the lines instead of a legend. Lines are decimated to the available pixels;
 * nothing is animated.
 *
 * The wheel zooms the time axis at the pointer; the right or middle button, or Shift with the left
 * one, pans; a double click shows all. Keys: + and - zoom, left and right pan, Home shows all, End
 * follows the end. A zoomed window stays while the chart grows, or moves along when following.
 */
class TimeChart : public QChartView
{
    Q_OBJECT

public:
    explicit TimeChart(const Theme& theme, QWidget* parent = nullptr);

    /** Shows this content; keeps the zoom unless it is beyond the end. */
    void setContent(const TimeChartContent& content);
    /** Creates all series at once rather than over several event loop turns: for image export. */
    void finishSeries();
    void setTheme(const Theme& theme);
    /** Shows the chart's title; without it the plot is larger. */
    void setTitleShown(bool shown);
    /**
     * Leaves names and values of the lines to a table beside the chart, of which `readout` is the
     * content: values of all lines at the pointer, at the cursor, or the newest ones.
     */
    void setValuesBeside(bool beside);
    /** Disables gradient pens: lines get one colour each, for formats without gradients. */
    void setGradients(bool wanted);
    [[nodiscard]] const TimeChartContent& content() const { return m_content; }

    /** Time range in view. */
    [[nodiscard]] TimeWindow window() const { return windowFor(m_content); }
    /** Time range that would be in view for a content. */
    [[nodiscard]] TimeWindow windowFor(const TimeChartContent& content) const;
    /** Number of pixel columns that lines should be decimated to. */
    [[nodiscard]] int columns() const;
    [[nodiscard]] bool isZoomed() const { return m_zoom.has_value(); }
    [[nodiscard]] bool isFollowing() const { return m_zoom && m_following; }
    /** Zooms to a time range and stops following. */
    void setWindow(const TimeWindow& window);
    /** Shows the whole time range. */
    void showAll();
    /** Takes over the time range and following of another chart with the same time axis. */
    void shareWindow(const TimeChart& other);
    /** Keeps the end in view with the present window length, 5 min if all was in view. */
    void setFollowing(bool on);

    /** Points as drawn, after decimation, in the order of `content().lines`. */
    [[nodiscard]] const std::vector<QList<QPointF>>& drawnPoints() const { return m_figure.drawn; }
    /** Drawing around the lines, for tests. */
    [[nodiscard]] const Drawing& drawing() const { return m_figure.drawing; }
    /** Rectangle of the plot in the widget. */
    [[nodiscard]] QRectF plot() const;
    /**
     * Values at the pointer, or at the cursor; without flags if there is no value. With values
     * beside the chart the flags are those of all lines, without places.
     */
    [[nodiscard]] ChartReadout readout() const;

signals:
    /** The plot was pressed or dragged at this time. */
    void timePicked(double time_s);
    /** Other values are to be read. */
    void readoutChanged();
    /** The label in the margin of the line with this key was pressed. */
    void linePicked(const QString& key);
    /** The right button was clicked without panning, or the menu key was pressed. */
    void menuRequested(const QPoint& globalPos);
    /** Time range, size or following changed: other points may be needed. */
    void windowChanged();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    bool viewportEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void drawBackground(QPainter* painter, const QRectF& rect) override;
    void drawForeground(QPainter* painter, const QRectF& rect) override;

private:
    /** Qt Charts series of a line. */
    struct LineSeries
    {
        LineRole role = LineRole::Momentary;
        bool onRightAxis = false;
        QLineSeries* line = nullptr;
        QAreaSeries* area = nullptr; ///< below a momentary line
    };
    [[nodiscard]] bool hasSeriesOfKinds() const;
    [[nodiscard]] std::size_t drawnSeries() const;
    void addMissingSeries();
    void addSeries(QAbstractSeries* series, const TimeLine& line);
    void layOut();
    void setAxes();
    void showPoints();
    void styleLines();
    void styleLine(std::size_t index, const QBrush& bySigma, Qt::PenCapStyle cap);
    [[nodiscard]] QColor colourOf(const TimeLine& line) const;
    [[nodiscard]] std::vector<PixelRect> flagsAtCursor() const;
    void readAll(ChartReadout& readout, double time_s) const;
    /** Unit of the values of a line in readouts. */
    [[nodiscard]] ShownUnit unitOf(const TimeLine& line) const;
    [[nodiscard]] QString valueText(const TimeLine& line, double value) const;
    [[nodiscard]] ReadoutFlag flagOf(std::size_t index, const QPointF& value,
                                     double middle_px) const;
    void alignFlags(ChartReadout& readout, double at_px) const;
    void paintReadout(QPainter& painter) const;
    void pick(const QMouseEvent& event);
    void hoverAt(std::optional<QPointF> position);
    /** Key of the line whose label is at a position; empty if there is none. */
    [[nodiscard]] QString lineAt(const QPointF& position) const;
    void zoom(double factor, double anchor_s);
    void pan(double by_s);
    void changeWindow();

    Theme m_theme;
    TimeChartContent m_content;
    bool m_titleShown = true;
    bool m_gradients = true;
    bool m_valuesBeside = false;
    bool m_plain = false; ///< so many segments that they are drawn thin and without smoothing
    std::optional<TimeWindow> m_zoom; ///< nullopt shows all; when following only its length counts
    bool m_following = false;
    std::optional<QPointF> m_hover; ///< position of the pointer in the plot
    bool m_picking = false;
    bool m_hasPanned = false;
    std::optional<QPointF> m_panFrom; ///< position of the press, then of the last pan
    QValueAxis* m_time = nullptr;
    QValueAxis* m_left = nullptr;
    QValueAxis* m_right = nullptr;
    std::vector<LineSeries> m_series; ///< series created so far, by line
    QTimer m_nextSeries;
    TimeFigure m_figure;
    bool m_isLaidOut = false; ///< since the last change of the window
    QPixmap m_pixmap;         ///< cache of all but the readout; null if it must be painted
};

} // namespace berg
