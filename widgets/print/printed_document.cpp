#include "widgets/print/printed_document.h"

#include "core/io/text/html_text.h"
#include "widgets/theme/painter_state.h"
#include "widgets/theme/theme.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QTextOption>

#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

/** Takes the place of `kReportStyle`, of which Qt understands little. Sizes of headings are
 * relative to that of text. */
const QString kPrintStyle = uR"css(
h1 { margin: 0; }
h2 { font-size: medium; margin: 9px 0 1px 0; }
p { margin: 0 0 2px 0; }
ul { margin: 0; }
.muted, caption { color: #4a4a4a; font-size: 10px; }
.foot { color: #4a4a4a; font-size: 9px; margin-top: 5px; }
table { border-collapse: collapse; margin-top: 6px; }
.facts, .plain { margin-top: 0; }
th, td { padding: 0 3px 1px 3px; text-align: right; font-weight: normal; vertical-align: top; }
thead th { border-bottom: 1px solid #000000; }
tbody th, tbody td { border-bottom: 1px solid #d0d0d0; }
[scope="row"], .text { text-align: left; }
.nowrap th, .nowrap td { padding: 0 2px; white-space: nowrap; }
.facts td, .plain td { border: 0px; padding: 0 10px 3px 0; text-align: left; }
.plain .end { padding-right: 0; text-align: right; }
.blank td { padding-top: 9px; text-align: left; border-bottom: 1px solid #b0b0b0; }
.item { margin-top: 9px; }
)css"_s;

} // namespace

PrintedText::PrintedText(const PrintedDocument& document) : m_document(document)
{
    setUndoRedoEnabled(false);
    setDocumentMargin(0);
    setIndentWidth(kPrint_px);
    setDefaultFont(printFont(kPrint_px));
    QTextOption option = defaultTextOption();
    option.setTextDirection(Qt::LeftToRight); // also of lines that begin with a name
    setDefaultTextOption(option);
    setDefaultStyleSheet(kPrintStyle);
    documentLayout()->registerHandler(QTextFormat::ImageObject, this);
    setPageSize(document.room_px());
    setHtml(QString::fromStdString(document.html));
}

double PrintedText::spare_px() const
{
    return pageCount() > 1
               ? -1
               : pageSize().height() - documentLayout()->frameBoundingRect(rootFrame()).height();
}

void PrintedText::paintPage(QPainter& painter, int page) const
{
    const PainterState saved(painter);
    const double top_px = page * pageSize().height();
    painter.translate(kPaperMargin_px, kPaperMargin_px - top_px);
    QAbstractTextDocumentLayout::PaintContext context;
    context.clip = QRectF(QPointF(0, top_px), pageSize());
    context.palette.setColor(QPalette::Text, Qt::black);
    documentLayout()->draw(&painter, context);
}

QSizeF PrintedText::intrinsicSize(QTextDocument* /*text*/, int /*at*/, const QTextFormat& format)
{
    const QTextImageFormat image = format.toImageFormat();
    return {image.width(), image.height()};
}

void PrintedText::drawObject(QPainter* painter, const QRectF& rect, QTextDocument* /*text*/,
                             int /*at*/, const QTextFormat& format)
{
    const PainterState saved(*painter);
    painter->translate(rect.topLeft());
    m_document.pictures.at(format.toImageFormat().name())(*painter);
}

QFont printFont(int size_px)
{
    QFont font = Theme::light().font;
    font.setPixelSize(size_px);
    font.setHintingPreference(QFont::PreferNoHinting);
    // Imperceptible spacing turns off ligatures, which a search in a PDF does not find.
    font.setLetterSpacing(QFont::AbsoluteSpacing, 1.0 / 64);
    return font;
}

double printWidth_px(const QString& text, int size_px)
{
    return QFontMetricsF(printFont(size_px)).horizontalAdvance(text);
}

std::string htmlWithin(const QString& text, double width_px, int size_px)
{
    return html(QFontMetricsF(printFont(size_px)).elidedText(text, Qt::ElideRight, width_px));
}

std::string html(const QString& text)
{
    return htmlText(text.toStdString());
}

std::string pictureHtml(const std::string& name, const QSizeF& size_px)
{
    return "<p><img src=\"" + name + "\" width=\"" + std::to_string(std::lround(size_px.width())) +
           "\" height=\"" + std::to_string(std::lround(size_px.height())) + "\"/></p>\n";
}

} // namespace berg
