#pragma once

#include "widgets/charts/time_figure.h"
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

/** The value of one line at the instant read. */
struct ReadoutFlag
{
    QRectF rect{};
    QPointF at; ///< on the line
    QString text;
    QColor colour; ///< of the line
    QString name{};
    QString value{};
    QString key{};         ///< of the line
    bool isStrong = false; ///< stands out, or is the one the pointer is at
};

/** Beside the plot: a row for each line, in one or more columns. */
struct ValueColumn
{
    double left_px = 0; ///< of the first one
    double top_px = 0;
    double width_px = 0; ///< of one of them
    double row_px = 0;
    std::size_t rows = 0;    ///< in each of them
    std::size_t columns = 0; ///< 0: values are flags over the plot
    bool hasUnits = false;   ///< the value, with its unit, below the name
};

/** What all lines say at one instant. */
struct ChartReadout
{
    std::optional<double> hover_px; ///< abscissa of the thin line; none: the cursor is there
    QRectF timeRect;
    QString time; ///< empty: neither pointer nor cursor, the newest values in the column
    std::vector<ReadoutFlag> flags;
    std::size_t more = 0; ///< for which the column has no room
};

/**
 * Chart over time in the look of the program: no frame, light grid, times as mm:ss, the unit above
 * each axis, labels at the lines in place of a legend. Lines are decimated to the pixels there are;
 * nothing is animated.
 *
 * The wheel zooms the time axis at the pointer; the right or middle button, or the left one with
 * Shift, pans; a double click shows all. Keys: + and -, left and right, Home for all, End for the
 * live end. What is zoomed to stays while the chart grows, or moves along when following.
 */
class TimeChart : public QChartView
{
    Q_OBJECT

public:
    explicit TimeChart(const Theme& theme, QWidget* parent = nullptr);

    void setContent(const TimeChartContent& content);
    /** Makes at once what is made in turns of the event loop: for pictures without one. */
    void finishSeries();
    void setTheme(const Theme& theme);
    /** Without it the plot has its room: for a chart inside something that has a title. */
    void setTitleShown(bool shown);
    /**
     * Names and values of the lines stand in a column beside the plot where the chart is wide
     * enough for it: those at the pointer, at the cursor or the newest.
     */
    void setColumnWanted(bool wanted);
    /** False: lines in one colour each, for files that cannot hold pens with a gradient. */
    void setGradients(bool wanted);
    [[nodiscard]] const TimeChartContent& content() const { return m_content; }

    /** What is in view. */
    [[nodiscard]] TimeWindow window() const { return windowFor(m_content.duration_s); }
    /** What would be in view of a content of that length. */
    [[nodiscard]] TimeWindow windowFor(double duration_s) const;
    /** Number of columns for which lines are worth having points. */
    [[nodiscard]] int columns() const;
    [[nodiscard]] bool isZoomed() const { return m_zoom.has_value(); }
    [[nodiscard]] bool isFollowing() const { return m_zoom && m_following; }
    void setWindow(const TimeWindow& window);
    void showAll();
    /** Shows the stretch that another chart of the same time shows, and follows as it does. */
    void shareWindow(const TimeChart& other);
    /** On: the newest stretch, as long as the window is, at most 5 min when all was in view. */
    void setFollowing(bool on);

    /** Series as drawn, after decimation, in the order of `content().lines`. */
    [[nodiscard]] const std::vector<QList<QPointF>>& drawnPoints() const { return m_figure.drawn; }
    /** Everything around the lines as drawn, for tests. */
    [[nodiscard]] const Drawing& drawing() const { return m_figure.drawing; }
    [[nodiscard]] QRectF plot() const;
    /** Values at the pointer, or at the cursor; without flags where there is nothing to read. */
    [[nodiscard]] ChartReadout readout() const;

signals:
    /** Pressed or dragged in the plot: the user wants to see this instant. */
    void timePicked(double time_s);
    /** The label in the margin, or the row, of the line of that key was pressed. */
    void linePicked(const QString& key);
    /** The right button was let go where it was pressed, or the menu key was pressed. */
    void menuRequested(const QPoint& globalPos);
    /** Zoomed, panned, resized, or began or ceased to follow: other points may be wanted. */
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
    /** What Qt Charts draws a line with. */
    struct LineSeries
    {
        LineRole role = LineRole::Momentary;
        bool onRightAxis = false;
        QLineSeries* line = nullptr;
        QAreaSeries* area = nullptr; ///< below a momentary one
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
    [[nodiscard]] ValueColumn columnFor(const QSizeF& size_px) const;
    [[nodiscard]] std::vector<std::size_t> rowsAt(const std::vector<std::optional<QPointF>>& values,
                                                  ChartReadout& readout) const;
    void fillColumn(ChartReadout& readout, double time_s) const;
    void paintColumn(QPainter& painter, const ChartReadout& readout) const;
    [[nodiscard]] QString valueText(const TimeLine& line, double value) const;
    [[nodiscard]] ReadoutFlag flagOf(std::size_t index, const QPointF& value,
                                     double middle_px) const;
    void alignFlags(ChartReadout& readout, double at_px) const;
    void paintReadout(QPainter& painter) const;
    void pick(const QMouseEvent& event);
    void hoverAt(std::optional<QPointF> position);
    /** Key of the line whose label or row is there; empty: none. */
    [[nodiscard]] QString lineAt(const QPointF& position) const;
    void zoom(double factor, double anchor_s);
    void pan(double by_s);
    void changeWindow();

    Theme m_theme;
    TimeChartContent m_content;
    bool m_titleShown = true;
    bool m_gradients = true;
    bool m_isColumnWanted = false;
    ValueColumn m_column;
    bool m_plain = false; ///< so many segments that they are drawn thin and without smoothing
    std::optional<TimeWindow> m_zoom; ///< none: everything; its length when following
    bool m_following = false;
    std::optional<QPointF> m_hover; ///< the pointer in the plot
    bool m_picking = false;
    bool m_hasPanned = false;
    std::optional<QPointF> m_panFrom; ///< the press, then the last place of the pointer that pans
    QValueAxis* m_time = nullptr;
    QValueAxis* m_left = nullptr;
    QValueAxis* m_right = nullptr;
    std::vector<LineSeries> m_series; ///< of as many lines as have one yet
    QTimer m_nextSeries;
    TimeFigure m_figure;
    bool m_isLaidOut = false; ///< since the window was changed
    QPixmap m_picture;        ///< everything but the read-out; null: to be painted anew
};

} // namespace berg
