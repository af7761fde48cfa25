#pragma once

#include "widgets/charts/mission_series.h"
#include "widgets/theme/theme.h"

#include <QWidget>

#include <set>
#include <string>

class QAction;
class QComboBox;
class QMenu;
class QToolButton;

namespace berg {

class TimeChart;

/**
 * A chart of the mission over time and above it what is shown: the kind of chart, its lines, the
 * live end or everything, and export. The record is read when it is shown, not kept; of a long one
 * only what is new.
 */
class ChartPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ChartPanel(ChartKind kind, const Theme& theme, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /** While flying, a change of less than half a pixel is left for later. */
    void showRecord(const FlightRecord& record);
    /** From now on both show the same stretch of time, whichever is zoomed or moved. */
    static void linkTimes(ChartPanel& a, ChartPanel& b);
    /** The iceberg whose line stands out among the sigmas; empty or unknown: none. */
    void setHighlight(const std::string& id);

    [[nodiscard]] ChartKind kind() const { return m_series.kind(); }
    /** Another chart, empty until the next `showRecord`. */
    void setKind(ChartKind kind);

    /**
     * Writes what the end of `path` names: a picture (.png, .svg, .pdf) of the lines and the
     * stretch of time in view, or a table (.csv) of every sample of every line. Throws `Error`:
     * Unsupported for another end, FileUnwritable.
     */
    void exportChart(const QString& path) const;
    /** For a file dialog: the formats, and a name to start with. */
    [[nodiscard]] static QString exportFilters();
    /** Those of pictures alone. */
    [[nodiscard]] static QStringList pictureFilters();
    [[nodiscard]] QString exportName() const;

signals:
    /** The user wants to see this instant. */
    void timePicked(double time_s);
    /** The user pressed the label of an iceberg. */
    void icebergPicked(const std::string& id);
    /** Another chart is shown: it needs the record. */
    void kindChanged(ChartKind kind);
    /** `exportChart` is wanted, under a name of the user's choice. */
    void exportRequested();

private:
    QToolButton* addButton(const QString& name, const QString& text, const QString& toolTip);
    void addRow();
    void addMenuEntries();
    void connectChart();
    void refresh();
    [[nodiscard]] bool looksTheSame(const FlightRecord& record) const;
    void showMenu(const QPoint& globalPos);
    void copyPicture() const;
    void copyNumbers() const;
    void showValues();
    void applyLines(TimeChartContent& content) const;
    void setShown(const QString& key, bool shown);
    void showAllLines();
    void updateButtons();

    MissionSeries m_series;
    TimeChartContent m_empty; ///< the chart without its points
    Theme m_theme;
    std::set<QString> m_hidden; ///< keys of lines
    QString m_highlight;
    RunPhase m_phase = RunPhase::Planning;    ///< of the record shown last
    std::size_t m_icebergs = 0;               ///< in it
    std::shared_ptr<const ZetaBound> m_bound; ///< of it
    QStringList m_listed;                     ///< names of the lines in the menu
    QComboBox* m_kind = nullptr;
    QToolButton* m_lines = nullptr;
    QMenu* m_menu = nullptr;
    QToolButton* m_follow = nullptr;
    QToolButton* m_all = nullptr;
    QToolButton* m_export = nullptr;
    TimeChart* m_chart = nullptr;
    QAction* m_values = nullptr; ///< shows them as a table
};

} // namespace berg
