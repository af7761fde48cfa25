#include "widgets/panels/study/study_results.h"

#include "widgets/charts/study_chart.h"
#include "widgets/panels/fields/wheel_guard.h"
#include "widgets/panels/study/study_tables.h"
#include "widgets/tables/dock_table.h"
#include "widgets/theme/picture_page.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/policy_words.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QTabWidget>
#include <QTableView>
#include <QToolButton>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kGap_px = 6;
constexpr int kRow_px = 22;
constexpr int kLeastColumn_px = 60;
/** Rows measured for column widths, so that large tables stay fast. */
constexpr int kMeasuredRows = 60;
constexpr int kReference_px = 130;
constexpr QSize kPage_px(1120, 490); ///< size of an exported image

} // namespace

StudyResults::StudyResults(StudyRunner& runner, QWidget* parent) : QWidget(parent), m_runner(runner)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGap_px);
    addHeader(*column);
    auto* split = new QSplitter(Qt::Vertical);
    split->setChildrenCollapsible(false);
    split->addWidget(makeFigures());
    split->addWidget(makeTables());
    split->setSizes({3, 2});
    split->setStretchFactor(0, 3);
    split->setStretchFactor(1, 2);
    column->addWidget(split, 1);
    connect(&m_runner, &StudyRunner::updated, this, &StudyResults::showResult);
    connect(&m_runner, &StudyRunner::progress, this, &StudyResults::updateEnabled);
    setTheme(Theme::light());
    showResult();
}

QToolButton* StudyResults::addButton(QBoxLayout& row, const char* name, const QString& text,
                                     const QString& toolTip)
{
    auto* button = new QToolButton;
    button->setObjectName(QLatin1String(name));
    button->setText(text);
    button->setToolTip(toolTip);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    row.addWidget(button);
    return button;
}

void StudyResults::addHeader(QBoxLayout& column)
{
    auto* row = new QHBoxLayout;
    row->setSpacing(kGap_px);
    auto* caption = new QLabel(tr("Compared with"));
    m_reference = new QComboBox;
    m_reference->setObjectName(u"studyReference"_s);
    m_reference->setAccessibleName(caption->text());
    m_reference->setToolTip(tr("Reference that the other settings are compared with"));
    m_reference->setMinimumWidth(kReference_px);
    guardWheel(*m_reference);
    caption->setBuddy(m_reference);
    connect(m_reference, &QComboBox::activated, this,
            [this](int index) { m_runner.setReference(static_cast<std::size_t>(index)); });
    row->addWidget(caption);
    row->addWidget(m_reference);
    row->addStretch();
    m_openStudy =
        addButton(*row, "openStudy", tr("Open…"), tr("Opens a study to view or continue it."));
    connect(m_openStudy, &QToolButton::clicked, this, &StudyResults::openRequested);
    m_exports = {
        addButton(*row, "saveStudy", tr("Save…"),
                  tr("Saves the study with all flights so far, also while it is running.")),
        addButton(*row, "reportStudy", tr("Report…"),
                  tr("Writes a page with pictures, scenarios, seeds, version and machine.")),
        addButton(*row, "tableStudy", tr("Table…"),
                  tr("Saves the numbers of all settings as CSV.")),
        addButton(*row, "pictureStudy", tr("Picture…"),
                  tr("Saves the picture in front (PNG, SVG, PDF)."))};
    connect(m_exports[0], &QToolButton::clicked, this, &StudyResults::saveRequested);
    connect(m_exports[1], &QToolButton::clicked, this, &StudyResults::reportRequested);
    connect(m_exports[2], &QToolButton::clicked, this, &StudyResults::tableRequested);
    connect(m_exports[3], &QToolButton::clicked, this, &StudyResults::pictureRequested);
    column.addLayout(row);
    m_recommendation = new QLabel;
    m_recommendation->setObjectName(u"studyRecommendation"_s);
    m_recommendation->setWordWrap(true);
    m_recommendation->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_useBest = new QPushButton;
    m_useBest->setObjectName(u"useRecommendedSetting"_s);
    connect(m_useBest, &QPushButton::clicked, this, [this] {
        if (const std::optional<std::size_t> offered = offeredSetting())
            emit settingRequested(m_runner.result()->summary.settings[*offered].setting);
    });
    auto* recommended = new QHBoxLayout;
    recommended->setSpacing(kGap_px);
    recommended->addWidget(m_recommendation, 1);
    recommended->addWidget(m_useBest);
    column.addLayout(recommended);
}

