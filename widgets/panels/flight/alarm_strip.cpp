#include "widgets/panels/flight/alarm_strip.h"

#include "widgets/theme/icons.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyleHints>
#include <QToolButton>

#include <algorithm>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr std::size_t kMostLines = 3; // more would hide the map
constexpr int kIcon_px = 16;
constexpr int kEdge_px = 5;
constexpr int kMargin_px = 8;
constexpr double kTint = 0.14; // share of the rank's colour in the ground of a line

QColor colourOf(NoticeRank rank, const Theme& theme)
{
    switch (rank) {
    case NoticeRank::Alarm:
        return theme.alarm;
    case NoticeRank::Warning:
        return theme.warning;
    case NoticeRank::Note:
        return theme.panelLine;
    }
    return {};
}

IconName iconOf(NoticeRank rank)
{
    return rank == NoticeRank::Note ? IconName::Hint : IconName::Warning;
}

void setGround(QWidget& widget, const QColor& colour)
{
    QPalette palette = widget.palette();
    palette.setColor(QPalette::Window, colour);
    widget.setPalette(palette);
    widget.setAutoFillBackground(true);
}

QHBoxLayout* addRow(QWidget& line)
{
    auto* row = new QHBoxLayout(&line);
    row->setContentsMargins(0, 1, kMargin_px, 1);
    row->setSpacing(6);
    return row;
}

QPushButton* addButton(QBoxLayout& row, const QString& name, const QString& text,
                       const QString& toolTip)
{
    auto* button = new QPushButton(text);
    button->setObjectName(name);
    button->setToolTip(toolTip);
    button->setFocusPolicy(Qt::TabFocus); // a click leaves the keyboard with the map
    row.addWidget(button);
    return button;
}

QStringList textsOf(const std::vector<FlightNotice>& notices)
{
    QStringList texts;
    for (const FlightNotice& notice : notices)
        texts << notice.text;
    return texts;
}

/** Returns the keys of an acknowledgement. */
std::set<std::string> subjectsOf(const FlightNotice& notice)
{
    if (!notice.subject.empty())
        return {notice.subject};
    std::set<std::string> ids(notice.about.begin(), notice.about.end());
    if (ids.empty())
        ids.insert({}); // a notice about the whole flight
    return ids;
}

} // namespace

AlarmStrip::AlarmStrip(QWidget* parent) : QWidget(parent), m_column(new QVBoxLayout(this))
{
    setObjectName(u"alarmStrip"_s);
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->setSpacing(1);
    while (m_lines.size() < kMostLines)
        addNoticeLine();
    addStateLine();
    addDiscardedLine();
    m_pause.setSingleShot(true);
    connect(&m_pause, &QTimer::timeout, this, &AlarmStrip::fillNotices);
    setTheme(m_theme);
    showOrHide();
}

void AlarmStrip::addNoticeLine()
{
    const std::size_t place = m_lines.size();
    NoticeLine added{.line = new QWidget,
                     .edge = new QWidget,
                     .text = new QToolButton,
                     .more = new QLabel,
                     .acknowledge = nullptr};
    QHBoxLayout* row = addRow(*added.line);
    added.edge->setFixedWidth(kEdge_px);
    row->addWidget(added.edge);
    added.text->setObjectName(u"flightNotice%1"_s.arg(place + 1));
    added.text->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    added.text->setIconSize({kIcon_px, kIcon_px});
    added.text->setAutoRaise(true);
    added.text->setFocusPolicy(Qt::TabFocus);
    added.text->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    row->addWidget(added.text, 1);
    row->addWidget(added.more);
    added.acknowledge =
        addButton(*row, u"acknowledge%1"_s.arg(place + 1), tr("Acknowledge"),
                  tr("Removes this notice. It returns if the condition ends and occurs again."));
    connect(added.text, &QToolButton::clicked, this,
            [this, place] { emit noticeChosen(m_open[place].about); });
    connect(added.acknowledge, &QPushButton::clicked, this, [this, place] { acknowledge(place); });
    m_column->addWidget(added.line);
    m_lines.push_back(added);
}

