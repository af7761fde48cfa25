#include "core/io/files/problem_json.h"
#include "core/io/files/run_json.h"
#include "core/io/files/scenario_json.h"
#include "core/io/text/atomic_file.h"
#include "tests/support/expect_error.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace berg;
using namespace berg::test;

namespace {

const QString kFolder = QStringLiteral(BERG_TEST_DATA "/broken/");

/** A line of EXPECTED.tsv: file, error code, texts that the message contains. */
struct Row
{
    QString file;
    QString code;
    QStringList texts;
};

QList<Row> manifest()
{
    QList<Row> rows;
    QFile file(kFolder + "EXPECTED.tsv");
    if (!file.open(QIODevice::ReadOnly))
        return rows;
    for (const QByteArray& line : file.readAll().split('\n')) {
        const QStringList cells = QString::fromUtf8(line).split('\t');
        if (cells.size() == 3 && !line.startsWith('#'))
            rows.append({cells[0], cells[1], cells[2].split(" | ")});
    }
    return rows;
}

/** Reads a file in the format of its name. */
void loadByName(const QString& path)
{
    const std::string name = path.toStdString();
    if (path.endsWith(".berg"))
        (void)loadScenario(name);
    else if (path.endsWith(".json") || path.endsWith("tsp"))
        (void)loadProblem(name);
    else if (path.endsWith(".bergrun"))
        (void)loadRun(name);
    else
        QFAIL("a file of unknown kind");
}

/** Reads a file in the format of its `format` member, as the command line does. */
void loadByFormat(const QString& path)
{
    const std::string name = path.toStdString();
    const std::string text = readFile(name);
    const std::string format = formatOf(text, name);
    if (format == "bergwatch-scenario")
        (void)scenarioFromJson(text, name);
    else if (format == "bergwatch-problem")
        (void)problemFromJson(text, name);
    else
        (void)runFromJson(text, name);
}

void write(const QString& path, const std::string& text)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(text.data(), static_cast<qint64>(text.size())),
             static_cast<qint64>(text.size()));
}

const std::string kStart =
    R"({"format": "bergwatch-scenario", "version": 1, "uavs": [{"position_m": [0, 0]}], )";

} // namespace

class TestBrokenFiles : public QObject
{
    Q_OBJECT

private slots:
    void everyFileIsListed()
    {
        QStringList listed;
        for (const Row& row : manifest())
            listed.append(row.file);
        QStringList present;
        QDirIterator files(kFolder, QDir::Files, QDirIterator::Subdirectories);
        while (files.hasNext())
            present.append(QDir(kFolder).relativeFilePath(files.next()));
        present.removeOne("EXPECTED.tsv");
        listed.sort();
        present.sort();
        QCOMPARE(listed, present);
        QVERIFY(present.size() >= 45);
    }

