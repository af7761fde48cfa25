#include "core/io/text/xml_reader.h"
#include "tests/support/expect_error.h"

#include <QtTest>

#include <stdexcept>

using namespace berg;
using namespace berg::test;

namespace {

void readEvents(const std::string& text, const XmlEvents& events)
{
    ReadBudget budget("file", text.size());
    readXml(text, events, budget);
}

/** Returns "name@line=text" of each element when it is closed. */
QStringList elementsOf(const std::string& text)
{
    QStringList elements;
    readEvents(text,
               {.opened = {}, .closed = [&](XmlPath path) {
                    const XmlElement& element = path.back();
                    elements.append(QString::fromStdString(
                        element.name + '@' + std::to_string(element.line) + '=' + element.text));
                }});
    return elements;
}

std::string nested(int depth)
{
    std::string text;
    for (int i = 0; i < depth; ++i)
        text += "<a>";
    for (int i = 0; i < depth; ++i)
        text += "</a>";
    return text;
}

} // namespace

class TestXmlReader : public QObject
{
    Q_OBJECT

private slots:
    void elementsAreReported()
    {
        QCOMPARE(elementsOf("<r>\n<b>x<c/>y</b>\n</r>"),
                 (QStringList{"c@2=", "b@2=xy", "r@1=\n\n"}));
        QCOMPARE(elementsOf("<r xmlns:g=\"u\"><g:b>&lt;&#248;</g:b></r>"),
                 (QStringList{QString::fromUtf8("b@1=<\xC3\xB8"), "r@1="}));
        QCOMPARE(elementsOf("<r><![CDATA[a<b]]></r>"), QStringList{"r@1=a<b"});
    }

    void blanksBeforeTheDeclarationAreSkipped()
    {
        QCOMPARE(elementsOf("\n\n  <?xml version=\"1.0\"?>\n<r/>"), QStringList{"r@4="});
        QCOMPARE(elementsOf("\xEF\xBB\xBF\r\n<?xml version=\"1.0\" encoding=\"UTF-8\"?><r/>"),
                 QStringList{"r@2="});
    }

    void undeclaredPrefixesAreDropped()
    {
        QCOMPARE(elementsOf("<a:r><b:c d:e=\"f\"/></a:r>"), (QStringList{"c@1=", "r@1="}));
    }

    void declaredEncodingsAreRead()
    {
        const QStringList expected{QString::fromUtf8("r@1=\xC3\xB8")};
        QCOMPARE(elementsOf("<?xml version='1.0' encoding='ISO-8859-1'?><r>\xF8</r>"), expected);
        QCOMPARE(elementsOf("<?xml version='1.0' encoding='ISO-8859-1'?><r>\xC3\xB8</r>"),
                 expected);
    }

    void attributesAreFound()
    {
        std::string value;
        std::string missing = "?";
        readEvents("<r xmlns:g='u' g:x='1 &amp; 2'/>", {.opened =
                                                            [&](XmlPath path) {
                                                                value = path.back().attribute("x");
                                                                missing =
                                                                    path.back().attribute("y");
                                                            },
                                                        .closed = {}});
        QCOMPARE(value, std::string("1 & 2"));
        QCOMPARE(missing, std::string());
    }

    void brokenTextIsRejected_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("says");
        const auto row = [](const char* name, const std::string& text, const char* says) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(says);
        };
        row("empty", "", "line 1");
        row("unclosed", "<a>\n<b>\n</a>", "line 3");
        row("two roots", "<a/><b/>", "line 1");
        row("no XML", "hello", "line 1");
        row("control character", "<a>\x01</a>", "line 1");
        row("half a character", "<a>\xC3</a>", "line 1");
        row("unknown entity", "<a>&x;</a>", "line 1");
        row("deep", nested(65), "deeper than 64");
        row("bomb", "<!DOCTYPE a [<!ENTITY b \"bbbb\"><!ENTITY c \"&b;&b;&b;&b;\">]><a>&c;&c;</a>",
            "DOCTYPE");
        row("outside entity", "<!DOCTYPE a SYSTEM \"file:///etc/passwd\"><a/>", "DOCTYPE");
    }

    void brokenTextIsRejected()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, says);
        const std::optional<Error> error = errorOf([&] { (void)elementsOf(text.toStdString()); });
        QVERIFY(error && error->code() == ErrorCode::SyntaxError);
        QVERIFY2(QByteArray(error->what()).contains(says), error->what());
    }

    void depthOf64IsAllowed() { QCOMPARE(elementsOf(nested(64)).size(), 64); }

    void exceptionsOfCallbacksPass()
    {
        int calls = 0;
        const XmlEvents events{.opened =
                                   [&](XmlPath) {
                                       ++calls;
                                       throw std::logic_error("mine");
                                   },
                               .closed = {}};
        QVERIFY_THROWS_EXCEPTION(std::logic_error, readEvents("<a><b/></a>", events));
        QCOMPARE(calls, 1);
    }

    /** The text is longer than one piece of the parser, so pieces split tags. */
    void longTextIsReadInPieces()
    {
        std::string text = "<r>";
        for (int i = 0; i < 200'000; ++i)
            text += "<point>12</point>\n";
        text += "</r>";
        std::size_t points = 0;
        std::size_t lastLine = 0;
        readEvents(text, {.opened = {}, .closed = [&](XmlPath path) {
                              if (path.size() == 2 && path.back().text == "12") {
                                  ++points;
                                  lastLine = path.back().line;
                              }
                          }});
        QCOMPARE(points, std::size_t{200'000});
        QCOMPARE(lastLine, std::size_t{200'000});
    }
};

QTEST_APPLESS_MAIN(TestXmlReader)
#include "tst_xml_reader.moc"
