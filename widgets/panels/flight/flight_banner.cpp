#include "widgets/panels/flight/flight_banner.h"

#include "widgets/theme/icons.h"
#include "widgets/theme/quantity_text.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kEdge_px = 12;
constexpr int kIcon_px = 16;
constexpr int kLineGap_px = 3;
constexpr double kRadius_px = 6;

} // namespace

FlightBanner::FlightBanner(QWidget* parent) : QWidget(parent)
{
    setObjectName(u"flightBanner"_s);
    setCursor(Qt::ArrowCursor);
    m_column = new QVBoxLayout(this);
    m_column->setContentsMargins(10, 5, 5, 5);
    m_column->setSpacing(kLineGap_px);
    setAttribute(Qt::WA_NoMousePropagation); // a click between the buttons is none on the map
    addGivenUpLine();
    m_state = new QWidget;
    m_column->addWidget(m_state);
    auto* row = new QHBoxLayout(m_state);
    row->setContentsMargins(0, 0, 0, 0);
    m_icon = new QLabel;
    m_text = new QLabel;
    m_stop = addButton(*m_state, u"stopAndEditButton"_s, tr("Stop and edit"),
                       tr("Ends the flight and goes back to the start, where everything can be "
                          "edited."));
    row->addWidget(m_icon);
    row->addWidget(m_text, 1);
    row->addSpacing(6);
    m_flyOn = addButton(*m_state, u"flyOnButton"_s, tr("Continue from here"),
                        tr("Gives up what was flown after this instant. From here the trade-off "
                           "and the policy can be changed and another path flown."));
    m_newest = addButton(*m_state, u"newestButton"_s, tr("Newest"),
                         tr("Back to the end of what is flown."));
    m_checks = addButton(*m_state, u"showChecksButton"_s, tr("Checks"),
                         tr("Lists everything that is found about the scenario."));
    connect(m_stop, &QPushButton::clicked, this, &FlightBanner::stopRequested);
    connect(m_flyOn, &QPushButton::clicked, this, &FlightBanner::flyOnRequested);
    connect(m_newest, &QPushButton::clicked, this, &FlightBanner::newestRequested);
    connect(m_checks, &QPushButton::clicked, this, &FlightBanner::checksRequested);
    parent->installEventFilter(this);
    setTheme(m_theme);
    showState(false, {});
}

void FlightBanner::addGivenUpLine()
{
    m_givenUp = new QWidget;
    auto* row = new QHBoxLayout(m_givenUp);
    row->setContentsMargins(0, 0, 0, 0);
    m_givenUpText = new QLabel;
    m_givenUpText->setObjectName(u"givenUpText"_s);
    row->addWidget(m_givenUpText, 1);
    row->addSpacing(6);
    QPushButton* back = addButton(*m_givenUp, u"bringBackButton"_s, tr("Bring it back"),
                                  tr("Takes up the flight where it was left."));
    connect(back, &QPushButton::clicked, this, &FlightBanner::bringBackRequested);
    m_givenUp->hide();
    m_column->addWidget(m_givenUp);
}

QPushButton* FlightBanner::addButton(QWidget& row, const QString& name, const QString& text,
                                     const QString& toolTip)
{
    auto* button = new QPushButton(text);
    button->setObjectName(name);
    button->setToolTip(toolTip);
    button->setFocusPolicy(Qt::TabFocus);
    row.layout()->addWidget(button);
    return button;
}

void FlightBanner::setTheme(const Theme& theme)
{
    m_theme = theme;
    m_icon->setPixmap(
        icon(m_iconName, theme).pixmap(QSize(kIcon_px, kIcon_px), devicePixelRatioF()));
    m_text->setFont(theme.body());
    m_givenUpText->setFont(theme.body());
    fillNotices();
    place();
    update();
}

void FlightBanner::setIcon(IconName name)
{
    if (name == m_iconName)
        return;
    m_iconName = name;
    setTheme(m_theme);
}

