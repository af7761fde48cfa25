#include "widgets/panels/study/start_panel.h"

#include "core/scenario/utc_time.h"
#include "widgets/charts/start_chart.h"
#include "widgets/document/scenario_document.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/fields/panel_labels.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/weather_words.h"

#include <QBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kStartMargin_px = 10;
constexpr int kStartGap_px = 10;
constexpr int kStartBar_px = 6;
constexpr double kUsualSpan_h = 24;
constexpr double kUsualEvery_h = 1;
constexpr double kLongestSpan_h = 240;
constexpr double kShortestEvery_h = 0.25; // 960 starts at most

QString startName(const StartScan& scan, std::size_t index)
{
    const std::optional<UtcTime> start = parseUtc(scan.starts[index].startUtc);
    return start ? QString::fromStdString(minuteText(*start, 0)) : QString();
}

} // namespace

StartPanel::StartPanel(StartRunner& runner, ScenarioDocument& document, QWidget* parent)
    : QWidget(parent), m_runner(runner), m_document(document)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kStartMargin_px, kStartMargin_px, kStartMargin_px, kStartMargin_px);
    column->setSpacing(kStartGap_px);
    addRow();
    m_chart = new StartChart(Theme::light());
    m_chart->setObjectName(u"startChart"_s);
    column->addWidget(m_chart, 1);
    m_state = new QLabel;
    m_state->setObjectName(u"startState"_s);
    m_state->setWordWrap(true);
    column->addWidget(m_state);
    connect(m_compare, &QPushButton::clicked, this, &StartPanel::compareOrCancel);
    connect(m_use, &QPushButton::clicked, this, &StartPanel::useChosen);
    connect(m_chart, &StartChart::itemChosen, this, [this](std::size_t item) {
        m_chart->setChosen(item);
        showChosen();
    });
    connect(m_chart, &StartChart::itemActivated, this, [this](std::size_t item) {
        m_chart->setChosen(item);
        showChosen();
    });
    connect(&m_runner, &StartRunner::progress, this, &StartPanel::showProgress);
    connect(&m_runner, &StartRunner::changed, this, &StartPanel::showEnd);
    connect(&m_document, &ScenarioDocument::scenarioChanged, this, &StartPanel::showState);
    setTheme(Theme::light());
    showEnd({});
}

void StartPanel::addRow()
{
    auto* row = new QHBoxLayout;
    row->setSpacing(kStartGap_px);
    qobject_cast<QVBoxLayout*>(layout())->addLayout(row);
    const auto number = [row](const QString& name, const QString& label, double low, double high,
                              double value) {
        auto* field = new NumberField;
        field->setObjectName(name);
        field->setAccessibleName(label);
        field->setRange(low, high);
        field->setNumberFormat({}, u" h"_s);
        field->showValue(value);
        auto* caption = new CaptionLabel(label);
        caption->setWordWrap(false);
        caption->setBuddy(field);
        auto* pair = new QVBoxLayout;
        pair->setSpacing(1);
        pair->addWidget(caption);
        pair->addWidget(withRemark(field));
        row->addLayout(pair);
        return field;
    };
    m_span = number(u"startSpan"_s, tr("Starts within"), 0, kLongestSpan_h, kUsualSpan_h);
    m_span->setToolTip(tr("Latest start after the start of the scenario"));
    m_every =
        number(u"startEvery"_s, tr("One every"), kShortestEvery_h, kLongestSpan_h, kUsualEvery_h);
    m_compare = new QPushButton;
    m_compare->setObjectName(u"compareStarts"_s);
    m_bar = new QProgressBar;
    m_bar->setObjectName(u"startProgress"_s);
    m_bar->setAccessibleName(tr("Progress of the comparison"));
    m_bar->setTextVisible(false);
    m_bar->setFixedHeight(kStartBar_px);
    m_use = new QPushButton(tr("Use this start"));
    m_use->setObjectName(u"useStart"_s);
    row->addWidget(m_compare, 0, Qt::AlignBottom);
    row->addWidget(m_bar, 1, Qt::AlignBottom);
    row->addWidget(m_use, 0, Qt::AlignBottom);
}