void AlarmStrip::addStateLine()
{
    m_state = new QWidget;
    QHBoxLayout* row = addRow(*m_state);
    row->addSpacing(kEdge_px);
    m_icon = new QLabel;
    m_text = new QLabel;
    m_text->setObjectName(u"flightState"_s);
    m_text->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    row->addWidget(m_icon);
    row->addWidget(m_text, 1);
    m_continue = addButton(*row, u"flyOnButton"_s, tr("Continue from here"),
                           tr("Discards the flight after this instant. From here you can change "
                              "the trade-off and the policy and fly another path."));
    m_newest = addButton(*row, u"newestButton"_s, tr("Back to latest"),
                         tr("Goes to the latest instant of the flight."));
    m_checks = addButton(*row, u"showChecksButton"_s, tr("Checks"),
                         tr("Lists all findings in the scenario."));
    connect(m_continue, &QPushButton::clicked, this, &AlarmStrip::continueRequested);
    connect(m_newest, &QPushButton::clicked, this, &AlarmStrip::newestRequested);
    connect(m_checks, &QPushButton::clicked, this, &AlarmStrip::checksRequested);
    m_column->addWidget(m_state);
}

/** The button is on the left, away from the place where a double click may still land. */
void AlarmStrip::addDiscardedLine()
{
    m_discarded = new QWidget;
    QHBoxLayout* row = addRow(*m_discarded);
    row->addSpacing(kEdge_px);
    m_discardedText = new QLabel;
    m_discardedText->setObjectName(u"givenUpText"_s);
    row->addWidget(m_discardedText);
    const QPushButton* back = addButton(*row, u"bringBackButton"_s, tr("Restore"),
                                        tr("Continues the flight where it was left."));
    connect(back, &QPushButton::clicked, this, &AlarmStrip::restoreRequested);
    row->addStretch(1);
    m_discarded->hide();
    m_column->addWidget(m_discarded);
}

void AlarmStrip::setTheme(const Theme& theme)
{
    m_theme = theme;
    setGround(*this, theme.panel);
    m_text->setFont(theme.body());
    m_discardedText->setFont(theme.body());
    // Equal heights, so that lines that come and go do not move the map.
    const int height_px = m_continue->sizeHint().height() + 2;
    for (QWidget* line : {m_state, m_discarded})
        line->setFixedHeight(height_px);
    for (const NoticeLine& line : m_lines)
        line.line->setFixedHeight(height_px);
    fillNotices();
    fillState();
}

int AlarmStrip::lineHeight() const
{
    return m_state->minimumHeight();
}

void AlarmStrip::showState(bool inFlight, std::optional<double> lookBack_s, const QString& fault)
{
    m_isInFlight = inFlight;
    m_lookBack_s = inFlight ? lookBack_s : std::nullopt;
    m_fault = inFlight ? QString() : fault;
    fillState();
    showOrHide();
}

void AlarmStrip::setClock(const MissionClock& clock)
{
    if (clock == m_clock)
        return;
    m_clock = clock;
    fillState();
}

void AlarmStrip::fillState()
{
    const bool looksBack = m_lookBack_s.has_value();
    const bool isKnown = !m_notices.empty(); // acknowledged, but not over
    const IconName sign = !m_fault.isEmpty()         ? IconName::Fault
                          : looksBack                ? IconName::Reset
                          : isKnown || !m_isInFlight ? IconName::Hint
                                                     : IconName::Proven;
    m_icon->setPixmap(icon(sign, m_theme).pixmap(QSize(kIcon_px, kIcon_px), devicePixelRatioF()));
    QString text = isKnown        ? tr("Acknowledged: %1").arg(textsOf(m_notices).join(u" · "_s))
                   : m_isInFlight ? tr("No alarms")
                                  : tr("Not in flight");
    if (!m_fault.isEmpty()) // as much as there is room for
        text = m_text->fontMetrics().elidedText(tr("Cannot be planned: %1").arg(m_fault),
                                                Qt::ElideRight, m_text->width());
    else if (looksBack)
        text = tr("Looking back at %1").arg(m_clock.text(*m_lookBack_s));
    if (text != m_text->text())
        m_text->setText(text);
    m_text->setToolTip(looksBack ? m_clock.details(*m_lookBack_s) : m_fault);
    m_continue->setVisible(looksBack);
    m_newest->setVisible(looksBack);
    m_checks->setVisible(!m_fault.isEmpty());
}

void AlarmStrip::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    m_state->layout()->activate();
    fillState();
}

void AlarmStrip::showOrHide()
{
    const bool isQuiet = m_open.empty() && m_discarded->isHidden();
    m_state->setVisible(!m_fault.isEmpty() || m_lookBack_s || isQuiet);
}