void FlightBanner::showState(bool inFlight, std::optional<double> lookBack_s, const QString& fault)
{
    const bool looksBack = inFlight && lookBack_s.has_value();
    m_fault = inFlight ? QString() : fault;
    setIcon(!m_fault.isEmpty() ? IconName::Fault : looksBack ? IconName::Reset : IconName::Locked);
    m_text->setText(looksBack ? tr("Looking back at %1").arg(clockText(*lookBack_s))
                              : tr("Scenario locked in flight"));
    m_text->setToolTip(
        looksBack ? QString()
                  : tr("τ and policy can be changed while flying; the plan follows at once."));
    m_stop->setVisible(inFlight && !looksBack);
    m_flyOn->setVisible(looksBack);
    m_newest->setVisible(looksBack);
    m_checks->setVisible(!m_fault.isEmpty());
    m_hasState = inFlight || !m_fault.isEmpty();
    m_state->setVisible(m_hasState);
    showOrHide();
}

void FlightBanner::showOrHide()
{
    setVisible(m_hasState || m_hasGivenUp || !m_notices.empty());
    place();
}

void FlightBanner::showGivenUp(const QString& text)
{
    m_hasGivenUp = !text.isEmpty();
    m_givenUpText->setText(text);
    m_givenUp->setVisible(m_hasGivenUp);
    showOrHide();
}

void FlightBanner::showNotices(const std::vector<FlightNotice>& notices)
{
    if (notices == m_notices)
        return;
    m_notices = notices;
    fillNotices();
    showOrHide();
}

FlightBanner::NoticeLine FlightBanner::addNoticeLine()
{
    const NoticeLine added{.line = new QWidget, .icon = new QLabel, .text = new QLabel};
    auto* row = new QHBoxLayout(added.line);
    row->setContentsMargins(0, 0, 5, 0);
    row->addWidget(added.icon);
    row->addWidget(added.text, 1);
    added.text->setObjectName(u"flightNotice%1"_s.arg(m_noticeLines.size() + 1));
    m_column->insertWidget(static_cast<int>(m_noticeLines.size()), added.line);
    return added;
}

void FlightBanner::fillNotices()
{
    while (m_noticeLines.size() < m_notices.size())
        m_noticeLines.push_back(addNoticeLine());
    for (std::size_t i = 0; i < m_noticeLines.size(); ++i) {
        const NoticeLine& shown = m_noticeLines[i];
        shown.line->setVisible(i < m_notices.size());
        if (i >= m_notices.size())
            continue;
        const FlightNotice& notice = m_notices[i];
        shown.icon->setPixmap(
            icon(notice.icon, m_theme).pixmap(QSize(kIcon_px, kIcon_px), devicePixelRatioF()));
        shown.text->setFont(m_theme.body());
        shown.text->setText(notice.text);
        shown.text->setToolTip(notice.toolTip);
    }
}

/** As much of the reason as the map has room for; all of it is in the tool tip. */
void FlightBanner::elideFault()
{
    const int beside_px = width() - m_text->width();
    m_text->setToolTip(m_fault);
    m_text->setText(m_text->fontMetrics().elidedText(
        tr("Cannot be planned: %1").arg(m_fault), Qt::ElideRight,
        std::max(0, parentWidget()->width() - beside_px - 2 * kEdge_px)));
}

/** Also when texts have changed just now, which the layouts within do not know yet. */
void FlightBanner::fitToTexts()
{
    for (const NoticeLine& shown : m_noticeLines)
        shown.line->layout()->activate();
    m_givenUp->layout()->activate();
    m_state->layout()->activate();
    adjustSize();
}

void FlightBanner::place()
{
    fitToTexts();
    if (!m_fault.isEmpty()) {
        elideFault();
        fitToTexts();
    }
    const QSize map = parentWidget()->size();
    move(std::max(0, (map.width() - width()) / 2), map.height() - height() - kEdge_px);
}

bool FlightBanner::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        place();
    return QWidget::eventFilter(watched, event);
}

void FlightBanner::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(m_theme.panelLine, 1));
    painter.setBrush(m_theme.chart); // opaque: map labels must not shine through the words
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), kRadius_px, kRadius_px);
}

} // namespace berg
