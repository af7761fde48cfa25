#pragma once

#include "widgets/charts/mission_series.h"
#include "widgets/theme/theme.h"

#include <QWidget>

#include <array>
#include <set>
#include <string>

class QAction;
class QComboBox;
class QMenu;
class QTableView;
class QToolButton;

namespace berg {

class CellModel;
class TimeChart;

/**
 * A chart of the mission over time, with controls above it for the kind of chart, its lines,
 * following or the whole run, and export. A table beside it shows the values of its
 * lines: at the pointer, at the instant viewed, or the newest. The record is read when it is shown
 * and not stored; of a long one only the new part is read.
 */
class ChartPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ChartPanel(ChartKind kind, const Theme& theme, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /** Shows a record. While flying, changes of less than half a pixel are postponed. */
    void showRecord(const FlightRecord& record);
    /**
     * Links the time windows of two charts, so that zooming or moving one also affects the other.
     */
    static void linkTimes(ChartPanel& a, ChartPanel& b);
    /**
     * Highlights the line of this iceberg among the sigmas; an empty or unknown id highlights none.
     */
    void setHighlight(const std::string& id);

    [[nodiscard]] ChartKind kind() const { return m_series.kind(); }
    /** Switches to another chart, which is empty until the next `showRecord`. */
    void setKind(ChartKind kind);

    /**
     * Writes a file by the extension of `path`: an image (.png, .svg, .pdf) of the shown lines and
     * time window, or a table (.csv) of every sample of every line. Throws `Error`: Unsupported for
     * another extension, FileUnwritable.
     */
    void exportChart(const QString& path) const;
    /** Returns the filters of a file dialog. */
    [[nodiscard]] static QString exportFilters();
    /** Returns the filters of images alone. */
    [[nodiscard]] static QStringList pictureFilters();
    /** Returns a proposed file name. */
    [[nodiscard]] QString exportName() const;

signals:
    /** Emitted when the user chooses an instant. */
    void timePicked(double time_s);
    /** Emitted when the user presses the label of an iceberg, or its row of values. */
    void icebergPicked(const std::string& id);
    /** Emitted when another chart is shown, which needs the record. */
    void kindChanged(ChartKind kind);
    /** Requests `exportChart` under a name of the user's choice. */
    void exportRequested();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QToolButton* addButton(const QString& name, const QString& text, const QString& toolTip);
    void addRow();
    void addMenuEntries();
    void addBody();
    void connectChart();
    void refresh();
    [[nodiscard]] bool isShown(const FlightRecord& record) const;
    void showMenu(const QPoint& globalPos);
    void copyPicture() const;
    void copyNumbers() const;
    void showValues();
    void showLineValues();
    void fitLineTable();
    void pickLine(const QString& key);
    void applyLines(TimeChartContent& content) const;
    void setShown(const QString& key, bool shown);
    void showAllLines();
    void updateButtons();

    MissionSeries m_series;
    TimeChartContent m_empty; ///< the chart without points
    Theme m_theme;
    std::set<QString> m_hidden; ///< keys of hidden lines
    QString m_highlight;
    RunPhase m_phase = RunPhase::Planning;          ///< phase of the last record
    std::size_t m_icebergs = 0;                     ///< number of icebergs in the last record
    std::shared_ptr<const ZetaBound> m_bound;       ///< bound of the last record
    std::shared_ptr<const WeatherCourse> m_weather; ///< weather of the last record
    bool m_wasInstant = false;                      ///< whether it showed an earlier instant
    QStringList m_listed;                           ///< names of the lines in the menu
    QComboBox* m_kind = nullptr;
    QToolButton* m_lines = nullptr;
    QMenu* m_menu = nullptr;
    QToolButton* m_follow = nullptr;
    QToolButton* m_all = nullptr;
    QToolButton* m_export = nullptr;
    QWidget* m_body = nullptr; ///< chart and values of its lines
    TimeChart* m_chart = nullptr;
    CellModel* m_lineValues = nullptr;
    QTableView* m_lineTable = nullptr; ///< hidden in a narrow panel
    std::array<int, 2> m_columns_px{}; ///< widths of its columns
    QAction* m_values = nullptr;       ///< shows the values as a table
};

} // namespace berg