QWidget* StudyResults::makeFigures()
{
    m_figures = new QTabWidget;
    m_figures->setObjectName(u"studyFigures"_s);
    m_figures->setDocumentMode(true);
    m_chart = new StudyChart(StudyFigureKind::Zeta, Theme::light());
    m_chart->setObjectName(u"studyChart"_s);
    m_differences = new StudyChart(StudyFigureKind::Differences, Theme::light());
    m_differences->setObjectName(u"differenceChart"_s);
    m_figures->addTab(m_chart, tr("ζ against τ"));
    m_figures->addTab(m_differences, tr("Differences"));
    connectFigure(*m_chart);
    connectFigure(*m_differences);
    return m_figures;
}

void StudyResults::connectFigure(StudyChart& figure)
{
    connect(&figure, &FigureView::itemChosen, this,
            [this](std::size_t setting) { choose(setting); });
    connect(&figure, &FigureView::itemActivated, this, &StudyResults::drillDown);
}

QTableView* StudyResults::makeTable(const char* name, const QString& title, CellModel& model)
{
    auto* table = new QTableView;
    table->setObjectName(QLatin1String(name));
    table->setAccessibleName(title);
    table->setModel(&model);
    setUpDockTable(*table, kRow_px);
    QHeaderView* header = table->horizontalHeader();
    header->setResizeContentsPrecision(kMeasuredRows);
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setMinimumSectionSize(kLeastColumn_px);
    header->setSortIndicator(0, Qt::AscendingOrder);
    table->setSortingEnabled(true);
    return table;
}

QWidget* StudyResults::makeTables()
{
    m_settingsModel = new CellModel(this);
    m_casesModel = new CellModel(this);
    m_settingsTable = makeTable("studySettings", tr("Settings of the study"), *m_settingsModel);
    m_casesTable = makeTable("studyCases", tr("Cases of the setting chosen"), *m_casesModel);
    connect(m_settingsTable->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& index) {
                if (index.isValid())
                    choose(settingAt(index.row()));
            });
    connect(m_settingsTable, &QTableView::activated, this, [this](const QModelIndex& index) {
        if (const auto setting = settingAt(index.row()))
            drillDown(*setting);
    });
    connect(m_casesTable->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            &StudyResults::updateEnabled);
    connect(m_casesTable, &QTableView::activated, this, &StudyResults::openRun);

    m_open = new QPushButton(tr("Open this run"));
    m_open->setObjectName(u"openStudyRun"_s);
    connect(m_open, &QPushButton::clicked, this, &StudyResults::openRun);
    m_use = new QPushButton;
    m_use->setObjectName(u"useStudySetting"_s);
    connect(m_use, &QPushButton::clicked, this, [this] {
        emit settingRequested(m_runner.result()->summary.settings[*m_setting].setting);
    });
    auto* corner = new QWidget;
    auto* buttons = new QHBoxLayout(corner);
    buttons->setContentsMargins(0, 0, 0, 0);
    buttons->setSpacing(kGap_px);
    buttons->addWidget(m_use);
    buttons->addWidget(m_open);

    m_tables = new QTabWidget;
    m_tables->setObjectName(u"studyTables"_s);
    m_tables->setDocumentMode(true);
    m_tables->addTab(m_settingsTable, tr("Settings"));
    m_tables->addTab(m_casesTable, tr("Cases"));
    m_tables->setCornerWidget(corner);
    connect(m_tables, &QTabWidget::currentChanged, this, &StudyResults::updateEnabled);
    return m_tables;
}

void StudyResults::setTheme(const Theme& theme)
{
    m_chart->setTheme(theme);
    m_differences->setTheme(theme);
    showSettings();
    for (QTableView* table : {m_settingsTable, m_casesTable})
        setDockTableTheme(*table, theme);
}

