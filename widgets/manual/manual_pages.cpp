#include "widgets/manual/manual_pages.h"

#include "core/base/error.h"
#include "core/io/text/file_set.h"
#include "widgets/manual/manual.h"
#include "widgets/theme/picture_page.h"
#include "widgets/theme/theme.h"

#include <QAbstractTextDocumentLayout>
#include <QCoreApplication>
#include <QDir>
#include <QPainter>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTextDocument>

#include <memory>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct ManualPages
{
    Q_DECLARE_TR_FUNCTIONS(ManualPages)
};

const QString kIndex = u"index.html"_s;
const QString kPdf = u"manual.pdf"_s;

// A4 at 96 per inch.
constexpr QSize kPage_px{794, 1123};
constexpr int kMargin_px = 77;
constexpr QSizeF kText_px{kPage_px.width() - 2.0 * kMargin_px,
                          kPage_px.height() - 2.0 * kMargin_px};

const QString& webStyle()
{
    static const QString style =
        u"body{font:16px/1.5 sans-serif;color:#1b2733;background:#fff;margin:0;display:flex}"
        "nav{flex:0 0 13em;padding:1.5em;background:#eef2f5;min-height:100vh}"
        "nav a{display:block;margin:.3em 0}nav a.here{font-weight:bold}"
        "main{max-width:46em;padding:1.5em 2.5em;min-width:0}"
        "table{border-collapse:collapse;display:block;overflow-x:auto}th,td{border:1px solid "
        "#c5ced6;padding:.3em .6em;vertical-align:top;text-align:left}"
        "pre{background:#eef2f5;padding:.8em;overflow-x:auto}code{background:#eef2f5}"
        "a{color:#0b5394}img{max-width:100%;height:auto}"
        "@media(max-width:50em){body{display:block}nav{min-height:0}}"
        "@media(prefers-color-scheme:dark){body{background:#14191e;color:#dfe6ec}"
        "nav,pre,code{background:#1e262d}th,td{border-color:#3b4650}a{color:#7db8ee}}"_s;
    return style;
}

QString linkTo(const QString& page, const QString& text, bool isHere)
{
    return u"<a href=\"%1\"%2>%3</a>\n"_s.arg(page, isHere ? u" class=\"here\""_s : QString(),
                                              text.toHtmlEscaped());
}

QString pageOf(const ManualChapter& chapter)
{
    return chapter.name + u".html"_s;
}

/** A complete page with links to all chapters. */
QString webPage(const Manual& manual, const QString& title, const QString& here,
                const QString& content)
{
    QString chapters = linkTo(kIndex, ManualPages::tr("Contents"), here == kIndex);
    for (const ManualChapter& chapter : manual.chapters)
        chapters += linkTo(pageOf(chapter), chapter.title(), here == pageOf(chapter));
    chapters += linkTo(kPdf, u"PDF"_s, false);
    return u"<!DOCTYPE html>\n<html lang=\"%1\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width\">\n<title>%2 - "
           "Bergwatch</title>\n"
           "<style>%3</style>\n</head>\n<body>\n<nav>\n%4</nav>\n<main>\n%5</main>\n</body>\n</html>\n"_s
               .arg(manualLanguage(), title.toHtmlEscaped(), webStyle(), chapters, content);
}

QString webContents(const Manual& manual)
{
    QString html = u"<h1>%1</h1>\n"_s.arg(ManualPages::tr("The Bergwatch manual"));
    for (const ManualChapter& chapter : manual.chapters) {
        html += u"<h2>%1</h2>\n<ul>\n"_s.arg(linkTo(pageOf(chapter), chapter.title(), false));
        for (const MarkdownBlock& block : chapter.blocks)
            if (block.kind == MarkdownKind::Heading && block.level == 2)
                html += u"<li>%1</li>\n"_s.arg(
                    linkTo(pageOf(chapter) + u'#' + block.id, plainText(block.text), false));
        html += u"</ul>\n"_s;
    }
    return html;
}

std::unique_ptr<QTextDocument> documentOf(const QString& html, const QString& folder)
{
    auto document = std::make_unique<QTextDocument>();
    document->setDocumentMargin(0);
    document->setDefaultFont(Theme::light().body());
    document->setDefaultStyleSheet(
        u"pre { background-color: #eef2f5; white-space: pre-wrap; } th { background-color: #eef2f5; }"_s);
    document->setBaseUrl(QUrl::fromLocalFile(folder + u'/'));
    document->setHtml(html);
    document->setPageSize(kText_px);
    return document;
}

