#pragma once

#include "widgets/model/study_runner.h"
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

class DifferenceChart;
class StudyCasesModel;
class StudyChart;
class StudyPicture;
class StudySettingsModel;
class StudyTableModel;

/**
 * What a study has come to: zeta against tau, differences, a table of the settings, and the cases
 * of the one chosen, each of which can be opened. Shows and steers a runner that it borrows.
 */
class StudyResults : public QWidget
{
    Q_OBJECT

public:
    explicit StudyResults(StudyRunner& runner, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /**
     * Writes the picture in front as the end of `path` names (.png, .svg, .pdf). Throws `Error`:
     * Unsupported for another end, FileUnwritable.
     */
    void writePicture(const QString& path) const;
    /** Name for a file of the picture in front. */
    [[nodiscard]] QString pictureName() const;

signals:
    /** The user wants to see this flight: its scenario exactly as the study flew it. */
    void openRunRequested(const berg::Scenario& scenario);
    /** The user wants to plan with these settings. */
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
    [[nodiscard]] QWidget* makePictures();
    [[nodiscard]] QWidget* makeTables();
    [[nodiscard]] QTableView* makeTable(const char* name, const QString& title,
                                        StudyTableModel& model);
    void connectPicture(StudyPicture& picture);
    void showResult();
    [[nodiscard]] QString contendersText(const StudySummary& summary) const;
    [[nodiscard]] std::optional<std::size_t> offeredSetting() const;
    void showRecommendation();
    void showReferences();
    void showCases();
    void updateEnabled();
    void choose(std::optional<std::size_t> setting);
    void drillDown(std::size_t setting);
    /** That of the case in front, or of the only case there is. */
    [[nodiscard]] std::optional<Scenario> chosenMission() const;
    void openRun();
    [[nodiscard]] StudyPicture* front() const;

    StudyRunner& m_runner;
    std::optional<std::size_t> m_setting; ///< chosen
    QComboBox* m_reference = nullptr;
    QLabel* m_recommendation = nullptr;
    QPushButton* m_useBest = nullptr; ///< the setting that is named there
    QToolButton* m_openStudy = nullptr;
    std::array<QToolButton*, 4> m_exports{};
    QTabWidget* m_pictures = nullptr;
    StudyChart* m_chart = nullptr;
    DifferenceChart* m_differences = nullptr;
    QTabWidget* m_tables = nullptr;
    StudySettingsModel* m_settingsModel = nullptr;
    StudyCasesModel* m_casesModel = nullptr;
    QTableView* m_settingsTable = nullptr;
    QTableView* m_casesTable = nullptr;
    QPushButton* m_open = nullptr;
    QPushButton* m_use = nullptr;
};

} // namespace berg
