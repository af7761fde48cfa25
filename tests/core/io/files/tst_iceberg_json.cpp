#include "core/io/files/iceberg_json.h"
#include "tests/support/flight/random_scenario.h"

#include <QtTest>

using namespace berg;

class TestIcebergJson : public QObject
{
    Q_OBJECT

private slots:
    void everyFieldIsReadBack()
    {
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            const Scenario scenario = test::AnyScenario(seed).draw();
            const std::string text = icebergsToJson(scenario.icebergs);
            QVERIFY(icebergsFromJson(text, "text") == scenario.icebergs);
            QVERIFY(text == icebergsToJson(icebergsFromJson(text, "text")));
        }
    }

    /** The program that inserts them gives them new ids. */
    void idsMayBeEmptyOrEqual()
    {
        const std::vector<Iceberg> icebergs = icebergsFromJson(
            R"({"format":"bergwatch-icebergs","version":1,"icebergs":[
                {"id":"a","position_m":[1,2]},{"id":"a","position_m":[3,4]},{"position_m":[5,6]}]})",
            "text");
        QCOMPARE(icebergs.size(), std::size_t{3});
        QCOMPARE(icebergs[1].id, std::string("a"));
        QVERIFY(icebergs[2].id.empty());
    }

    /** A scenario file is not an object of this format. */
    void faultsAreNamed_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("code");
        QTest::addColumn<QByteArray>("field");
        const QByteArray begin = R"({"format":"bergwatch-icebergs","version":1,"icebergs":)";
        const auto row = [](const char* name, const QByteArray& text, ErrorCode code,
                            const char* field) {
            QTest::newRow(name) << text << static_cast<int>(code) << QByteArray(field);
        };
        row("scenario", R"({"format":"bergwatch-scenario","version":1})", ErrorCode::WrongFormat,
            "format");
        row("version", R"({"format":"bergwatch-icebergs","version":2,"icebergs":[]})",
            ErrorCode::UnsupportedVersion, "version");
        row("no list", R"({"format":"bergwatch-icebergs","version":1})", ErrorCode::InvalidInput,
            "icebergs");
        row("no position", begin + R"([{"id":"a"}]})", ErrorCode::InvalidInput,
            "icebergs[0].position_m");
        row("range", begin + R"([{"position_m":[0,0]},{"position_m":[0,-1e7]}]})",
            ErrorCode::InvalidInput, "icebergs[1].position_m[1]");
        row("sigma", begin + R"([{"position_m":[0,0],"sigma0_m2":-1}]})", ErrorCode::InvalidInput,
            "icebergs[0].sigma0_m2");
        row("syntax", begin + "[", ErrorCode::SyntaxError, "");
        row("long", begin + QByteArray(static_cast<qsizetype>(kLargestIcebergText), ' ') + "[]}",
            ErrorCode::FileTooLarge, "");
    }

    void faultsAreNamed()
    {
        QFETCH(QByteArray, text);
        QFETCH(int, code);
        QFETCH(QByteArray, field);
        try {
            (void)icebergsFromJson(text.toStdString(), "clipboard");
            QFAIL("read");
        } catch (const Error& error) {
            QCOMPARE(static_cast<int>(error.code()), code);
            QCOMPARE(error.subject(), std::string("clipboard"));
            if (!field.isEmpty())
                QCOMPARE(error.issues().front().field, field.toStdString());
        }
    }
};

QTEST_APPLESS_MAIN(TestIcebergJson)
#include "tst_iceberg_json.moc"
