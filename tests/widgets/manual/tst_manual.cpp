#include "core/io/files/field_rows.h"
#include "tests/support/window/panel_test.h"
#include "widgets/manual/manual_pages.h"
#include "widgets/manual/manual_places.h"
#include "widgets/manual/manual_window.h"

#include <QAction>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTreeWidget>
#include <QtTest>

#include <algorithm>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

const QStringList kLanguages{u"en"_s, u"nb"_s};

/** Targets of the links in a text, such as "planning.md#tau". */
QStringList linksOf(const QString& inlineText)
{
    static const QRegularExpression link(u"\\[[^\\]]+\\]\\(([^)]+)\\)"_s);
    QStringList links;
    for (auto it = link.globalMatch(inlineText); it.hasNext();)
        links << it.next().captured(1);
    return links;
}

/** Structure that all languages share: kinds, ids, codes, pictures, table sizes and links. */
QStringList frameOf(const ManualChapter& chapter)
{
    QStringList frame;
    for (const MarkdownBlock& block : chapter.blocks) {
        QString line =
            u"%1 %2 %3 %4"_s.arg(int(block.kind)).arg(block.level).arg(block.id, block.info);
        if (block.kind == MarkdownKind::Code)
            line += block.text;
        for (const QStringList& row : block.rows)
            line += u" %1"_s.arg(row.size());
        frame << line + linksOf(block.text).join(u' ');
    }
    return frame;
}

/** All links, also those in tables. */
QStringList allLinks(const ManualChapter& chapter)
{
    QStringList links;
    for (const MarkdownBlock& block : chapter.blocks) {
        links << linksOf(block.text);
        for (const QStringList& row : block.rows)
            for (const QString& cell : row)
                links << linksOf(cell);
    }
    return links;
}

bool hasAnchor(const ManualChapter& chapter, const QString& id)
{
    return std::ranges::any_of(chapter.blocks, [&](const MarkdownBlock& block) {
        return block.kind == MarkdownKind::Heading && block.id == id;
    });
}

/** Whether there is such a place; of a chapter in hand where it names none. */
bool leads(const Manual& manual, const ManualChapter& from, const QString& link)
{
    const ManualChapter* chapter = link.startsWith(u'#') ? &from : manual.chapterAt(link);
    return chapter != nullptr &&
           (!link.contains(u'#') || hasAnchor(*chapter, link.section(u'#', 1)));
}

} // namespace

