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

void paintPage(const PicturePage& page, QPaintDevice& device)
{
    QPainter painter(&device);
    painter.setRenderHint(QPainter::Antialiasing); // `render` takes the painter's hints
    page.paint(painter);
}

void paintSvg(const PicturePage& page, QBuffer& buffer)
{
    QSvgGenerator svg;
    svg.setOutputDevice(&buffer);
    svg.setResolution(kLayout_dpi);
    svg.setSize(page.size_px);
    svg.setViewBox(QRect(QPoint(0, 0), page.size_px));
    svg.setTitle(page.title);
    svg.setDescription(page.description);
    paintPage(page, svg);
}

void paintPdf(const PicturePage& page, QBuffer& buffer)
{
    constexpr double kPoints = 72.0 / kLayout_dpi;
    QPdfWriter pdf(&buffer);
    pdf.setResolution(kLayout_dpi);
    pdf.setPageSize(QPageSize(QSizeF(page.size_px) * kPoints, QPageSize::Point));
    pdf.setPageMargins({});
    pdf.setTitle(page.title);
    paintPage(page, pdf);
}

/** All of the chart, over `target`. */
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
    showUnseen(chart, content, (QSizeF(size_px) / scale).toSize());
    QImage image(size_px, QImage::Format_RGB32);
    image.setDevicePixelRatio(scale);
    image.fill(theme.chart);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing); // `render` takes the painter's hints
    paintChart(chart, painter, QRectF(QPointF(0, 0), QSizeF(size_px) / scale));
    return image;
}

void writeChartPicture(const TimeChartContent& content, const Theme& theme, const ChartPage& page,
                       const QString& path)
{
    TimeChart chart(theme);
    chart.setGradients(endingOf(path) == u"png"_s); // neither SVG nor PDF of Qt has such pens
    showUnseen(chart, content, page.size_px);
    if (page.window)
        chart.setWindow(*page.window);
    writePicture(
        {.size_px = page.size_px,
         .title = content.title,
         .description = content.summary,
         .paint = [&chart](QPainter& painter) { paintChart(chart, painter, chart.rect()); }},
        path);
}

void writePicture(const PicturePage& page, const QString& path)
{
    const QString ending = endingOf(path);
    if (std::none_of(kChartPictureEndings.begin(), kChartPictureEndings.end(),
                     [&](const char* known) { return ending == QLatin1String(known); }))
        throw Error(ErrorCode::Unsupported, path.toStdString(),
                    "charts are written as .png, .svg or .pdf");
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (ending == u"svg"_s) {
        paintSvg(page, buffer);
    } else if (ending == u"pdf"_s) {
        paintPdf(page, buffer);
    } else {
        QImage image(page.size_px * kPictureScale, QImage::Format_RGB32);
        image.setDevicePixelRatio(kPictureScale);
        paintPage(page, image);
        image.save(&buffer, "PNG");
    }
    writeFileAtomically(QFile::encodeName(path).toStdString(),
                        {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

} // namespace berg
