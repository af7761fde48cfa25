#include "widgets/charts/chart_image.h"

#include <QPainter>

namespace berg {

QImage chartImage(const TimeChartContent& content, const Theme& theme, const QSize& size_px,
                  double scale)
{
    TimeChart chart(theme);
    chart.resize((QSizeF(size_px) / scale).toSize());
    chart.setContent(content);
    // A widget gets its size only when shown; this one is laid out without appearing.
    chart.setAttribute(Qt::WA_DontShowOnScreen);
    chart.show();
    QImage image(size_px, QImage::Format_RGB32);
    image.setDevicePixelRatio(scale);
    image.fill(theme.chart);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing); // `render` takes the painter's hints
    chart.render(&painter, QRectF(QPointF(0, 0), QSizeF(size_px) / scale),
                 QRect(QPoint(0, 0), chart.size()));
    return image;
}

} // namespace berg