/** The manual: its chapters in all languages, what links lead to, search, and its window. */
class TestManual : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void blocksAreRead()
    {
        const std::vector<MarkdownBlock> blocks = markdownBlocks(
            u"# T {#t}\ntwo\nlines\n\n- a\n  b\n1. c\n> F = x\n\n| a | b |\n|---|---|\n| 1 | 2 |\n"
            "```sh\n# x\n```\n![P](p.png)\n"_s);
        QCOMPARE(blocks.size(), 8U);
        QCOMPARE(blocks[0].id, u"t"_s);
        QCOMPARE(blocks[1].text, u"two lines"_s);
        QCOMPARE(blocks[2].text, u"a b"_s);
        QVERIFY(blocks[3].kind == MarkdownKind::Numbered &&
                blocks[4].kind == MarkdownKind::Formula);
        QCOMPARE(blocks[5].rows, (std::vector<QStringList>{{u"a"_s, u"b"_s}, {u"1"_s, u"2"_s}}));
        QCOMPARE(blocks[6].text, u"# x\n"_s);
        QCOMPARE(blocks[7].info, u"p.png"_s);
    }

    void marksBecomeHtml_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("html");
        QTest::addColumn<QString>("plain");
        QTest::newRow("bold") << u"a **b** c"_s << u"a <b>b</b> c"_s << u"a b c"_s;
        QTest::newRow("italic") << u"*a* 2 * 3"_s << u"<i>a</i> 2 * 3"_s << u"a 2 * 3"_s;
        QTest::newRow("code") << u"`a < *b*`"_s << u"<code>a &lt; *b*</code>"_s << u"a < b"_s;
        QTest::newRow("index") << u"σ<sub>i</sub> < 2"_s << u"σ<sub>i</sub> &lt; 2"_s
                               << u"σi < 2"_s;
        QTest::newRow("link") << u"[a](b.md#c)"_s << u"<a href=\"b.html#c\">a</a>"_s << u"a"_s;
    }

    void marksBecomeHtml()
    {
        QFETCH(QString, text);
        QFETCH(QString, html);
        QFETCH(QString, plain);
        QCOMPARE(markdownHtml(markdownBlocks(text), false), u"<p>%1</p>\n"_s.arg(html));
        QCOMPARE(plainText(text), plain);
    }

    void filesAreTheChapters()
    {
        QStringList expected;
        for (const char* name : kManualChapters)
            expected << QLatin1String(name) + u".md"_s;
        expected.sort();
        for (const QString& language : kLanguages)
            QCOMPARE(QDir(QStringLiteral(BERG_SOURCE_DIR "/resources/manual/") + language)
                         .entryList({u"*.md"_s}, QDir::Files, QDir::Name),
                     expected);
    }

    void languagesHaveTheSameFrame()
    {
        const Manual english = readManual(u"en"_s);
        const Manual norwegian = readManual(u"nb"_s);
        for (std::size_t i = 0; i < english.chapters.size(); ++i) {
            const QStringList a = frameOf(english.chapters[i]);
            const QStringList b = frameOf(norwegian.chapters[i]);
            for (qsizetype k = 0; k < std::min(a.size(), b.size()); ++k)
                QVERIFY2(a[k] == b[k],
                         qPrintable(english.chapters[i].name + u": "_s + a[k] + u" | "_s + b[k]));
            QCOMPARE(b.size(), a.size());
        }
    }

    void everyLinkLeadsSomewhere()
    {
        for (const QString& language : kLanguages) {
            const Manual manual = readManual(language);
            for (const ManualChapter& chapter : manual.chapters) {
                QCOMPARE(chapter.blocks.front().level, 1);
                for (const QString& link : allLinks(chapter))
                    QVERIFY2(leads(manual, chapter, link),
                             qPrintable(language + u' ' + chapter.name + u": "_s + link));
            }
            QVERIFY(!leads(manual, manual.chapters.front(), u"window.md#nowhere"_s));
            QVERIFY(!leads(manual, manual.chapters.front(), u"nowhere.md"_s));
        }
    }

    void headingsHaveIdsOfTheirOwn()
    {
        for (const ManualChapter& chapter : readManual(u"en"_s).chapters) {
            QStringList ids;
            for (const MarkdownBlock& block : chapter.blocks)
                if (block.kind == MarkdownKind::Heading)
                    ids << block.id;
            QVERIFY2(!ids.contains(QString()), qPrintable(chapter.name));
            QCOMPARE(ids.removeDuplicates(), 0);
        }
    }

    /** The table is made of the core's rows, in the language of the chapter. */
    void fieldsAreThoseOfTheCore()
    {
        const auto tableOf = [](const QString& language) {
            const Manual manual = readManual(language);
            const auto& blocks = manual.chapterAt(u"fields"_s)->blocks;
            return std::ranges::find_if(blocks,
                                        [](const auto& block) { return !block.rows.empty(); })
                ->rows;
        };
        const std::vector<FieldRow> rows = fieldRows([](const char* english) { return english; });
        const std::vector<QStringList> english = tableOf(u"en"_s);
        const std::vector<QStringList> norwegian = tableOf(u"nb"_s);
        QCOMPARE(english.size(), rows.size() + 1);
        QCOMPARE(norwegian.size(), english.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            QCOMPARE(english[i + 1].front().toStdString(), rows[i].field);
            QCOMPARE(english[i + 1].back().toStdString(), rows[i].meaning);
            QCOMPARE(norwegian[i + 1].front(), english[i + 1].front());
            QVERIFY2(norwegian[i + 1].back() != english[i + 1].back(), rows[i].field.c_str());
        }
    }

    void placesAreInTheManual()
    {
        const Manual manual = readManual(u"en"_s);
        for (const ManualPlace& known : kManualPlaces)
            QVERIFY2(leads(manual, manual.chapters.front(), QLatin1String(known.place)),
                     known.place);
        const QWidget nowhere;
        QCOMPARE(manualPlaceOf(&nowhere), u"start"_s);
        QCOMPARE(manualPlaceOf(nullptr), u"start"_s);
    }

    void searchFindsLinesWithAllTheWords()
    {
        const Manual manual = readManual(u"en"_s);
        const std::vector<ManualHit> hits = manual.search(u"GRAND export survey"_s);
        QCOMPARE(hits.size(), 2U); // and again where it fails
        QVERIFY(hits[0].place.startsWith(u"start.html#block-"_s));
        QCOMPARE(hits[0].heading, u"The same from the command line"_s);
        QCOMPARE(hits[0].line, u"bergwatch-cli export grand-banks-12.berg --output survey.plan"_s);
        QCOMPARE(manual.search(u"drag the slider tau"_s).size(), 1U); // "Trade-off τ"
        QVERIFY(manual.search(u"xyzzy"_s).empty());
        QVERIFY(manual.search(u"  "_s).empty());
    }

    void windowShowsPlacesAndGoesBack()
    {
        ManualWindow window(nullptr);
        window.show();
        const auto& text = test::child<QTextBrowser>(window, u"manualText"_s);
        const auto& list = test::child<QTreeWidget>(window, u"manualList"_s);
        QCOMPARE(list.topLevelItemCount(), int(kManualChapters.size()));
        window.showPlace(u"window#plan"_s);
        QCOMPARE(window.place(), u"window#plan"_s);
        QVERIFY(list.currentItem() != nullptr);
        QCOMPARE(list.currentItem()->text(0), u"Plan"_s);
        QVERIFY(text.toPlainText().contains(u"The order of each UAV"_s));
        window.showPlace(u"start"_s);
        QCOMPARE(list.currentItem()->text(0), u"First flight"_s);
        test::child<QAction>(window, u"manualBack"_s).trigger();
        QCOMPARE(window.place(), u"window#plan"_s);
        test::child<QAction>(window, u"manualForward"_s).trigger();
        QCOMPARE(window.place(), u"start"_s);
        const int size = text.font().pointSize();
        test::child<QAction>(window, u"manualLarger"_s).trigger();
        QCOMPARE(text.font().pointSize(), size + 1);
    }

    void searchResultsAreListed()
    {
        ManualWindow window(nullptr);
        window.show();
        window.showPlace(u"start"_s);
        auto& field = test::child<QLineEdit>(window, u"manualSearch"_s);
        const auto& list = test::child<QTreeWidget>(window, u"manualList"_s);
        const auto& text = test::child<QTextBrowser>(window, u"manualText"_s);
        const auto& found = test::child<QLabel>(window, u"manualFound"_s);
        field.setText(u"acknowledge"_s);
        QCOMPARE(list.topLevelItemCount(), 1);
        QCOMPARE(list.topLevelItem(0)->text(0), u"Alarms"_s);
        QVERIFY(list.topLevelItem(0)->child(0)->text(0).contains(u"Acknowledge removes"_s));
        QTest::keyClick(&field, Qt::Key_Return);
        QVERIFY(window.place().startsWith(u"window#block-"_s));
        QCOMPARE(text.extraSelections().size(), 1);
        field.setText(u"xyzzy"_s);
        QCOMPARE(list.topLevelItemCount(), 0);
        QCOMPARE(found.text(), u"Not found"_s);
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        QTest::keyClick(&field, Qt::Key_Escape);
        QCOMPARE(list.topLevelItemCount(), int(kManualChapters.size()));
    }

    /** Also those far down in a table. */
    void lineFoundIsInView()
    {
        ManualWindow window(nullptr);
        window.resize(900, 500);
        window.show();
        const auto& text = test::child<QTextBrowser>(window, u"manualText"_s);
        auto& field = test::child<QLineEdit>(window, u"manualSearch"_s);
        field.setText(u"planner.planning_delay_s"_s);
        QTest::keyClick(&field, Qt::Key_Return);
        QVERIFY(window.place().startsWith(u"fields#block-"_s));
        QVERIFY(text.textCursor().block().text().contains(field.text()));
        QVERIFY(text.viewport()->rect().contains(text.cursorRect().center()));
    }

    /** Web pages whose links all lead somewhere, and a PDF; the same bytes each time. */
    void pagesAreWritten()
    {
        const QTemporaryDir folder;
        QImage(64, 32, QImage::Format_RGB32).save(folder.filePath(u"window.png"_s));
        const QStringList paths = writeManual(folder.path());
        const auto textOf = [&](const QString& name) {
            QFile file(folder.filePath(name));
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        QCOMPARE(paths.size(), manualFileNames().size());
        const QByteArray pdf = textOf(u"manual.pdf"_s);
        QVERIFY(pdf.startsWith("%PDF"));
        QVERIFY(textOf(u"start.html"_s).contains("<img src=\"window.png\""));
        QVERIFY(!textOf(u"window.html"_s).contains("<img")); // zeta.png is not there
        static const QRegularExpression link(u"href=\"([^\"#]*)(?:#([^\"]*))?\""_s);
        int links = 0;
        for (const QString& path : paths) {
            const QString name = QFileInfo(path).fileName();
            const QString text = QString::fromUtf8(textOf(name));
            for (auto it = link.globalMatch(text); name != u"manual.pdf"_s && it.hasNext();
                 ++links) {
                const QRegularExpressionMatch match = it.next();
                const QByteArray target =
                    textOf(match.captured(1).isEmpty() ? name : match.captured(1));
                QVERIFY2(!target.isEmpty(), qPrintable(name + u": "_s + match.captured(0)));
                if (!match.captured(2).isEmpty())
                    QVERIFY2(target.contains("<a name=\"" + match.captured(2).toUtf8() + '"'),
                             qPrintable(name + u": "_s + match.captured(0)));
            }
        }
        QVERIFY(links > 200);
        writeManual(folder.path());
        QVERIFY(textOf(u"manual.pdf"_s) == pdf);
    }

    /** From the last line to the first, and back. */
    void stepsGoRound()
    {
        ManualWindow window(nullptr);
        window.show();
        auto& field = test::child<QLineEdit>(window, u"manualSearch"_s);
        const auto& list = test::child<QTreeWidget>(window, u"manualList"_s);
        field.setText(u"zeta"_s);
        auto& next = test::child<QAction>(window, u"manualNext"_s);
        next.trigger();
        const QTreeWidgetItem* first = list.currentItem();
        QCOMPARE(first, list.topLevelItem(0)->child(0));
        test::child<QAction>(window, u"manualPrevious"_s).trigger();
        QVERIFY(list.currentItem() != first);
        next.trigger();
        QCOMPARE(list.currentItem(), first);
    }
};

QTEST_MAIN(TestManual)
#include "tst_manual.moc"
