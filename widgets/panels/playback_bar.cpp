#include "widgets/panels/playback_bar.h"

#include "widgets/panels/panel_labels.h"
#include "widgets/panels/run_progress.h"
#include "widgets/panels/wheel_guard.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/quantity_text.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QToolButton>

#include <array>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr std::array<double, 8> kRates = {1, 2, 5, 10, 20, 50, 100, 0};
constexpr double kFirstRate = 10;
constexpr int kIcon_px = 20;
constexpr int kMarginX_px = 8;
constexpr int kMarginY_px = 3;

void setAction(QToolButton& button, const QString& text, const QString& toolTip)
{
    button.setAccessibleName(text);
    button.setToolTip(toolTip);
}

} // namespace

PlaybackBar::PlaybackBar(QWidget* parent) : QWidget(parent)
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(kMarginX_px, kMarginY_px, kMarginX_px, kMarginY_px);
    row->setSpacing(4);
    m_play = addButton(u"playButton"_s, tr("Fly"));
    m_step = addButton(u"stepButton"_s, tr("Step"));
    m_reset = addButton(u"resetButton"_s, tr("Reset"));
    m_rate = new QComboBox(this);
    addRates();
    row->addWidget(m_rate);
    row->addSpacing(4);
    m_progress = new RunProgress(this);
    m_progress->setObjectName(u"runProgress"_s);
    m_progress->setAccessibleName(tr("Part of the run flown"));
    row->addWidget(m_progress, 1);
    row->addSpacing(4);
    m_time = new FigureLabel(this);
    m_time->setObjectName(u"runTime"_s);
    m_time->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_time->setToolTip(tr("Time flown and length of the run"));
    row->addWidget(m_time);

    connect(m_play, &QToolButton::clicked, this, [this] {
        if (m_phase == RunPhase::Flying)
            emit pauseRequested();
        else
            emit playRequested();
    });
    connect(m_step, &QToolButton::clicked, this, &PlaybackBar::stepRequested);
    connect(m_reset, &QToolButton::clicked, this, &PlaybackBar::resetRequested);
    connect(m_rate, &QComboBox::activated, this, [this] { emit rateEdited(rate()); });
    setTheme(m_theme);
    showState(RunPhase::Planning, 0, 0);
}

QToolButton* PlaybackBar::addButton(const QString& name, const QString& text)
{
    auto* button = new QToolButton(this);
    button->setObjectName(name);
    button->setAccessibleName(text);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setIconSize(QSize(kIcon_px, kIcon_px));
    layout()->addWidget(button);
    return button;
}

void PlaybackBar::addRates()
{
    m_rate->setObjectName(u"rateCombo"_s);
    m_rate->setAccessibleName(tr("Rate of the flight"));
    m_rate->setToolTip(tr("Simulated seconds flown in one second"));
    m_rate->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_rate->setMinimumContentsLength(4);
    m_rate->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    guardWheel(*m_rate);
    for (const double rate : kRates)
        m_rate->addItem(rate > 0 ? tr("%1×").arg(fixedText(rate, 0, locale()))
                                 : tr("As fast as possible"),
                        rate);
    setRate(kFirstRate);
}

void PlaybackBar::setTheme(const Theme& theme)
{
    m_theme = theme;
    m_step->setIcon(icon(IconName::Step, theme));
    m_reset->setIcon(icon(IconName::Reset, theme));
    m_progress->setTheme(theme);
    m_time->setFont(theme.body());
    m_rate->setFont(theme.body());
    updateButtons();
}

double PlaybackBar::rate() const
{
    return m_rate->currentData().toDouble();
}

void PlaybackBar::setRate(double rate)
{
    std::size_t nearest = kRates.size() - 1;
    if (rate > 0)
        for (std::size_t i = 0; i < kRates.size(); ++i)
            if (kRates[i] > 0 && (kRates[nearest] == 0 ||
                                  std::abs(kRates[i] - rate) < std::abs(kRates[nearest] - rate)))
                nearest = i;
    m_rate->setCurrentIndex(static_cast<int>(nearest));
}

void PlaybackBar::showState(RunPhase phase, double time_s, double duration_s)
{
    const QString time = tr("%1 / %2").arg(clockText(time_s), clockText(duration_s));
    if (time != m_time->text()) {
        m_time->setText(time);
        m_progress->showTime(time_s, duration_s);
    }
    if (phase == m_phase)
        return;
    m_phase = phase;
    updateButtons();
}

void PlaybackBar::updateButtons()
{
    const bool flying = m_phase == RunPhase::Flying;
    const bool finished = m_phase == RunPhase::Finished;
    const bool canStep = flying || m_phase == RunPhase::Ready || m_phase == RunPhase::Paused;
    m_play->setIcon(icon(flying ? IconName::Pause : IconName::Play, m_theme));
    m_play->setEnabled(canStep || finished);
    m_step->setEnabled(canStep);
    m_reset->setEnabled(flying || m_phase == RunPhase::Paused || finished);

    QString whyNot;
    if (m_phase == RunPhase::Planning)
        whyNot = tr("The plan is still being made.");
    else if (m_phase == RunPhase::Failed)
        whyNot = tr("This scenario cannot be flown. Correct what is reported first.");
    else if (finished)
        whyNot = tr("The run has ended.");
    QString playTip = whyNot;
    if (finished)
        playTip = tr("Fly again from the start (Space)");
    else if (canStep)
        playTip = flying ? tr("Pause the flight (Space)") : tr("Fly the plan (Space)");
    setAction(*m_play, flying ? tr("Pause") : tr("Fly"), playTip);
    setAction(*m_step, tr("Step"), canStep ? tr("Fly one second and pause") : whyNot);
    setAction(*m_reset, tr("Reset"), tr("Back to the start, where everything can be edited"));
}

} // namespace berg
