#include "widgets/panels/study/study_run_bar.h"

#include "widgets/theme/quantity_text.h"

#include <QBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kGap_px = 6;
constexpr int kBar_px = 6;
constexpr int kBarSteps = 1000;
constexpr int kSecond_ms = 1000;

} // namespace

QString roughTimeText(double time_s, const QLocale& locale)
{
    constexpr double kMinute_s = 60;
    constexpr double kHour_s = 3600;
    if (time_s < 1)
        return StudyRunBar::tr("under a second");
    if (time_s < 1.5 * kMinute_s)
        return StudyRunBar::tr("about %1 s").arg(significantText(time_s, 1, locale));
    if (time_s < 1.5 * kHour_s)
        return StudyRunBar::tr("about %1 min").arg(fixedText(time_s / kMinute_s, 0, locale));
    return StudyRunBar::tr("about %1 h").arg(significantText(time_s / kHour_s, 2, locale));
}

StudyRunBar::StudyRunBar(StudyRunner& runner, QWidget* parent) : QWidget(parent), m_runner(runner)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGap_px);
    m_estimate = new QLabel;
    m_estimate->setObjectName(u"studyEstimate"_s);
    m_estimate->setWordWrap(true);
    m_start = new QPushButton;
    m_start->setObjectName(u"startStudy"_s);
    m_carryOn = new QPushButton(tr("Continue"));
    m_carryOn->setObjectName(u"carryOnStudy"_s);
    m_carryOn->setToolTip(tr("Flies the missing missions of the study shown."));
    m_bar = new QProgressBar;
    m_bar->setObjectName(u"studyProgress"_s);
    m_bar->setAccessibleName(tr("Progress of the study"));
    m_bar->setRange(0, kBarSteps);
    m_bar->setTextVisible(false);
    m_bar->setFixedHeight(kBar_px);
    m_state = new QLabel;
    m_state->setObjectName(u"studyState"_s);
    m_state->setWordWrap(true);
    m_state->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* row = new QHBoxLayout;
    row->setSpacing(kGap_px);
    row->addWidget(m_start, 1);
    row->addWidget(m_carryOn, 1);
    column->addWidget(m_estimate);
    column->addLayout(row);
    column->addWidget(m_bar);
    column->addWidget(m_state);

    m_second.setInterval(kSecond_ms);
    connect(&m_second, &QTimer::timeout, this, &StudyRunBar::showProgress);
    connect(m_start, &QPushButton::clicked, this, &StudyRunBar::startOrCancel);
    connect(m_carryOn, &QPushButton::clicked, &m_runner, &StudyRunner::carryOn);
    connect(&m_runner, &StudyRunner::progress, this, &StudyRunBar::showState);
    connect(&m_runner, &StudyRunner::finished, this, &StudyRunBar::showEnd);
    setTheme(Theme::light());
    showState();
}

void StudyRunBar::setTheme(const Theme& theme)
{
    for (QLabel* label : {m_estimate, m_state})
        label->setFont(theme.small());
    QPalette colours = m_bar->palette();
    colours.setColor(QPalette::Highlight, theme.plan);
    m_bar->setPalette(colours);
}

void StudyRunBar::setSpec(const StudySpec& spec, const QString& fault)
{
    m_fault = fault;
    if (fault.isEmpty()) {
        const auto missions = static_cast<double>(missionCount(spec));
        m_estimate->setText(tr("%1 missions, %2")
                                .arg(fixedText(missions, 0, locale()),
                                     roughTimeText(m_runner.estimated_s(spec), locale())));
    } else {
        m_estimate->setText(fault);
    }
    showState();
}

void StudyRunBar::showNote(const QString& text)
{
    m_note = text;
    showProgress();
}

void StudyRunBar::startOrCancel()
{
    if (!m_runner.isRunning()) {
        emit startRequested();
        return;
    }
    m_cancelled = true;
    m_runner.cancel();
    showState();
}

QString StudyRunBar::flownText() const
{
    const auto number = [this](std::size_t count) {
        return fixedText(static_cast<double>(count), 0, locale());
    };
    return m_runner.isComplete() ? tr("%1 missions flown.").arg(number(m_runner.count()))
                                 : tr("%1 of %2 missions flown.")
                                       .arg(number(m_runner.flown()), number(m_runner.count()));
}

void StudyRunBar::showProgress()
{
    const auto count = static_cast<double>(m_runner.count());
    const double share = count > 0 ? static_cast<double>(m_runner.flown()) / count : 0;
    m_bar->setValue(static_cast<int>(share * kBarSteps));
    if (!m_runner.isRunning()) {
        if (!m_note.isEmpty())
            m_state->setText(m_note);
        else if (count > 0)
            m_state->setText(flownText());
        return;
    }
    const std::optional<double> left_s = m_runner.timeLeft_s();
    m_state->setText(left_s ? flownText() + u' ' + tr("About %1 left.").arg(clockText(*left_s))
                            : flownText());
}

void StudyRunBar::showState()
{
    const bool running = m_runner.isRunning();
    if (running) {
        m_failure.clear();
        m_note.clear();
        if (!m_second.isActive())
            m_second.start();
    } else {
        m_cancelled = false;
        m_second.stop();
    }
    m_start->setText(running ? tr("Stop") : tr("Start study"));
    m_start->setToolTip(running ? tr("The flights so far are kept.") : m_fault);
    m_start->setEnabled(running ? !m_cancelled : m_fault.isEmpty());
    m_carryOn->setVisible(!running && m_runner.count() > 0 && !m_runner.isComplete());
    showProgress();
    if (!m_failure.isEmpty())
        m_state->setText(m_failure);
    m_state->setVisible(!m_state->text().isEmpty());
}

void StudyRunBar::showEnd(const QString& failure)
{
    m_failure = failure;
    showState();
}

} // namespace berg
