#include "widgets/theme/picture_page.h"

#include "core/base/error.h"
#include "core/io/text/atomic_file.h"

#include <QBuffer>
#include <QFile>
#include <QFileInfo>
#include <QPainter>
#include <QPdfWriter>
#include <QRegularExpression>
#include <QSvgGenerator>
#include <QUuid>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kPictureScale = 2; // pixels of a PNG per layout unit
constexpr int kLayout_dpi = 96;

void paintPage(const PicturePage& page, QPainter& painter)
{
    painter.setRenderHint(QPainter::Antialiasing); // `QWidget::render` uses the painter's hints
    painter.fillRect(QRect(QPoint(0, 0), page.size_px), Qt::white); // SVG has no background
    page.paint(painter);
}

void paintPage(const PicturePage& page, QPaintDevice& device)
{
    QPainter painter(&device);
    paintPage(page, painter);
}

void paintSvg(const PicturePage& page, QBuffer& buffer)
{
    QSvgGenerator svg;
    svg.setOutputDevice(&buffer);
    svg.setResolution(kLayout_dpi);
    svg.setSize(page.size_px);
    svg.setViewBox(QRect(QPoint(0, 0), page.size_px));
    svg.setTitle(u"T"_s); // replaced by setTitle() below
    svg.setDescription(u"D"_s);
    paintPage(page, svg);
}

/** Inserts title and description afterwards, because Qt 6.4 does not escape them and Qt 6.8 does.
 */
void setTitle(const PicturePage& page, QByteArray& svg)
{
    const auto replace = [&svg](const QByteArray& held, const QString& text) {
        svg.replace(svg.indexOf(held), held.size(), text.toUtf8());
    };
    replace("<title>T</title>", u"<title>%1</title>"_s.arg(page.title.toHtmlEscaped()));
    replace("<desc>D</desc>", u"<desc>%1</desc>"_s.arg(page.description.toHtmlEscaped()));
}

/** Removes characters that XML 1.0 does not allow; names may contain them, and Qt writes them. */
void removeUnwritable(QByteArray& svg)
{
    svg.replace("\xEF\xBF\xBE", "").replace("\xEF\xBF\xBF", ""); // U+FFFE and U+FFFF
    svg.removeIf([](char c) {
        return static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r';
    });
}

/** Removes attributes that Qt repeats for every shape: half of a map's size. */
void compact(QByteArray& svg)
{
    svg.replace(" vector-effect=\"none\"", "");
    svg.replace(" transform=\"matrix(1,0,0,1,0,0)\"", "");
    QByteArray compacted;
    compacted.reserve(svg.size());
    for (const QByteArray& line : svg.split('\n'))
        if (!line.isEmpty() && !line.startsWith("font-family=\"")) // texts set their own fonts
            compacted += line + '\n';
    svg = compacted;
}

/** Shifts the offsets in a PDF's cross-reference table of objects behind `from` by `by` bytes. */
void moveObjects(QByteArray& pdf, qsizetype from, qsizetype by)
{
    constexpr qsizetype kDigits = 10;
    const qsizetype table = pdf.lastIndexOf("\nxref\n") + 1;
    static const QRegularExpression entry(u"^(\\d{10}) \\d{5} n"_s,
                                          QRegularExpression::MultilineOption);
    const QString rest = QString::fromLatin1(pdf.sliced(table));
    for (auto it = entry.globalMatch(rest); it.hasNext();) {
        const QRegularExpressionMatch match = it.next();
        const qlonglong offset = match.captured(1).toLongLong();
        if (offset > from)
            pdf.replace(table + match.capturedStart(1), kDigits,
                        QByteArray::number(offset + by).rightJustified(kDigits, '0'));
    }
    const QByteArray key = "startxref\n";
    const qsizetype start = pdf.lastIndexOf(key) + key.size();
    const qsizetype end = pdf.indexOf('\n', start);
    pdf.replace(start, end - start, QByteArray::number(table));
}

/** Replaces the creation times in a PDF by a constant, so that equal pages give equal files. */
void removeDates(QByteArray& pdf)
{
    const QByteArray day = "20000101000000Z";
    for (const QByteArray key :
         {"/CreationDate (D:", "/ModDate (D:"}) { // its length depends on the time zone
        const qsizetype found = pdf.indexOf(key);
        if (found < 0)
            continue;
        const qsizetype at = found + key.size();
        const qsizetype length = pdf.indexOf(')', at) - at;
        pdf.replace(at, length, day);
        moveObjects(pdf, at, day.size() - length);
    }
    const QByteArray instant = "2000-01-01T00:00:00+00:00"; // same length as in the metadata
    for (const QByteArray key : {"xmp:CreateDate=\"", "xmp:ModifyDate=\"",
                                 "xmp:MetadataDate=\""}) { // written since Qt 6.8
        const qsizetype found = pdf.indexOf(key);
        if (found >= 0)
            pdf.replace(found + key.size(), instant.size(), instant);
    }
}

/** Derives the document id from the title. Qt 6.4 writes none, Qt 6.8 a random one. */
template <class Writer>
void setIdentity(Writer& pdf, const QString& title)
{
    if constexpr (requires { pdf.setDocumentId(QUuid()); })
        pdf.setDocumentId(QUuid::createUuidV5(QUuid(), title));
}

} // namespace

std::string pdfFile(const PdfPages& pages)
{
    constexpr double kPoints = 72.0 / kLayout_dpi;
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter pdf(&buffer);
        pdf.setResolution(kLayout_dpi);
        pdf.setPageSize(QPageSize(QSizeF(pages.size_px) * kPoints, QPageSize::Point));
        pdf.setPageMargins({});
        pdf.setTitle(pages.title);
        pdf.setCreator(u"Bergwatch"_s);
        setIdentity(pdf, pages.title);
        QPainter painter(&pdf);
        for (int page = 0; page < pages.count; ++page) {
            if (page > 0)
                pdf.newPage();
            pages.paint(painter, page);
        }
    }
    buffer.close();
    removeDates(bytes);
    return bytes.toStdString();
}

QImage pictureImage(const PicturePage& page, double scale)
{
    QImage image((QSizeF(page.size_px) * scale).toSize(), QImage::Format_RGB32);
    image.setDevicePixelRatio(scale);
    image.fill(Qt::white);
    paintPage(page, image);
    return image;
}

std::string pictureFile(const PicturePage& page, const QString& ending)
{
    if (ending == u"pdf"_s)
        return pdfFile({.size_px = page.size_px,
                        .title = page.title,
                        .count = 1 + static_cast<int>(page.more.size()),
                        .paint = [&page](QPainter& painter, int number) {
                            if (number == 0)
                                paintPage(page, painter);
                            else
                                page.more[static_cast<std::size_t>(number - 1)](painter);
                        }});
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (ending == u"svg"_s) {
        paintSvg(page, buffer);
        buffer.close();
        setTitle(page, bytes);
        removeUnwritable(bytes);
        compact(bytes);
    } else {
        pictureImage(page, kPictureScale).save(&buffer, "PNG");
    }
    return bytes.toStdString();
}

void writePicture(const PicturePage& page, const QString& path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    if (std::none_of(kPictureEndings.begin(), kPictureEndings.end(),
                     [&](const char* known) { return ending == QLatin1String(known); }))
        throw Error(ErrorCode::Unsupported, path.toStdString(),
                    {IssueId::NotOneOf, {".png, .svg, .pdf"}});
    writeFileAtomically(QFile::encodeName(path).toStdString(), pictureFile(page, ending));
}

} // namespace berg