    void brokenFilesAreRejected_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("code");
        QTest::addColumn<QStringList>("texts");
        for (const Row& row : manifest())
            QTest::newRow(row.file.toUtf8().constData()) << row.file << row.code << row.texts;
    }
    void brokenFilesAreRejected()
    {
        QFETCH(const QString, file);
        QFETCH(const QString, code);
        QFETCH(const QStringList, texts);
        const QString path = kFolder + file;
        const std::optional<Error> error = errorOf([&] { loadByName(path); });
        QVERIFY2(error, "the file was accepted");
        const QString message = QString::fromStdString(error->what());
        QCOMPARE(QString::fromStdString(codeName(error->code())), code);
        QCOMPARE(QString::fromStdString(error->subject()), path);
        QVERIFY2(!error->issues().empty(), error->what());
        QVERIFY2(message.startsWith(path + ": "), error->what());
        for (const QString& text : texts)
            QVERIFY2(!text.isEmpty() && message.contains(text), error->what());
        // A message is shown on a terminal, so it must be readable text without control characters.
        QVERIFY(QString::fromUtf8(error->what()).toUtf8() == QByteArray(error->what()));
        for (const QChar c : message)
            QVERIFY(c.isPrint() || c == '\n');
    }

    void brokenFilesAreRejectedByFormatToo_data() { brokenFilesAreRejected_data(); }
    void brokenFilesAreRejectedByFormatToo()
    {
        QFETCH(const QString, file);
        QVERIFY(errorOf([&] { loadByFormat(kFolder + file); }));
    }

    void everyBrokenFileHasOneFault_data() { brokenFilesAreRejected_data(); }
    void everyBrokenFileHasOneFault()
    {
        // Each file has one error and must give a single fault, not a series of consequences.
        QFETCH(const QString, file);
        const std::optional<Error> error = errorOf([&] { loadByName(kFolder + file); });
        QVERIFY(error);
        if (!file.contains("/many-faults") && !file.contains("/faults-"))
            QVERIFY2(error->issues().size() == 1, error->what());
    }

    void otherFormatsAreRejected_data()
    {
        QTest::addColumn<QString>("file");
        QTest::newRow("scenario") << "plain.berg";
        QTest::newRow("problem") << "small-problem.json";
        QTest::newRow("run") << "small.bergrun";
    }
    void otherFormatsAreRejected()
    {
        QFETCH(const QString, file);
        const std::string path = BERG_TEST_DATA "/scenarios/" + file.toStdString();
        const std::string own = formatOf(readFile(path), path);
        loadByName(QString::fromStdString(path)); // the unchanged file is readable
        const auto check = [&](const std::string& format, auto load) {
            if (own == format)
                return;
            const std::optional<Error> error = errorOf([&] { (void)load(path); });
            QVERIFY(error);
            QCOMPARE(codeName(error->code()), std::string("WrongFormat"));
            QVERIFY(std::string(error->what()).find(own) != std::string::npos);
        };
        check("bergwatch-scenario", [](const std::string& path) { return loadScenario(path); });
        check("bergwatch-problem", [](const std::string& path) { return loadProblem(path); });
        check("bergwatch-run", [](const std::string& path) { return loadRun(path); });
    }

    void tooLargeFileIsRejected()
    {
        const QTemporaryDir dir;
        const QString path = dir.filePath("large.berg");
        write(path, kStart + R"("icebergs": [])" + std::string(kLargestFile, ' ') + '}');
        QCOMPARE(codeOf([&] { loadByName(path); }), std::string("FileTooLarge"));
    }

    void tooManyValuesAreRejected()
    {
        // 20 million values in 40 MB would take a gigabyte of memory.
        std::string text = kStart + R"("icebergs": [], "x": [1)";
        for (int i = 0; i < 20'000'000; ++i)
            text += ",1";
        text += "]}";
        QCOMPARE(codeOf([&] { (void)scenarioFromJson(text, "x"); }), std::string("FileTooLarge"));
    }

    /** Reading so many icebergs takes more memory than their text allows. */
    void tooManyIcebergsAreRejected_data()
    {
        QTest::addColumn<int>("count");
        QTest::addColumn<QString>("reason");
        QTest::newRow("many") << 2000
                              << QStringLiteral(
                                     "x: icebergs: must hold at most 1000 entries, not 2000");
        QTest::newRow("a million") << 1'000'000 << QStringLiteral("x: would take more than");
    }
    void tooManyIcebergsAreRejected()
    {
        QFETCH(int, count);
        QFETCH(QString, reason);
        std::string text = kStart + R"("icebergs": [{"position_m": [1, 2]})";
        for (int i = 1; i < count; ++i)
            text += R"(,{"position_m": [1, 2]})";
        text += "]}";
        const std::optional<Error> error = errorOf([&] { (void)scenarioFromJson(text, "x"); });
        QVERIFY(error);
        QVERIFY2(QString::fromUtf8(error->what()).startsWith(reason), error->what());
    }

    void manyUnknownMembersAreKeptInReasonableTime()
    {
        // Quadratic handling of 200,000 names would take minutes.
        std::string text = kStart + R"("icebergs": [])";
        for (int i = 0; i < 200'000; ++i)
            text += ", \"x" + std::to_string(i) + "\": 1";
        text += '}';
        const Scenario scenario = scenarioFromJson(text, "x");
        QVERIFY(scenarioFromJson(scenarioToJson(scenario), "x") == scenario);
    }

    void everyPrefixOfAFileIsRejected()
    {
        const std::string text = readFile(BERG_TEST_DATA "/scenarios/small.bergrun");
        const std::size_t end = text.find_last_of('}');
        for (std::size_t size = 0; size <= end; ++size)
            QCOMPARE(codeOf([&] { (void)runFromJson(text.substr(0, size), "x"); }),
                     std::string("SyntaxError"));
    }

    void damagedBytesNeverCrash()
    {
        // Replaces each byte in turn by several others; the file is read, or rejected with an
        // `Error`.
        for (const char* name : {"every-field.berg", "small-problem.json", "small.bergrun"}) {
            const std::string path = std::string(BERG_TEST_DATA "/scenarios/") + name;
            const std::string text = readFile(path);
            for (std::size_t i = 0; i < text.size(); ++i)
                for (const char byte : {'\0', '"', '-', '9', '}', ',', '\xFF'}) {
                    std::string damaged = text;
                    damaged[i] = byte;
                    const std::optional<Error> error = errorOf([&] {
                        if (path.ends_with(".berg"))
                            (void)scenarioFromJson(damaged, "x");
                        else if (path.ends_with(".json"))
                            (void)problemFromJson(damaged, "x");
                        else
                            (void)runFromJson(damaged, "x");
                    });
                    QVERIFY(!error || !error->issues().empty());
                }
        }
    }
};

QTEST_APPLESS_MAIN(TestBrokenFiles)
#include "tst_broken_files.moc"