void AlarmStrip::showDiscardedFlight(const QString& text)
{
    m_discardedText->setText(text);
    m_discarded->setVisible(!text.isEmpty());
    showOrHide();
}

void AlarmStrip::showNotices(const std::vector<FlightNotice>& notices)
{
    const bool isNew = notices != m_notices;
    m_notices = notices;
    if (!m_lookBack_s)
        dropEndedAcknowledgements();
    if (isNew) {
        fillNotices();
        fillState();
        showOrHide();
    }
    if (!m_lookBack_s)
        reportNewNotices();
}

/** Forgets acknowledgements of notices that have ended, so that new ones are shown. */
void AlarmStrip::dropEndedAcknowledgements()
{
    for (auto& [kind, ids] : m_acknowledged) {
        std::set<std::string> still;
        for (const FlightNotice& notice : m_notices)
            if (notice.kind == kind)
                still.merge(subjectsOf(notice));
        std::erase_if(ids, [&](const std::string& id) { return !still.contains(id); });
    }
}

void AlarmStrip::reportNewNotices()
{
    const std::vector<FlightNotice> before = std::exchange(m_reported, m_notices);
    for (const FlightNotice& notice : m_reported)
        if (rankOf(notice.kind) != NoticeRank::Note &&
            std::ranges::none_of(before, [&](const FlightNotice& known) {
                return known.kind == notice.kind && known.about == notice.about &&
                       known.subject == notice.subject;
            }))
            emit raised(notice.text);
}

void AlarmStrip::takeOver(const AlarmStrip& other)
{
    m_reported = other.m_reported;
    m_acknowledged = other.m_acknowledged;
    fillNotices();
    fillState();
    showOrHide();
}

void AlarmStrip::acknowledge(std::size_t line)
{
    const FlightNotice& notice = m_open[line];
    m_acknowledged[notice.kind].merge(subjectsOf(notice));
    m_pause.start(QApplication::styleHints()->mouseDoubleClickInterval());
    fillNotices();
    fillState();
    showOrHide();
}

void AlarmStrip::fillNotices()
{
    m_open.clear();
    for (const FlightNotice& notice : m_notices)
        if (!std::ranges::includes(m_acknowledged[notice.kind], subjectsOf(notice)))
            m_open.push_back(notice);
    std::ranges::stable_sort(m_open, {},
                             [](const FlightNotice& notice) { return rankOf(notice.kind); });
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        m_lines[i].line->setVisible(i < m_open.size());
        m_lines[i].more->hide();
        if (i < m_open.size())
            fill(m_lines[i], m_open[i]);
    }
    if (!m_lookBack_s)
        emit alarmPending(std::ranges::any_of(m_open, [](const FlightNotice& notice) {
            return rankOf(notice.kind) == NoticeRank::Alarm;
        }));
    if (m_open.size() <= m_lines.size())
        return;
    QStringList rest;
    for (std::size_t i = m_lines.size(); i < m_open.size(); ++i)
        rest << m_open[i].text;
    QLabel& more = *m_lines.back().more;
    more.setText(tr("%n more", nullptr, static_cast<int>(rest.size())));
    more.setToolTip(rest.join(u'\n'));
    more.show();
}

void AlarmStrip::fill(const NoticeLine& line, const FlightNotice& notice)
{
    const NoticeRank rank = rankOf(notice.kind);
    const QColor colour = colourOf(rank, m_theme);
    setGround(*line.edge, colour);
    setGround(*line.line,
              rank == NoticeRank::Note ? m_theme.panel : mixed(m_theme.panel, colour, kTint));
    line.text->setIcon(icon(iconOf(rank), m_theme));
    line.text->setFont(rank == NoticeRank::Alarm ? m_theme.strong() : m_theme.body());
    line.more->setFont(m_theme.body());
    line.text->setText(QString(notice.text).replace(u'&', u"&&"_s));
    const QString all = notice.toolTip.isEmpty() ? notice.text : notice.toolTip;
    line.text->setToolTip(notice.about.empty() ? all
                                               : all + u'\n' + tr("Click to show it on the map."));
    line.acknowledge->setVisible(rank != NoticeRank::Note);
    line.acknowledge->setEnabled(!m_pause.isActive());
}

} // namespace berg