/** All chapters without links, which are useless on paper. */
QString paperText(const Manual& manual, const QString& folder)
{
    QString html;
    for (const ManualChapter& chapter : manual.chapters)
        html +=
            chapter.html(folder, false)
                .replace(u"<h1>"_s,
                         html.isEmpty() ? u"<h1>"_s : u"<h1 style=\"page-break-before:always\">"_s);
    static const QRegularExpression link(u"<a href=[^>]*>(.*?)</a>"_s);
    return html.replace(link, u"\\1"_s);
}

/** Table of contents with page numbers; `before` pages precede the text. */
QString paperContents(const QTextDocument& text, int before)
{
    QString html = u"<h2>%1</h2><table width=\"100%\" cellpadding=\"0\">"_s.arg(
        ManualPages::tr("The Bergwatch manual"));
    for (QTextBlock block = text.begin(); block.isValid(); block = block.next()) {
        const int level = block.blockFormat().headingLevel();
        if (level != 1 && level != 2)
            continue;
        const double top = text.documentLayout()->blockBoundingRect(block).top();
        const QString number =
            QString::number(static_cast<int>(top / kText_px.height()) + before + 1);
        const QString title = block.text().toHtmlEscaped();
        html +=
            (level == 1 ? u"<tr><td><b>%1</b></td><td align=\"right\"><b>%2</b></td></tr>"_s
                        : u"<tr><td>&nbsp;&nbsp;&nbsp;%1</td><td align=\"right\">%2</td></tr>"_s)
                .arg(title, number);
    }
    return html + u"</table>"_s;
}

void paintPaper(QPainter& painter, QTextDocument& document, int page, int number)
{
    const double top = page * kText_px.height();
    painter.save();
    painter.translate(kMargin_px, kMargin_px - top);
    document.drawContents(&painter, QRectF(QPointF(0, top), kText_px));
    painter.restore();
    painter.setFont(Theme::light().small());
    painter.setPen(Qt::black);
    painter.drawText(
        QRectF(kMargin_px, kPage_px.height() - kMargin_px, kText_px.width(), kMargin_px),
        Qt::AlignCenter, u"Bergwatch - %1"_s.arg(number));
}

std::string paperManual(const Manual& manual, const QString& folder)
{
    const std::unique_ptr<QTextDocument> text = documentOf(paperText(manual, folder), folder);
    const int before = documentOf(paperContents(*text, 0), folder)->pageCount();
    const std::unique_ptr<QTextDocument> contents =
        documentOf(paperContents(*text, before), folder);
    return pdfFile({.size_px = kPage_px,
                    .title = ManualPages::tr("The Bergwatch manual"),
                    .count = before + text->pageCount(),
                    .paint = [&](QPainter& painter, int page) {
                        if (page < before)
                            paintPaper(painter, *contents, page, page + 1);
                        else
                            paintPaper(painter, *text, page - before, page + 1);
                    }});
}

} // namespace

QStringList manualFileNames()
{
    QStringList names{kIndex, kPdf};
    for (const char* chapter : kManualChapters)
        names << QLatin1String(chapter) + u".html"_s;
    return names;
}

QStringList writeManual(const QString& folder)
{
    if (!QDir().mkpath(folder))
        throw Error(ErrorCode::FileUnwritable, folder.toStdString(), {IssueId::CannotMake});
    const QString absolute = QDir(folder).absolutePath();
    const Manual manual = readManual(manualLanguage());
    QStringList paths;
    std::vector<NewFile> files;
    const auto add = [&](const QString& name, const std::string& content) {
        paths << QDir(folder).filePath(name);
        files.push_back(
            {.path = QFile::encodeName(paths.back()).toStdString(), .content = content});
    };
    add(kIndex,
        webPage(manual, ManualPages::tr("Contents"), kIndex, webContents(manual)).toStdString());
    add(kPdf, paperManual(manual, absolute));
    for (const ManualChapter& chapter : manual.chapters)
        add(pageOf(chapter),
            webPage(manual, chapter.title(), pageOf(chapter), chapter.html(absolute, false))
                .toStdString());
    writeFileSet(files);
    return paths;
}

} // namespace berg