void StudyResults::showResult()
{
    const StudyPointer& result = m_runner.result();
    if (m_setting && (!result || *m_setting >= result->summary.settings.size()))
        m_setting.reset();
    m_chart->setResult(result);
    m_differences->setResult(result);
    showSettings();
    showRecommendation();
    showReferences();
    choose(m_setting);
    showCases();
}

/** Returns "τ 1.50, Round tour and 3 more": the settings that may be the best. */
QString StudyResults::contendersText(const StudySummary& summary) const
{
    constexpr std::size_t kMost = 4;
    const std::vector<std::size_t>& settings = summary.recommendation->contenders;
    QStringList names;
    for (std::size_t i = 0; i < std::min(kMost, settings.size()); ++i)
        names << settingText(summary.settings[settings[i]].setting, locale());
    const QString text = names.join(u", "_s);
    return settings.size() <= kMost ? text
                                    : tr("%1 and %2 more").arg(text).arg(settings.size() - kMost);
}

/**
 * Returns the setting that the button takes over: the recommended one, or the lowest of a single
 * case.
 */
std::optional<std::size_t> StudyResults::offeredSetting() const
{
    const StudyPointer& result = m_runner.result();
    if (!result || !result->summary.recommendation || result->summary.settings.size() < 2)
        return std::nullopt;
    const Recommendation& found = *result->summary.recommendation;
    return result->summary.cases.size() == 1 ? found.lowest : found.best;
}

void StudyResults::showRecommendation()
{
    const StudyPointer& result = m_runner.result();
    const bool isKnown =
        result && result->summary.recommendation && result->summary.settings.size() > 1;
    const std::optional<std::size_t> offered = offeredSetting();
    m_recommendation->setVisible(isKnown);
    m_useBest->setVisible(offered.has_value());
    if (!isKnown)
        return;
    const StudySummary& summary = result->summary;
    const Recommendation& found = *summary.recommendation;
    const auto cases = static_cast<int>(summary.cases.size());
    const auto name = [&](std::size_t s) {
        return settingText(summary.settings[s].setting, locale());
    };
    if (!offered) {
        m_recommendation->setText(
            tr("No clear winner over %n cases. These settings may be the best: %1.", nullptr, cases)
                .arg(contendersText(summary)));
        return;
    }
    m_useBest->setText(tr("Use %1").arg(name(*offered)));
    m_useBest->setToolTip(tr("Plans the scenario on the map with this setting."));
    m_recommendation->setText(
        cases == 1 ? tr("Lowest ζ: %1. One case is too few for a recommendation: fly more of them.")
                         .arg(name(*offered))
                   : tr("Recommended: %1. Its ζ is %2 (95 %: %3 to %4) against %5, the closest "
                        "other setting, over %n cases.",
                        nullptr, cases)
                         .arg(name(*offered), changeText(found.relative.mean, locale()),
                              changeText(found.relative.low, locale()),
                              changeText(found.relative.high, locale()), name(*found.next)));
}

void StudyResults::showReferences()
{
    const StudyPointer& result = m_runner.result();
    QStringList names;
    if (result)
        for (const SettingSummary& of : result->summary.settings)
            names << settingText(of.setting, locale());
    QStringList listed;
    for (int i = 0; i < m_reference->count(); ++i)
        listed << m_reference->itemText(i);
    if (names != listed) {
        m_reference->clear();
        m_reference->addItems(names);
    }
    if (result && !m_reference->view()->isVisible())
        m_reference->setCurrentIndex(static_cast<int>(result->summary.reference));
}

/** Chooses a setting in charts and tables; the last row of the table is none. */
void StudyResults::choose(std::optional<std::size_t> setting)
{
    const bool isNew = setting != m_setting;
    m_setting = setting;
    m_chart->setChosen(setting);
    m_differences->setChosen(setting);
    if (setting)
        if (const std::optional<int> row = m_settingsModel->shownRow(static_cast<int>(*setting));
            row && *row != m_settingsTable->currentIndex().row())
            m_settingsTable->setCurrentIndex(m_settingsModel->index(*row, 0));
    if (isNew)
        showCases();
}

void StudyResults::showSettings()
{
    m_settingsModel->setSheet(studySettings(m_runner.result(), m_chart->theme(), locale()));
}

