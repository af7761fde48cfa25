#include "app/start/tour.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>

#include <algorithm>
#include <array>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kBubble_px = 340;
constexpr int kEdge_px = 14;
constexpr int kSpot_px = 6; ///< the spotlight is so much larger than what it shows
constexpr double kRadius_px = 8;
constexpr int kShade = 130; ///< of 255

} // namespace

Tour::Tour(std::vector<TourStep> steps, const Theme& theme, QWidget* parent)
    : QWidget(parent), m_steps(std::move(steps)), m_theme(theme)
{
    setObjectName(u"tour"_s);
    setFocusPolicy(Qt::StrongFocus);
    makeBubble();
    parent->installEventFilter(this);
    setTheme(theme);
    show();
    go(0);
}

void Tour::makeBubble()
{
    m_bubble = new QWidget(this);
    m_bubble->setFixedWidth(kBubble_px);
    auto* column = new QVBoxLayout(m_bubble);
    column->setContentsMargins(kEdge_px, kEdge_px, kEdge_px, kEdge_px);
    m_title = new QLabel;
    m_title->setObjectName(u"tourTitle"_s);
    m_text = new QLabel;
    m_text->setObjectName(u"tourText"_s);
    m_text->setWordWrap(true);
    column->addWidget(m_title);
    column->addWidget(m_text);
    auto* row = new QHBoxLayout;
    m_count = new QLabel;
    row->addWidget(m_count, 1);
    const auto add = [&](const char* name, const QString& text) {
        auto* button = new QPushButton(text);
        button->setObjectName(QLatin1String(name));
        button->setAutoDefault(true);     // Enter presses it, not only Space
        button->installEventFilter(this); // arrows go through the tour, not through the buttons
        row->addWidget(button);
        return button;
    };
    m_skip = add("tourSkipButton", tr("Skip"));
    m_back = add("tourBackButton", tr("Back"));
    m_next = add("tourNextButton", QString());
    column->addLayout(row);
    connect(m_skip, &QPushButton::clicked, this, &Tour::finished);
    connect(m_back, &QPushButton::clicked, this, &Tour::back);
    connect(m_next, &QPushButton::clicked, this, &Tour::next);
}

void Tour::setTheme(const Theme& theme)
{
    m_theme = theme;
    m_title->setFont(theme.strong());
    m_text->setFont(theme.body());
    m_count->setFont(theme.small());
    QPalette muted = palette();
    muted.setColor(QPalette::WindowText, theme.mutedText);
    m_count->setPalette(muted);
    update();
}

void Tour::go(std::size_t step)
{
    m_step = step;
    const bool last = step + 1 == m_steps.size();
    m_title->setText(m_steps[step].title);
    m_text->setText(m_steps[step].text);
    m_count->setText(tr("%1 of %2").arg(step + 1).arg(m_steps.size()));
    m_back->setVisible(step > 0);
    m_skip->setVisible(!last);
    m_next->setText(last ? tr("Done") : tr("Next"));
    setAccessibleName(m_steps[step].title);
    setAccessibleDescription(m_steps[step].text);
    place();
    m_next->setFocus();
}

void Tour::next()
{
    if (m_step + 1 < m_steps.size())
        go(m_step + 1);
    else
        emit finished();
}

void Tour::back()
{
    if (m_step > 0)
        go(m_step - 1);
}

QRect Tour::spotlight() const
{
    const QPointer<QWidget>& target = m_steps[m_step].target;
    if (target.isNull() || !target->isVisible() || target->visibleRegion().isEmpty())
        return {};
    return QRect(mapFromGlobal(target->mapToGlobal(QPoint(0, 0))), target->size())
        .marginsAdded({kSpot_px, kSpot_px, kSpot_px, kSpot_px})
        .intersected(rect());
}

/** The bubble beside the spotlight where there is room for it, else inside. */
void Tour::place()
{
    setGeometry(parentWidget()->rect());
    raise();
    m_bubble->setFixedHeight(m_bubble->layout()->hasHeightForWidth()
                                 ? m_bubble->layout()->heightForWidth(kBubble_px)
                                 : m_bubble->sizeHint().height());
    const QSize size = m_bubble->size();
    const QRect spot = spotlight();
    const QRect room = rect().marginsRemoved({kEdge_px, kEdge_px, kEdge_px, kEdge_px});
    const int x = std::clamp(spot.center().x() - size.width() / 2, room.left(),
                             std::max(room.left(), room.right() - size.width()));
    const int y = std::clamp(spot.center().y() - size.height() / 2, room.top(),
                             std::max(room.top(), room.bottom() - size.height()));
    const std::array<QPoint, 4> places{
        QPoint(x, spot.bottom() + kEdge_px), QPoint(x, spot.top() - kEdge_px - size.height()),
        QPoint(spot.left() - kEdge_px - size.width(), y), QPoint(spot.right() + kEdge_px, y)};
    const auto fits = [&](const QPoint& at) { return room.contains(QRect(at, size)); };
    const auto found = std::find_if(places.begin(), places.end(), fits);
    m_bubble->move(!spot.isNull() && found != places.end()
                       ? *found
                       : room.center() - QPoint(size.width() / 2, size.height() / 2));
    update();
}

bool Tour::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) { // the window below rests
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

bool Tour::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize && watched == parentWidget())
        place();
    if (event->type() == QEvent::KeyPress && watched != parentWidget()) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Left || key == Qt::Key_Right ||
            (key == Qt::Key_Space && m_steps[m_step].spaceFlies)) {
            keyPressEvent(static_cast<QKeyEvent*>(event));
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void Tour::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Escape:
        emit finished();
        return;
    case Qt::Key_Right:
    case Qt::Key_Return:
    case Qt::Key_Enter:
        next();
        return;
    case Qt::Key_Left:
        back();
        return;
    case Qt::Key_Space:
        if (m_steps[m_step].spaceFlies) {
            emit finished();
            emit flightRequested();
        }
        return;
    default:
        event->accept();
    }
}

bool Tour::focusNextPrevChild(bool next)
{
    std::vector<QPushButton*> buttons{m_skip, m_back, m_next};
    std::erase_if(buttons, [](const QPushButton* button) { return button->isHidden(); });
    const auto at = std::find(buttons.begin(), buttons.end(), focusWidget());
    const auto count = static_cast<std::ptrdiff_t>(buttons.size());
    const std::ptrdiff_t place = at == buttons.end() ? 0 : at - buttons.begin();
    buttons[static_cast<std::size_t>((place + (next ? 1 : count - 1)) % count)]->setFocus();
    return true;
}

void Tour::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath shade;
    shade.addRect(QRectF(rect()));
    QPainterPath spot;
    if (const QRect light = spotlight(); !light.isNull())
        spot.addRoundedRect(QRectF(light), kRadius_px, kRadius_px);
    painter.fillPath(shade.subtracted(spot), QColor(0, 0, 0, kShade));
    painter.setPen(QPen(m_theme.plan, 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(spot);
    painter.setPen(QPen(m_theme.panelLine, 1));
    painter.setBrush(m_theme.chart);
    painter.drawRoundedRect(QRectF(m_bubble->geometry()).adjusted(-0.5, -0.5, 0.5, 0.5), kRadius_px,
                            kRadius_px);
}

} // namespace berg
