#include "widgets/charts/study_picture.h"

#include <QFontMetricsF>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kReach_px = 16; ///< of the pointer
constexpr double kRing_px = 8;
constexpr double kBoxGap_px = 14; ///< between a point and its read-out
constexpr double kBoxMargin_px = 7;
constexpr double kLine_px = 16;

} // namespace

StudyPicture::StudyPicture(const Theme& theme, QWidget* parent) : QWidget(parent), m_theme(theme)
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void StudyPicture::setTheme(const Theme& theme)
{
    m_theme = theme;
    refresh();
}

void StudyPicture::setResult(const StudyPointer& result)
{
    m_result = result;
    const std::size_t settings = result ? result->summary.settings.size() : 0;
    if (m_chosen && *m_chosen >= settings)
        m_chosen.reset();
    if (m_hovered && *m_hovered >= settings)
        m_hovered.reset();
    refresh();
}

void StudyPicture::setChosen(std::optional<std::size_t> setting)
{
    if (setting == m_chosen)
        return;
    m_chosen = setting;
    refresh();
}

void StudyPicture::setTitleShown(bool shown)
{
    m_titleShown = shown;
    refresh();
}

QSize StudyPicture::sizeHint() const
{
    return {720, 320};
}

QSize StudyPicture::minimumSizeHint() const
{
    return {360, 190};
}

QString StudyPicture::studyTitle() const
{
    const int cases = static_cast<int>(summary().cases.size());
    const QString name = QString::fromStdString(m_result->study.spec.name);
    const QString count = cases == 1 ? tr("1 case") : tr("%n cases", nullptr, cases);
    return name.isEmpty() ? count
                          : tr("%1: %2", "name of a study, how many cases").arg(name, count);
}

void StudyPicture::refresh()
{
    m_frame = {.size = size(),
               .title = m_titleShown && hasCases() ? studyTitle() : QString(),
               .leftColour = m_theme.mutedText,
               .rightColour = m_theme.mutedText};
    m_spots.clear();
    layOut();
    const std::optional<std::size_t> read = m_hovered ? m_hovered : m_chosen;
    setAccessibleDescription(!hasCases() ? m_frame.emptyText
                             : read      ? readout(*read).join(u", "_s)
                                         : studyTitle());
    update();
}

void StudyPicture::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    refresh();
}

const SettingSpot* StudyPicture::spotOf(std::optional<std::size_t> setting) const
{
    const auto spot = std::find_if(m_spots.begin(), m_spots.end(),
                                   [&](const SettingSpot& one) { return one.setting == setting; });
    return setting && spot != m_spots.end() ? &*spot : nullptr;
}

std::optional<std::size_t> StudyPicture::settingNear(const QPointF& at) const
{
    std::optional<std::size_t> nearest;
    double nearest_px = kReach_px;
    for (const SettingSpot& spot : m_spots) {
        const double away_px = std::hypot(spot.at.x() - at.x(), spot.at.y() - at.y());
        if (away_px < nearest_px) {
            nearest = spot.setting;
            nearest_px = away_px;
        }
    }
    return nearest;
}

void StudyPicture::setHovered(std::optional<std::size_t> setting)
{
    if (setting == m_hovered)
        return;
    m_hovered = setting;
    setCursor(setting ? Qt::PointingHandCursor : Qt::ArrowCursor);
    refresh();
}

void StudyPicture::mouseMoveEvent(QMouseEvent* event)
{
    setHovered(settingNear(event->position()));
}

void StudyPicture::leaveEvent(QEvent* /*event*/)
{
    setHovered(std::nullopt);
}

void StudyPicture::mousePressEvent(QMouseEvent* event)
{
    const std::optional<std::size_t> setting = settingNear(event->position());
    if (event->button() != Qt::LeftButton || !setting) {
        QWidget::mousePressEvent(event);
        return;
    }
    setChosen(setting);
    emit settingActivated(*setting);
}

void StudyPicture::choose(std::size_t spot)
{
    const std::size_t setting = m_spots[spot].setting;
    setChosen(setting);
    emit settingChosen(setting);
}

void StudyPicture::keyPressEvent(QKeyEvent* event)
{
    if (m_spots.empty()) {
        QWidget::keyPressEvent(event);
        return;
    }
    const SettingSpot* present = spotOf(m_chosen);
    const std::size_t last = m_spots.size() - 1;
    const std::size_t at = present ? static_cast<std::size_t>(present - m_spots.data()) : 0;
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Up:
        choose(present && at > 0 ? at - 1 : 0);
        return;
    case Qt::Key_Right:
    case Qt::Key_Down:
        choose(present ? std::min(at + 1, last) : 0);
        return;
    case Qt::Key_Home:
        choose(0);
        return;
    case Qt::Key_End:
        choose(last);
        return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (present)
            emit settingActivated(present->setting);
        return;
    default:
        QWidget::keyPressEvent(event);
    }
}

void StudyPicture::paintChosen(QPainter& painter) const
{
    const SettingSpot* spot = spotOf(m_chosen);
    if (spot == nullptr)
        return;
    painter.setPen(QPen(m_theme.text, 1.6));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(spot->at, kRing_px, kRing_px);
}

/** Beside the point, on the side where there is room. */
void StudyPicture::paintReadoutBox(QPainter& painter, const SettingSpot& spot) const
{
    const QStringList lines = readout(spot.setting);
    const QFontMetricsF strong(m_theme.strong());
    const QFontMetricsF small(m_theme.small());
    double width_px = strong.horizontalAdvance(lines.front());
    for (const QString& line : lines)
        width_px = std::max(width_px, small.horizontalAdvance(line));
    QRectF box(0, 0, width_px + 2 * kBoxMargin_px,
               static_cast<double>(lines.size()) * kLine_px + 2 * kBoxMargin_px);
    const bool isRight = spot.at.x() + kBoxGap_px + box.width() < width();
    box.moveLeft(isRight ? spot.at.x() + kBoxGap_px : spot.at.x() - kBoxGap_px - box.width());
    box.moveTop(std::clamp(spot.at.y() - box.height() / 2, 2.0,
                           std::max(2.0, height() - box.height() - 2)));
    painter.setPen(QPen(m_theme.chartAxis, 1));
    painter.setBrush(m_theme.panel);
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(m_theme.text);
    QRectF row(box.left() + kBoxMargin_px, box.top() + kBoxMargin_px, width_px, kLine_px);
    for (const QString& line : lines) {
        painter.setFont(row.top() < box.top() + kLine_px ? m_theme.strong() : m_theme.small());
        painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, line);
        row.translate(0, kLine_px);
    }
}

void StudyPicture::paintPicture(QPainter& painter) const
{
    painter.fillRect(rect(), m_theme.chart);
    painter.setRenderHint(QPainter::Antialiasing);
    if (hasCases())
        paintContent(painter);
    paintChartFrame(painter, m_frame, m_theme);
    paintChosen(painter);
}

void StudyPicture::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    paintPicture(painter);
    if (const SettingSpot* read = spotOf(m_hovered || !hasFocus() ? m_hovered : m_chosen))
        paintReadoutBox(painter, *read);
    if (hasFocus()) {
        painter.setPen(QPen(m_theme.plan, 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

} // namespace berg