std::optional<std::size_t> StudyResults::settingAt(int row) const
{
    const auto setting = static_cast<std::size_t>(m_settingsModel->sourceRow(row));
    return setting < m_runner.result()->summary.settings.size() ? std::optional(setting)
                                                                : std::nullopt;
}

std::size_t StudyResults::caseAt(int row) const
{
    return m_shown->summary.cases[static_cast<std::size_t>(m_casesModel->sourceRow(row))];
}

void StudyResults::showCases()
{
    const StudyPointer& result = m_runner.result();
    const int chosen = m_casesTable->currentIndex().row();
    const std::size_t before = chosen >= 0 ? caseAt(chosen) : 0;
    m_shown = result;
    m_casesModel->setSheet(studyCases(result, m_setting, locale()));
    const int rows = m_casesModel->rowCount();
    if (rows > 0 && m_casesTable->currentIndex().row() < 0) {
        int row = chosen >= 0 ? rows - 1 : 0;
        while (row > 0 && caseAt(row) != before)
            --row;
        m_casesTable->setCurrentIndex(m_casesModel->index(row, 0));
    }
    m_tables->setTabText(
        1, m_setting && rows > 0
               ? tr("Cases of %1")
                     .arg(settingText(result->summary.settings[*m_setting].setting, locale()))
               : tr("Cases"));
    updateEnabled();
}

void StudyResults::drillDown(std::size_t setting)
{
    choose(setting);
    m_tables->setCurrentWidget(m_casesTable);
    m_casesTable->setFocus();
}

std::optional<Scenario> StudyResults::chosenMission() const
{
    const StudyPointer& result = m_runner.result();
    if (!result || !m_setting)
        return std::nullopt;
    const int row = m_casesTable->currentIndex().row();
    const bool isOnly = m_casesModel->rowCount() == 1;
    if (row < 0 || (!isOnly && m_tables->currentWidget() != m_casesTable))
        return std::nullopt;
    return scenarioOf(result->study.spec, caseAt(row),
                      result->summary.settings[*m_setting].setting);
}

void StudyResults::openRun()
{
    if (const std::optional<Scenario> mission = chosenMission())
        emit openRunRequested(*mission);
}

void StudyResults::updateEnabled()
{
    const StudyPointer& result = m_runner.result();
    const bool hasCases = result && !result->summary.cases.empty();
    m_reference->setEnabled(hasCases);
    m_openStudy->setEnabled(!m_runner.isRunning()); // opening would replace the study
    for (QToolButton* button : m_exports)
        button->setEnabled(hasCases);
    m_tables->setTabEnabled(1, m_casesModel->rowCount() > 0);
    m_use->setEnabled(result && m_setting);
    m_use->setText(
        result && m_setting
            ? tr("Use %1").arg(settingText(result->summary.settings[*m_setting].setting, locale()))
            : tr("Use"));
    m_use->setToolTip(m_use->isEnabled() ? tr("Plans the scenario on the map with this setting.")
                                         : tr("Choose a point of the picture or a setting."));
    const bool canOpen = chosenMission().has_value();
    m_open->setEnabled(canOpen);
    m_open->setToolTip(
        canOpen ? tr("Repeats this case exactly and shows it on the map and the time line.")
                : tr("Choose a point of the picture or a setting, then a case."));
}

StudyChart* StudyResults::front() const
{
    return qobject_cast<StudyChart*>(m_figures->currentWidget());
}

QString StudyResults::pictureName() const
{
    return front() == m_chart ? u"study-zeta.png"_s : u"study-differences.png"_s;
}

void StudyResults::writePicture(const QString& path) const
{
    // A separate chart, so that selection and pointer are not in the image.
    StudyChart figure(front()->kind(), front()->theme());
    figure.resize(kPage_px);
    figure.setTitleShown(true);
    figure.setResult(m_runner.result());
    berg::writePicture({.size_px = kPage_px,
                        .title = figure.accessibleName(),
                        .description = figure.accessibleDescription(),
                        .paint = [&figure](QPainter& painter) { figure.paintFigure(painter); }},
                       path);
}

} // namespace berg
