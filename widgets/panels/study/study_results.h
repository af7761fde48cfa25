#pragma once

#include "widgets/study/study_runner.h"
#include "widgets/theme/theme.h"

#include <QWidget>

#include <array>
#include <optional>

class QBoxLayout;
class QComboBox;
class QLabel;
class QPushButton;
class QTableView;
class QTabWidget;
class QToolButton;

namespace berg {

class CellModel;
class StudyChart;

/**
 * Results of a study: zeta against tau, differences, a table of the settings, and the cases of the
 * chosen one, each of which can be opened. Shows and controls a runner that it borrows.
 */
class StudyResults : public QWidget
{
    Q_OBJECT

public:
    explicit StudyResults(StudyRunner& runner, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /**
     * Writes the front chart in the format of the extension of `path` (.png, .svg, .pdf). Throws
     * `Error`: Unsupported for another extension, FileUnwritable.
     */
    void writePicture(const QString& path) const;
    /** Returns a file name for the front chart. */
    [[nodiscard]] QString pictureName() const;

signals:
    /** Requests to show a flight; its scenario is exactly as in the study. */
    void openRunRequested(const berg::Scenario& scenario);
    /** Requests to plan with these settings. */
    void settingRequested(const berg::StudySetting& setting);
    void openRequested();
    void saveRequested();
    void reportRequested();
    void tableRequested();
    void pictureRequested();

private:
    void addHeader(QBoxLayout& column);
    QToolButton* addButton(QBoxLayout& row, const char* name, const QString& text,
                           const QString& toolTip);
    [[nodiscard]] QWidget* makeFigures();
    [[nodiscard]] QWidget* makeTables();
    [[nodiscard]] QTableView* makeTable(const char* name, const QString& title, CellModel& model);
    void connectFigure(StudyChart& figure);
    void showResult();
    [[nodiscard]] QString contendersText(const StudySummary& summary) const;
    [[nodiscard]] std::optional<std::size_t> offeredSetting() const;
    void showRecommendation();
    void showReferences();
    void showSettings();
    void showCases();
    /** Returns the setting of a row; nullopt for the row "best tau of each case". */
    [[nodiscard]] std::optional<std::size_t> settingAt(int row) const;
    /** Returns the index in the study of a case in the table. */
    [[nodiscard]] std::size_t caseAt(int row) const;
    void updateEnabled();
    void choose(std::optional<std::size_t> setting);
    void drillDown(std::size_t setting);
    /** Returns the scenario of the current case, or of the only case. */
    [[nodiscard]] std::optional<Scenario> chosenMission() const;
    void openRun();
    [[nodiscard]] StudyChart* front() const;

    StudyRunner& m_runner;
    StudyPointer m_shown;                 ///< result whose cases are in the table
    std::optional<std::size_t> m_setting; ///< chosen setting
    QComboBox* m_reference = nullptr;
    QLabel* m_recommendation = nullptr;
    QPushButton* m_useBest = nullptr; ///< takes over the setting that is named there
    QToolButton* m_openStudy = nullptr;
    std::array<QToolButton*, 4> m_exports{};
    QTabWidget* m_figures = nullptr;
    StudyChart* m_chart = nullptr;
    StudyChart* m_differences = nullptr;
    QTabWidget* m_tables = nullptr;
    CellModel* m_settingsModel = nullptr;
    CellModel* m_casesModel = nullptr;
    QTableView* m_settingsTable = nullptr;
    QTableView* m_casesTable = nullptr;
    QPushButton* m_open = nullptr;
    QPushButton* m_use = nullptr;
};

} // namespace berg
