#include "widgets/charts/chart_image.h"

#include "widgets/theme/picture_page.h"

#include <QFileInfo>
#include <QPainter>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

/** Lays out the chart offscreen, because a widget gets its size only when shown. */
void showOffscreen(TimeChart& chart, const TimeChartContent& content, const QSize& size_px)
{
    chart.resize(size_px);
    chart.setContent(content);
    chart.finishSeries();
    chart.setAttribute(Qt::WA_DontShowOnScreen);
    chart.show();
}

/** Renders the whole chart into `target`. */
void paintChart(TimeChart& chart, QPainter& painter, const QRectF& target)
{
    chart.render(&painter, target, QRect(QPoint(0, 0), chart.size()));
}

QString endingOf(const QString& path)
{
    return QFileInfo(path).suffix().toLower();
}

} // namespace

QImage chartImage(const TimeChartContent& content, const Theme& theme, const QSize& size_px,
                  double scale)
{
    TimeChart chart(theme);
    showOffscreen(chart, content, (QSizeF(size_px) / scale).toSize());
    QImage image(size_px, QImage::Format_RGB32);
    image.setDevicePixelRatio(scale);
    image.fill(theme.chart);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing); // `render` uses the painter's hints
    paintChart(chart, painter, QRectF(QPointF(0, 0), QSizeF(size_px) / scale));
    return image;
}

void writeChartPicture(const TimeChartContent& content, const Theme& theme, const ChartPage& page,
                       const QString& path)
{
    TimeChart chart(theme);
    chart.setGradients(endingOf(path) == u"png"_s); // Qt's SVG and PDF do not support gradient pens
    showOffscreen(chart, content, page.size_px);
    if (page.window)
        chart.setWindow(*page.window);
    writePicture(
        {.size_px = page.size_px,
         .title = content.title,
         .description = content.summary,
         .paint = [&chart](QPainter& painter) { paintChart(chart, painter, chart.rect()); }},
        path);
}

} // namespace berg
