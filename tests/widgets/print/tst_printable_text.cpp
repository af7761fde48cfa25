#include "widgets/print/printable_text.h"

#include <QtTest>

using namespace berg;
using namespace Qt::StringLiterals;

class TestPrintableText : public QObject
{
    Q_OBJECT

private slots:
    /** A name must neither turn itself nor the sentence around it. */
    void namesInHtmlTurnNothing()
    {
        const QString turned =
            u"<p>Deviates at <bdi>\u202Eevil 12</bdi> and <bdi>a&amp;b</bdi>.</p>"_s;
        QCOMPARE(QString::fromStdString(withPrintableNames(turned.toStdString())),
                 u"<p>Deviates at evil 12 and a&amp;b.</p>"_s);
        const QString hebrew = u"<bdi>\u05D0\u05D1</bdi> 12"_s;
        QCOMPARE(QString::fromStdString(withPrintableNames(hebrew.toStdString())),
                 u"\u2068\u05D0\u05D1\u2069 12"_s);
    }

    void otherHtmlStays()
    {
        for (const char* html : {"", "<p>text</p>", "<bdi>never closed", "</bdi> never opened"})
            QCOMPARE(withPrintableNames(html), std::string(html));
    }
};

QTEST_APPLESS_MAIN(TestPrintableText)
#include "tst_printable_text.moc"
