#include "core/io/files/scenario_json.h"
#include "core/io/text/atomic_file.h"
#include "core/presets/presets.h"
#include "tests/support/expect_error.h"
#include "widgets/document/recovery_store.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

void write(const QString& path, const QByteArray& content)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(content), content.size());
}

} // namespace

class TestRecoveryStore : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> m_dir;

    [[nodiscard]] RecoveryStore store() const
    {
        return RecoveryStore(m_dir->filePath(u"recovery"_s));
    }
    [[nodiscard]] QStringList names() const
    {
        return QDir(m_dir->filePath(u"recovery"_s))
            .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }
    /** Leaves a recovery as a killed program does. */
    RecoveryFiles leave(std::int64_t seed, const RecoveryInfo& info = {}) const
    {
        const HeldRecovery held = store().add();
        writeRecovery(held.files, randomScenario(seed, {.icebergs = 3}), info);
        return held.files;
    }

private slots:
    void init() { m_dir = std::make_unique<QTemporaryDir>(); }

    void emptyFolderHasNoRecoveries()
    {
        const FoundRecoveries found = store().abandoned();
        QVERIFY(found.usable.empty());
        QVERIFY(found.damaged.isEmpty());
        QVERIFY(names().isEmpty());
    }

    void everythingComesBack()
    {
        const RecoveryInfo info{.name = u"Grøn\u0142and \"7\""_s,
                                .originalPath = u"/srv/ice/a b.berg"_s,
                                .edited = QDateTime({2026, 3, 29}, {1, 30, 7, 250}),
                                .pid = 4711,
                                .host = u"fram"_s};
        Scenario scenario = randomScenario(5, {.icebergs = 40});
        scenario.name = info.name.toStdString();
        {
            const HeldRecovery held = store().add();
            writeRecovery(held.files, scenario, info);
        }
        const FoundRecoveries found = store().abandoned();
        QCOMPARE(found.usable.size(), 1U);
        QVERIFY(found.usable[0].scenario == scenario); // bit for bit
        QCOMPARE(found.usable[0].info.name, info.name);
        QCOMPARE(found.usable[0].info.originalPath, info.originalPath);
        QCOMPARE(found.usable[0].info.edited, info.edited);
        QCOMPARE(found.usable[0].info.pid, info.pid);
        QCOMPARE(found.usable[0].info.host, info.host);
    }

    void oneInUseIsLeftAlone()
    {
        const HeldRecovery held = store().add();
        writeRecovery(held.files, randomScenario(1), {});
        QVERIFY(store().abandoned().usable.empty());
    }

    /** Only one of two programs started together offers it; if declined, it is offered again. */
    void isOfferedOnce()
    {
        leave(1);
        {
            const FoundRecoveries first = store().abandoned();
            QCOMPARE(first.usable.size(), 1U);
            QVERIFY(store().abandoned().usable.empty());
        }
        QCOMPARE(store().abandoned().usable.size(), 1U);
    }

    void newestComesFirst()
    {
        const QDateTime noon({2026, 5, 1}, {12, 0});
        leave(1, {.edited = noon});
        leave(2, {.edited = noon.addSecs(60)});
        leave(3, {.edited = noon.addSecs(-60)});
        const FoundRecoveries found = store().abandoned();
        QCOMPARE(found.usable.size(), 3U);
        QCOMPARE(found.usable[0].scenario.seed, 2);
        QCOMPARE(found.usable[1].scenario.seed, 1);
        QCOMPARE(found.usable[2].scenario.seed, 3);
    }

    void damagedScenarioIsSetAside_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("cut") << QByteArray("{\"format\": \"bergwatch-scenario\", \"vers");
        QTest::newRow("binary") << QByteArray("\0\xFF\x80\r", 4);
        QTest::newRow("another format") << QByteArray("{\"format\": \"bergwatch-run\"}");
        QTest::newRow("no icebergs")
            << QByteArray("{\"format\": \"bergwatch-scenario\", \"version\": 1}");
    }
    void damagedScenarioIsSetAside()
    {
        QFETCH(QByteArray, content);
        const RecoveryFiles broken = leave(1);
        write(broken.scenario(), content);
        leave(2);
        const FoundRecoveries found = store().abandoned();
        QCOMPARE(found.usable.size(), 1U);
        QCOMPARE(found.usable[0].scenario.seed, 2);
        QCOMPARE(found.damaged, QStringList{broken.scenario() + u".damaged"_s});
        QFile aside(found.damaged[0]);
        QVERIFY(aside.open(QIODevice::ReadOnly));
        QCOMPARE(aside.readAll(), content);
        QVERIFY(store().abandoned().damaged.isEmpty()); // reported once
    }

    void damagedInfoDoesNotMatter_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("binary") << QByteArray("\0\xFF\x80\r", 4);
        QTest::newRow("of other types") << QByteArray(
            "{\"original_path\": 7, \"edited_utc\": [1], \"pid\": \"x\", \"host\": null}");
    }
    void damagedInfoDoesNotMatter()
    {
        QFETCH(QByteArray, content);
        const RecoveryFiles files = leave(1, {.originalPath = u"/a.berg"_s});
        write(files.info(), content);
        const FoundRecoveries found = store().abandoned();
        QCOMPARE(found.usable.size(), 1U);
        QCOMPARE(found.usable[0].info.name.toStdString(), found.usable[0].scenario.name);
        QVERIFY(found.usable[0].info.originalPath.isEmpty());
        QCOMPARE(found.usable[0].info.edited, QFileInfo(files.scenario()).lastModified());
    }

    /** The program was killed before anything was written: nothing is offered or left. */
    void whatIsEmptyGoes()
    {
        const RecoveryFiles files = leave(1);
        QVERIFY(QFile::remove(files.scenario()));
        const QString folder = m_dir->filePath(u"recovery/"_s);
        write(files.lock(), "4711\nfram\n");
        write(folder + u'.' + files.id + u".berg.99-0.tmp"_s, "half");
        const HeldRecovery held = store().add(); // about to be written
        QVERIFY(store().abandoned().usable.empty());
        QCOMPARE(names(), QStringList{QFileInfo(held.files.lock()).fileName()});
    }

    void removedWithAllThatBelongsToIt()
    {
        leave(1);
        const RecoveryFiles files = leave(2);
        const QString folder = m_dir->filePath(u"recovery/"_s);
        write(folder + u'.' + files.id + u".berg.99-0.tmp"_s,
              "half"); // of a writer that was killed
        removeRecovery(files);
        const FoundRecoveries found = store().abandoned();
        QCOMPARE(found.usable.size(), 1U);
        QCOMPARE(found.usable[0].scenario.seed, 1);
        QVERIFY(names().filter(files.id).isEmpty());
    }

    void folderThatCannotBeMade()
    {
        write(m_dir->filePath(u"recovery"_s), "a file in its place");
        QCOMPARE(codeOf([&] { (void)store().add(); }), std::string("FileUnwritable"));
        QVERIFY(store().abandoned().usable.empty());
    }
};

QTEST_GUILESS_MAIN(TestRecoveryStore)
#include "tst_recovery_store.moc"
