#include "core/io/text/atomic_file.h"
#include "tests/support/expect_error.h"
#include "widgets/theme/picture_page.h"

#include <QPainter>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>

#include <time.h>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

const QColor kInk(0x17, 0x69, 0xaa);

/** A disk and a word. */
PicturePage page(const QString& word = u"berg-1"_s)
{
    return {.size_px = QSize(300, 200),
            .title = word,
            .description = word,
            .paint = [word](QPainter& painter) {
                painter.setPen(Qt::NoPen);
                painter.setBrush(kInk);
                painter.drawEllipse(QPointF(100, 100), 50, 50);
                painter.setPen(Qt::black);
                painter.drawText(QPointF(200, 100), word);
            }};
}

QByteArray fileOf(const PicturePage& picture, const char* ending)
{
    return QByteArray::fromStdString(pictureFile(picture, QString::fromLatin1(ending)));
}

/** Returns whether `image` shows the disk on white. */
bool hasDiskOnWhite(const QImage& image)
{
    const auto at = [&](double x, double y) {
        return image.pixelColor(int(x / 300 * image.width()), int(y / 200 * image.height()));
    };
    return at(100, 100) == kInk && at(5, 5) == QColor(Qt::white) &&
           at(295, 195) == QColor(Qt::white);
}

QImage rendered(const QByteArray& svg)
{
    QSvgRenderer renderer(svg);
    QImage image(renderer.viewBox().size(), QImage::Format_ARGB32);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    renderer.render(&painter);
    return image;
}

} // namespace

class TestPicturePage : public QObject
{
    Q_OBJECT

private slots:
    void imageHasItsScale()
    {
        const QImage image = pictureImage(page(), 1.5);
        QCOMPARE(image.size(), QSize(450, 300));
        QCOMPARE(image.devicePixelRatio(), 1.5);
        QVERIFY(hasDiskOnWhite(image));
    }

    void pngHasTwoPixelsForEachOfTheLayout()
    {
        const QImage image = QImage::fromData(fileOf(page(), "png"), "PNG");
        QCOMPARE(image.size(), QSize(600, 400));
        QVERIFY(hasDiskOnWhite(image));
    }

    void svgHasItsSizeAndAGround()
    {
        const QByteArray svg = fileOf(page(), "svg");
        QVERIFY(svg.contains("viewBox=\"0 0 300 200\""));
        QVERIFY(svg.contains("<title>berg-1</title>"));
        QVERIFY(hasDiskOnWhite(rendered(svg)));
    }

    void pdfIsOnePageWithoutADate()
    {
        const QByteArray pdf = fileOf(page(), "pdf");
        QVERIFY(pdf.startsWith("%PDF-"));
        QCOMPARE(pdf.count("/MediaBox [0 0 225.0"), 1); // 300 px at 96 to the inch
        QVERIFY(pdf.contains("/CreationDate (D:20000101000000"));
        QVERIFY(pdf.contains("/Count 1"));
    }

    void samePageGivesTheSameBytes_data()
    {
        QTest::addColumn<QString>("ending");
        for (const char* ending : kPictureEndings)
            QTest::newRow(ending) << QString::fromLatin1(ending);
    }

    void samePageGivesTheSameBytes()
    {
        QFETCH(QString, ending);
        const std::string first = pictureFile(page(), ending);
        QVERIFY(pictureFile(page(), ending) == first);
        QVERIFY(pictureFile(page(u"other"_s), ending) != first);
    }

    void filesHaveThePictureOfTheirEnding_data() { samePageGivesTheSameBytes_data(); }

    void filesHaveThePictureOfTheirEnding()
    {
        QFETCH(QString, ending);
        const QTemporaryDir folder;
        for (const QString& name : {u"a."_s + ending, u"b.c."_s + ending.toUpper()}) {
            writePicture(page(), folder.filePath(name));
            QVERIFY(readFile(folder.filePath(name).toStdString()) == pictureFile(page(), ending));
        }
    }

    void otherEndingsAreUnsupported_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"chart.gif", "chart", "chart.png.txt", ".png2"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }

    void otherEndingsAreUnsupported()
    {
        QFETCH(QString, name);
        const QTemporaryDir folder;
        const QString path = folder.filePath(name);
        const std::optional<Error> error = errorOf([&] { writePicture(page(), path); });
        QVERIFY(error.has_value());
        QCOMPARE(error->code(), ErrorCode::Unsupported);
        QCOMPARE(QString::fromStdString(error->subject()), path);
        QVERIFY(!QFile::exists(path));
    }

    void missingFolderIsReported()
    {
        const std::optional<Error> error =
            errorOf([] { writePicture(page(), u"/nowhere/at/all.png"_s); });
        QVERIFY(error.has_value());
        QCOMPARE(error->code(), ErrorCode::FileUnwritable);
    }

    void namesCannotBreakAnSvg()
    {
        const QString name = u"<a> & \"b\" \x01\x0b\x1f\uFFFE]]> \U0001F9CA"_s;
        const QByteArray svg = fileOf(page(name), "svg");
        QXmlStreamReader xml(svg);
        QString title;
        QString texts;
        while (!xml.atEnd()) {
            xml.readNext();
            if (xml.isStartElement() && xml.name() == u"title"_s)
                title = xml.readElementText();
            else if (xml.isStartElement() && xml.name() == u"text"_s)
                texts += xml.readElementText();
        }
        QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
        QCOMPARE(title, u"<a> & \"b\" ]]> \U0001F9CA"_s);
        QVERIFY2(texts.contains(u"<a> & \"b\""_s), qPrintable(texts));
    }

    /** Qt writes the time with its zone, which is of another length in each. */
    void pdfIsTheSameInEveryTimeZone()
    {
        const QByteArray before = qgetenv("TZ");
        const auto back = qScopeGuard([&before] {
            before.isNull() ? qunsetenv("TZ") : qputenv("TZ", before);
            ::tzset();
        });
        QList<QByteArray> files;
        for (const char* zone : {"UTC", "Europe/Oslo", "XYZ3:30"}) {
            qputenv("TZ", zone);
            ::tzset();
            files << fileOf(page(), "pdf");
        }
        QCOMPARE(files[1], files[0]);
        QCOMPARE(files[2], files[0]);
        // The table at the end gives the offsets of objects.
        const QByteArray& pdf = files[0];
        const QByteArray key = "startxref\n";
        const qsizetype at = pdf.lastIndexOf(key) + key.size();
        const qsizetype table = pdf.sliced(at, pdf.indexOf('\n', at) - at).toLongLong();
        QVERIFY(pdf.sliced(table).startsWith("xref\n"));
        int object = 0;
        for (const QByteArray& line : pdf.sliced(table).split('\n')) {
            if (!line.endsWith(" n ") && !line.endsWith(" f "))
                continue;
            if (line.endsWith(" n "))
                QVERIFY(pdf.sliced(line.first(10).toLongLong())
                            .startsWith(QByteArray::number(object) + " 0 obj"));
            ++object;
        }
        QVERIFY(object > 5);
    }
};

QTEST_MAIN(TestPicturePage)
#include "tst_picture_page.moc"
