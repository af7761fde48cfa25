#include "widgets/map/view/place_mark.h"

#include <QPainter>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kShown_ms = 6000;
constexpr double kRing_px = 15;
constexpr double kTick_px = 7; // length of the cross outside the ring
constexpr double kGap_px = 4;
constexpr double kPadding_px = 4;

} // namespace

PlaceMark::PlaceMark(MapView& map) : QWidget(&map), m_map(map)
{
    setObjectName(u"placeMark"_s);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    m_timer.setSingleShot(true);
    m_timer.setInterval(kShown_ms);
    connect(&m_timer, &QTimer::timeout, this, &QWidget::hide);
    connect(&map.camera(), &MapCamera::moved, this, &PlaceMark::follow);
    hide();
}

void PlaceMark::setTheme(const Theme& theme)
{
    m_theme = theme;
    update();
}

void PlaceMark::showAt(const Point& position_m, const QString& name)
{
    m_position_m = position_m;
    m_name = name;
    setAccessibleName(name);
    follow();
    show();
    m_timer.start();
}

void PlaceMark::follow()
{
    const QFontMetricsF metrics(m_theme.strong());
    const double half_px = kRing_px + kTick_px + 2;
    const double text_px = m_name.isEmpty() ? 0 : metrics.horizontalAdvance(m_name);
    const double width_px = 2 * std::max(half_px, text_px / 2 + kPadding_px + 1);
    const double height_px =
        2 * half_px + (m_name.isEmpty() ? 0 : kGap_px + metrics.height() + 2 * kPadding_px);
    const QPointF at = m_map.toScreen(m_position_m);
    setGeometry(
        QRectF(at.x() - width_px / 2, at.y() - half_px, width_px, height_px).toAlignedRect());
}

void PlaceMark::paintEvent(QPaintEvent*)
{
    const QPointF at = m_map.toScreen(m_position_m) - QPointF(pos());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    // A lighter line beneath keeps the mark clear on sea, land and ice.
    for (const QPen& pen : {QPen(m_theme.panel, 5), QPen(m_theme.plan, 2.5)}) {
        painter.setPen(pen);
        painter.drawEllipse(at, kRing_px, kRing_px);
        for (const QPointF& direction :
             {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            painter.drawLine(at + direction * kRing_px, at + direction * (kRing_px + kTick_px));
    }
    if (m_name.isEmpty())
        return;
    const QFontMetricsF metrics(m_theme.strong());
    QRectF box(0, 0, metrics.horizontalAdvance(m_name) + 2 * kPadding_px,
               metrics.height() + 2 * kPadding_px);
    box.moveCenter({at.x(), at.y() + kRing_px + kTick_px + kGap_px + box.height() / 2 - 2});
    painter.setPen(m_theme.panelLine);
    painter.setBrush(m_theme.panel);
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(m_theme.text);
    painter.setFont(m_theme.strong());
    painter.drawText(box, static_cast<int>(Qt::AlignCenter), m_name);
}

} // namespace berg
