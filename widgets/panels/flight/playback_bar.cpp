#include "widgets/panels/flight/playback_bar.h"

#include "widgets/panels/fields/panel_labels.h"
#include "widgets/panels/fields/wheel_guard.h"
#include "widgets/panels/flight/run_time_line.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/time_entry.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QStatusTipEvent>
#include <QToolButton>

#include <algorithm>
#include <array>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr std::array<double, 13> kRates = {0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000};
constexpr double kFirstRate = 10;
constexpr int kIcon_px = 20;
constexpr int kLock_px = 14;
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
    m_reset = addButton(u"resetButton"_s, tr("Stop and edit"));
    m_rate = new QComboBox(this);
    addRates();
    row->addWidget(m_rate);
    addLock();
    m_timeLine = new RunTimeLine(this);
    m_timeLine->setObjectName(u"timeLine"_s);
    m_timeLine->setAccessibleName(tr("Time line of the run"));
    row->addWidget(m_timeLine, 1);
    m_time = new QLineEdit(this);
    m_time->setObjectName(u"timeField"_s);
    m_time->setAccessibleName(tr("Time shown"));
    m_time->setFrame(false);
    m_time->setAlignment(Qt::AlignRight);
    row->addWidget(m_time);
    m_length = new FigureLabel(this);
    m_length->setObjectName(u"runLength"_s);
    row->addWidget(m_length);

    connect(m_play, &QToolButton::clicked, this, [this] {
        if (m_phase == RunPhase::Flying)
            emit pauseRequested();
        else
            emit playRequested();
    });
    connect(m_step, &QToolButton::clicked, this, &PlaybackBar::stepRequested);
    connect(m_reset, &QToolButton::clicked, this, &PlaybackBar::resetRequested);
    connect(m_rate, &QComboBox::activated, this, [this] { emit rateEdited(rate()); });
    connect(m_timeLine, &RunTimeLine::scrubbed, this, &PlaybackBar::timeEdited);
    connect(m_time, &QLineEdit::editingFinished, this, &PlaybackBar::finishTime);
    // Then keys control the flight again.
    connect(m_time, &QLineEdit::returnPressed, m_timeLine, qOverload<>(&QWidget::setFocus));
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

/** Its place is reserved while it is hidden, so that the time line does not move at take-off. */
void PlaybackBar::addLock()
{
    m_lock = addButton(u"lockButton"_s, tr("Scenario locked"));
    QSizePolicy policy = m_lock->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    m_lock->setSizePolicy(policy);
    m_lock->setIconSize({kLock_px, kLock_px});
    m_lock->setFixedWidth(kLock_px + 6);
    auto* menu = new QMenu(m_lock);
    menu->addAction(tr("Stop and edit"), this, &PlaybackBar::resetRequested);
    m_lock->setMenu(menu);
    m_lock->setPopupMode(QToolButton::InstantPopup);
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
    m_rate->setFocusPolicy(Qt::TabFocus); // a choice by mouse leaves the keyboard where it was
    for (const double rate : kRates)
        m_rate->addItem(tr("%1×").arg(fixedText(rate, rate < 1 ? 1 : 0, locale())), rate);
    m_rate->addItem(tr("Fastest"));
    setRate(kFirstRate);
}

void PlaybackBar::setTheme(const Theme& theme)
{
    m_theme = theme;
    m_step->setIcon(icon(IconName::Step, theme));
    m_reset->setIcon(icon(IconName::Reset, theme));
    m_timeLine->setTheme(theme);
    m_time->setFont(theme.body());
    m_length->setFont(theme.body());
    m_rate->setFont(theme.body());
    showTexts();
    updateButtons();
}

FlightRate PlaybackBar::rate() const
{
    const QVariant rate = m_rate->currentData();
    return rate.isValid() ? FlightRate(rate.toDouble()) : kFastestRate;
}

void PlaybackBar::setRate(FlightRate rate)
{
    const auto nearest =
        rate ? std::ranges::min_element(
                   kRates, {}, [rate](double offered) { return std::abs(offered - *rate); })
             : kRates.end();
    m_rate->setCurrentIndex(static_cast<int>(nearest - kRates.begin()));
}

void PlaybackBar::stepRate(int steps)
{
    const int index = std::clamp(m_rate->currentIndex() + steps, 0, m_rate->count() - 1);
    m_rate->setCurrentIndex(index);
    emit rateEdited(rate());
}

