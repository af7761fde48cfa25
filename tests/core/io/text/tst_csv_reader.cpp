#include "core/io/text/csv_reader.h"

#include <QtTest>

using namespace berg;

namespace {

using Cells = std::vector<std::string>;

std::vector<CsvRow> rowsOf(const std::string& text, char separator = ',')
{
    CsvReader reader(text, separator);
    std::vector<CsvRow> rows;
    CsvRow row;
    while (reader.next(row))
        rows.push_back(row);
    return rows;
}

} // namespace

class TestCsvReader : public QObject
{
    Q_OBJECT

private slots:
    void cellsAreSplit_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QStringList>("cells");
        const auto row = [](const char* name, const char* text, const QStringList& cells) {
            QTest::newRow(name) << QByteArray(text) << cells;
        };
        row("plain", "a,b,c", {"a", "b", "c"});
        row("empty cells", ",b,", {"", "b", ""});
        row("quoted", R"("a","b c",d)", {"a", "b c", "d"});
        row("separator in quotes", R"("a,b",c)", {"a,b", "c"});
        row("doubled quotes", R"("a ""b""","""",c)", {"a \"b\"", "\"", "c"});
        row("empty quotes", R"("",b)", {"", "b"});
        row("quote inside", "a\"b\",c", {"a\"b\"", "c"});
        row("line end in quotes", "\"a\r\nb\",c", {"a\r\nb", "c"});
        row("blanks are kept", " a , b ", {" a ", " b "});
        row("byte order mark",
            "\xEF\xBB\xBF"
            "a,b",
            {"a", "b"});
        row("final line end", "a,b\r\n", {"a", "b"});
    }

    void cellsAreSplit()
    {
        QFETCH(QByteArray, text);
        QFETCH(QStringList, cells);
        const std::vector<CsvRow> rows = rowsOf(text.toStdString());
        QCOMPARE(rows.size(), std::size_t{1});
        QVERIFY(rows[0].fault == CsvRow::Fault::None);
        QStringList got;
        for (const std::string& cell : rows[0].cells)
            got.append(QString::fromStdString(cell));
        QCOMPARE(got, cells);
    }

    /** Lines are counted through blank and quoted ones and any kind of line end. */
    void lineNumbers_data()
    {
        QTest::addColumn<QByteArray>("end");
        QTest::newRow("LF") << QByteArray("\n");
        QTest::newRow("CRLF") << QByteArray("\r\n");
        QTest::newRow("CR") << QByteArray("\r");
    }

    void lineNumbers()
    {
        QFETCH(QByteArray, end);
        QByteArray text = "h\n\na,\"x\ny\n\",b\nlast";
        text.replace("\n", end);
        const std::vector<CsvRow> rows = rowsOf(text.toStdString());
        QCOMPARE(rows.size(), std::size_t{3});
        QCOMPARE(rows[0].line, std::size_t{1});
        QCOMPARE(rows[1].line, std::size_t{3});
        QCOMPARE(rows[2].line, std::size_t{6});
        QVERIFY(rows[2].cells == Cells{"last"});
    }

    void strayQuoteCostsOneRow()
    {
        const std::vector<CsvRow> rows = rowsOf("a,b\n\"c,d\ne,f\n\"g\",h\n");
        QCOMPARE(rows.size(), std::size_t{4});
        QVERIFY(rows[1].fault == CsvRow::Fault::TextAfterQuote); // the next quote is that of g
        QCOMPARE(rows[1].line, std::size_t{2});
        QVERIFY(rows[1].cells.empty());
        QVERIFY(rows[2].cells == (Cells{"e", "f"}));
        QVERIFY(rows[3].cells == (Cells{"g", "h"}));
        QCOMPARE(rows[3].line, std::size_t{4});
    }

    void quoteOpenAtTheEndIsAFault()
    {
        const std::vector<CsvRow> rows = rowsOf("a,b\nc,\"d\ne,f");
        QCOMPARE(rows.size(), std::size_t{3});
        QVERIFY(rows[1].fault == CsvRow::Fault::UnclosedQuote);
        QVERIFY(rows[2].cells == (Cells{"e", "f"}));
        QCOMPARE(rowsOf("\"").size(), std::size_t{1});
    }

    void emptyTextHasNoRows()
    {
        QVERIFY(rowsOf("").empty());
        QVERIFY(rowsOf("\n\r\n\r").empty());
        QVERIFY(rowsOf("\xEF\xBB\xBF").empty());
    }

    void cellsBeyondTheLimitAreNotKept()
    {
        const std::vector<CsvRow> rows = rowsOf(std::string(3 * kMostCells, ',') + "\na,b");
        QCOMPARE(rows.size(), std::size_t{2});
        QCOMPARE(rows[0].cells.size(), kMostCells);
        QVERIFY(rows[1].cells == (Cells{"a", "b"}));
    }

    /** Many quotes that seem open must not make reading quadratic. */
    void millionsOfQuotesAreFast()
    {
        std::string text;
        for (int i = 0; i < 400'000; ++i)
            text += "a,\"\"\n";
        text += '"';
        for (int i = 0; i < 400'000; ++i)
            text += "b,\"\"\n";
        QCOMPARE(rowsOf(text).size(), std::size_t{800'000});
    }

    /**
     * Each line opens a quote that stays open to the end, which was once read again for each line.
     */
    void millionsOfStrayQuotesAreFast()
    {
        std::string text = "lat,lon\n\"several\nlines\",b\n";
        for (int i = 0; i < 1'000'000; ++i)
            text += "a\",\"\n";
        const std::vector<CsvRow> rows = rowsOf(text);
        QVERIFY(rows[1].cells == (Cells{"several\nlines", "b"}));
        QVERIFY(rows.size() > 100'000);
        QVERIFY(rows.back().fault == CsvRow::Fault::UnclosedQuote);
    }

    void mostFrequentSeparatorIsChosen_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<char>("separator");
        QTest::newRow("comma") << QByteArray("a,b;c,d") << ',';
        QTest::newRow("semicolon") << QByteArray("a;b;c\n1,2;3,4;5,6") << ';';
        QTest::newRow("tab") << QByteArray("a\tb\n1,2,3\t4") << '\t';
        QTest::newRow("in quotes") << QByteArray("\"a;b;c\",d") << ',';
        QTest::newRow("second line") << QByteArray("title\na;b") << ';';
        QTest::newRow("none") << QByteArray("a") << ',';
    }

    void mostFrequentSeparatorIsChosen()
    {
        QFETCH(QByteArray, text);
        QFETCH(char, separator);
        QCOMPARE(csvSeparator(text.toStdString()), separator);
    }
};

QTEST_APPLESS_MAIN(TestCsvReader)
#include "tst_csv_reader.moc"
