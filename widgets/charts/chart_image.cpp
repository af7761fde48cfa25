#include "widgets/charts/chart_image.h"

#include "core/base/error.h"
#include "core/io/atomic_file.h"

#include <QBuffer>
#include <QFile>
#include <QFileInfo>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kPictureScale = 2; // device pixels of a PNG for each of the layout
constexpr int kLayout_dpi = 96;

/** Lays the chart out without a window on the screen: a widget gets its size only when shown. */
void showUnseen(TimeChart& chart, const TimeChartContent& content, const QSize& size_px)
{
    chart.resize(size_px);
    chart.setContent(content);
    chart.setAttribute(Qt::WA_DontShowOnScreen);
    chart.show();
}

void paintChart(TimeChart& chart, QPaintDevice& device, const QRectF& target)
{
    QPainter painter(&device);
    painter.setRenderHint(QPainter::Antialiasing); // `render` takes the painter's hints
    chart.render(&painter, target, QRect(QPoint(0, 0), chart.size()));
}

void paintSvg(TimeChart& chart, QBuffer& buffer)
{
    QSvgGenerator svg;
    svg.setOutputDevice(&buffer);
    svg.setResolution(kLayout_dpi);
    svg.setSize(chart.size());
    svg.setViewBox(chart.rect());
    svg.setTitle(chart.content().title);
    svg.setDescription(chart.content().summary);
    paintChart(chart, svg, chart.rect());
}

void paintPdf(TimeChart& chart, QBuffer& buffer)
{
    constexpr double kPoints = 72.0 / kLayout_dpi;
    QPdfWriter pdf(&buffer);
    pdf.setResolution(kLayout_dpi);
    pdf.setPageSize(QPageSize(QSizeF(chart.size()) * kPoints, QPageSize::Point));
    pdf.setPageMargins({});
    pdf.setTitle(chart.content().title);
    paintChart(chart, pdf, chart.rect());
}

} // namespace

QImage chartImage(const TimeChartContent& content, const Theme& theme, const QSize& size_px,
                  double scale)
{
    TimeChart chart(theme);
    showUnseen(chart, content, (QSizeF(size_px) / scale).toSize());
    QImage image(size_px, QImage::Format_RGB32);
    image.setDevicePixelRatio(scale);
    image.fill(theme.chart);
    paintChart(chart, image, QRectF(QPointF(0, 0), QSizeF(size_px) / scale));
    return image;
}

void writeChartPicture(const TimeChartContent& content, const Theme& theme, const ChartPage& page,
                       const QString& path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    if (std::none_of(kChartPictureEndings.begin(), kChartPictureEndings.end(),
                     [&](const char* known) { return ending == QLatin1String(known); }))
        throw Error(ErrorCode::Unsupported, path.toStdString(),
                    "charts are written as .png, .svg or .pdf");
    TimeChart chart(theme);
    chart.setGradients(ending == u"png"_s); // neither SVG nor PDF of Qt has pens with a gradient
    showUnseen(chart, content, page.size_px);
    if (page.window)
        chart.setWindow(*page.window);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (ending == u"svg"_s) {
        paintSvg(chart, buffer);
    } else if (ending == u"pdf"_s) {
        paintPdf(chart, buffer);
    } else {
        QImage image(page.size_px * kPictureScale, QImage::Format_RGB32);
        image.setDevicePixelRatio(kPictureScale);
        paintChart(chart, image, chart.rect());
        image.save(&buffer, "PNG");
    }
    writeFileAtomically(QFile::encodeName(path).toStdString(),
                        {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

} // namespace berg