void StartPanel::setTheme(const Theme& theme)
{
    setCaptionTheme(*this, theme);
    m_chart->setTheme(theme);
    QPalette colours = m_bar->palette();
    colours.setColor(QPalette::Highlight, theme.plan);
    m_bar->setPalette(colours);
}

StartScanSpec StartPanel::spec() const
{
    constexpr double kHour_s = 3600;
    return {.every_s = kHour_s * m_every->value(), .span_s = kHour_s * m_span->value()};
}

bool StartPanel::isCurrent() const
{
    return m_runner.scan() && m_document.scenario() == m_runner.scenario();
}

void StartPanel::compareOrCancel()
{
    m_wasCancelled = m_runner.isRunning();
    if (m_wasCancelled) {
        m_runner.cancel();
        m_compare->setEnabled(false); // until it has ended
        return;
    }
    m_runner.start(m_document.scenario(), spec());
}

void StartPanel::showProgress(qulonglong done, qulonglong count)
{
    m_bar->setRange(0, static_cast<int>(count));
    m_bar->setValue(static_cast<int>(done));
    m_state->setText(tr("Flying the scenario from each start: %1 of %2", "starts done, all")
                         .arg(locale().toString(done), locale().toString(count)));
}

void StartPanel::showEnd(const QString& failure)
{
    m_failure = failure;
    const std::optional<StartScan>& scan = m_runner.scan();
    m_chart->setScan(scan, m_runner.isRunning());
    if (scan)
        m_chart->setChosen(scan->best);
    showState();
    if (!m_runner.isRunning())
        m_wasCancelled = false;
}

void StartPanel::showChosen()
{
    const std::optional<std::size_t> chosen = m_chart->chosen();
    const std::optional<StartScan>& scan = m_runner.scan();
    m_use->setEnabled(isCurrent() && chosen && *chosen > 0 && !m_document.isLocked());
    if (!scan || !chosen)
        return;
    const StartOutcome& start = scan->starts[*chosen];
    const QString zeta =
        start.zeta_m2s ? zetaText(*start.zeta_m2s, locale()) : tr("cannot be flown");
    Scenario at = m_runner.scenario();
    at.startUtc = start.startUtc;
    m_state->setText(
        tr("%1 UTC: ζ %2. %3", "start, zeta, weather")
            .arg(startName(*scan, *chosen), zeta, weatherText(at, start.weather, locale())));
}

void StartPanel::showState()
{
    const bool isRunning = m_runner.isRunning();
    const bool hasStart = startTime(m_document.scenario()).has_value();
    m_compare->setText(isRunning ? tr("Cancel") : tr("Compare"));
    m_compare->setEnabled(isRunning || hasStart);
    for (NumberField* field : {m_span, m_every})
        field->setEnabled(!isRunning);
    m_bar->setVisible(isRunning);
    m_use->setEnabled(false);
    if (isRunning)
        m_state->setText(tr("Flying the scenario from each start…"));
    else if (!m_failure.isEmpty())
        m_state->setText(m_failure);
    else if (m_wasCancelled)
        m_state->setText(tr("Cancelled."));
    else if (!hasStart)
        m_state->setText(tr("The scenario has no start time. Set Start (UTC) in the Inspector."));
    else if (!m_runner.scan())
        m_state->setText(tr("Icebergs drift on unseen until a later start, so their estimates are "
                            "older."));
    else if (!isCurrent())
        m_state->setText(tr("The scenario has changed since. Compare again."));
    else if (!m_chart->chosen())
        m_state->setText(tr("No start has weather within all limits. Choose a bar to see why."));
    else
        showChosen();
}

void StartPanel::useChosen()
{
    const std::optional<std::size_t> chosen = m_chart->chosen();
    if (!chosen || !isCurrent())
        return;
    const double delay_s = m_runner.scan()->starts[*chosen].delay_s;
    const QString name = startName(*m_runner.scan(), *chosen);
    m_document.edit(tr("Start at %1 UTC").arg(name),
                    [delay_s](Scenario& scenario) { scenario = startingLater(scenario, delay_s); });
}

} // namespace berg
