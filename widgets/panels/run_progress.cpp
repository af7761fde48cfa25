#include "widgets/panels/run_progress.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace berg {
namespace {

constexpr int kSteps = 10000; ///< of the whole run
constexpr double kBar_px = 4;
constexpr int kHeight_px = 16;
constexpr int kNarrowest_px = 24;
constexpr int kWidth_px = 160;

} // namespace

RunProgress::RunProgress(QWidget* parent) : QProgressBar(parent)
{
    setRange(0, kSteps);
    setTextVisible(false);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void RunProgress::setTheme(const Theme& theme)
{
    m_theme = theme;
    update();
}

void RunProgress::showTime(double time_s, double duration_s)
{
    const double part = duration_s > 0 ? std::clamp(time_s / duration_s, 0.0, 1.0) : 0;
    setValue(static_cast<int>(std::lround(part * kSteps)));
}

QSize RunProgress::sizeHint() const
{
    return {kWidth_px, kHeight_px};
}

QSize RunProgress::minimumSizeHint() const
{
    return {kNarrowest_px, kHeight_px};
}

void RunProgress::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    const QRectF bar(0, (height() - kBar_px) / 2, width(), kBar_px);
    painter.setBrush(m_theme.panelLine);
    painter.drawRoundedRect(bar, kBar_px / 2, kBar_px / 2);
    QRectF flown = bar;
    flown.setWidth(bar.width() * value() / kSteps);
    painter.setBrush(m_theme.plan);
    if (flown.width() > 0)
        painter.drawRoundedRect(flown, kBar_px / 2, kBar_px / 2);
}

} // namespace berg