void PlaybackBar::editTime()
{
    m_time->setFocus(Qt::ShortcutFocusReason);
    m_time->selectAll();
}

void PlaybackBar::finishTime()
{
    const std::optional<double> time_s = readInstant(m_time->text(), m_clock, m_time_s);
    const bool isNew = m_time->isModified() && time_s.has_value();
    if (m_time->isModified() && !time_s) {
        const QString fault =
            m_clock.start
                ? tr("\"%1\" is not a time of this run. Type it like 1215Z, 3:20 or 45 min.")
                : tr("\"%1\" is not a time. Type it like 3:20 or 45 min.");
        QStatusTipEvent said(fault.arg(m_time->text().trimmed()));
        QCoreApplication::sendEvent(window(), &said);
    }
    m_time->setModified(false);
    showTexts(); // until the snapshot of that time arrives
    if (isNew)
        emit timeEdited(*time_s);
}

/** Receives the keys that the time field does not use. */
void PlaybackBar::keyPressEvent(QKeyEvent* event)
{
    if (event->key() != Qt::Key_Escape || focusWidget() != m_time)
        return QWidget::keyPressEvent(event);
    m_time->setModified(false); // discards the typed text
    showTexts();
    m_timeLine->setFocus();
}

void PlaybackBar::showState(RunPhase phase, double time_s, double duration_s,
                            std::optional<double> newest_s)
{
    m_timeLine->showTime(time_s, newest_s.value_or(time_s), duration_s);
    m_time_s = time_s;
    m_duration_s = duration_s;
    showTexts();
    if (phase == m_phase)
        return;
    m_phase = phase;
    updateButtons();
}

void PlaybackBar::setClock(const MissionClock& clock)
{
    if (clock == m_clock)
        return;
    m_clock = clock;
    m_timeLine->setClock(clock);
    showTexts();
}

/** Shows the time, unless one is being typed, and the length of the run. */
void PlaybackBar::showTexts()
{
    const QString time = m_clock.text(m_time_s);
    if (!m_time->isModified() && m_time->text() != time)
        m_time->setText(time);
    const QString length = u"/ %1"_s.arg(m_clock.text(m_duration_s));
    if (length != m_length->text())
        showValue(*m_length, length);
    const QFontMetrics metrics(m_theme.body());
    const bool isUtc = m_clock.isUtc();
    const QString widest = m_clock.text(m_duration_s); // the latest day has the widest text
    m_time->setMinimumWidth(metrics.horizontalAdvance(isUtc ? widest : u"00:00"_s) + 4);
    m_time->setMaximumWidth(isUtc ? m_time->minimumWidth() + metrics.averageCharWidth()
                                  : metrics.horizontalAdvance(u"00:00:00 "_s));
    m_time->setToolTip(
        m_clock.start
            ? tr("Time shown. Type a time to look back, e.g. 1215Z, or 3:20 since the start.") +
                  u'\n' + m_clock.details(m_time_s)
            : tr("Time shown. Type a time to look back, e.g. 3:20."));
    m_length->setToolTip(isUtc ? tr("End of the run") + u'\n' + m_clock.details(m_duration_s)
                               : tr("Length of the run"));
    m_length->setAccessibleDescription(isUtc ? tr("End of the run") : tr("Length of the run"));
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

    QString reason;
    if (m_phase == RunPhase::Planning)
        reason = tr("The plan is still being made.");
    else if (m_phase == RunPhase::Failed)
        reason = tr("This scenario cannot be flown. Fix the reported errors first.");
    else if (finished)
        reason = tr("The run has ended.");
    QString playTip = reason;
    if (finished)
        playTip = tr("Fly again from the start (Space)");
    else if (canStep)
        playTip = flying ? tr("Pause the flight (Space)") : tr("Fly the plan (Space)");
    setAction(*m_play, flying ? tr("Pause") : tr("Fly"), playTip);
    setAction(*m_step, tr("Step"), canStep ? tr("Fly one second and pause") : reason);
    setAction(*m_reset, tr("Stop and edit"),
              tr("Ends the flight and goes back to the start, where everything can be edited."));
    m_lock->setIcon(icon(IconName::Locked, m_theme));
    m_lock->setVisible(m_reset->isEnabled());
    m_lock->setToolTip(
        finished ? tr("The run is complete. The scenario stays locked until you stop and edit.")
                 : tr("Scenario locked in flight. τ and policy can be changed while flying; the "
                      "plan follows at once."));
}

} // namespace berg
